// HDF5 files with another layout than a recording, made to lead a reader into other files, endless waiting or unlimited
// memory: refused with the object's name before a value is read. More of them: tests/attack/hostile_files.py.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>

#include <gmock/gmock.h>

#include "core/base/checksum.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "recording_damage.h"
#include "recording_samples.h"

namespace fyd::recording {
namespace {

using namespace samples;
using testing::HasSubstr;

/// What every way to a recording's rows says.
void expectRefused(const std::string& file, const std::string& words) {
  const auto opened = Recording::open(file);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().text(), HasSubstr(file));
  EXPECT_THAT(opened.error().text(), HasSubstr(words));
  const auto checked = verify(file);
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().text(), HasSubstr(words));
  const auto recovered = recover(file);
  ASSERT_TRUE(recovered) << recovered.error().text();
  EXPECT_EQ(recovered->result, RecoverResult::nothing);
  EXPECT_THAT(recovered->first_damage.text(), HasSubstr(words));
}

class RecordingLayout : public testing::Test {
 protected:
  void SetUp() override {
    anew();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  }

  void anew() const { record(file, 600); }
  void change(const std::function<void(hid_t)>& how) const { samples::change(file, how); }

  /// Another dataset of the same rows' type in a table's place.
  static void replace(hid_t id, const char* path, hsize_t rows, const std::function<void(hid_t)>& set,
                      hsize_t most = H5S_UNLIMITED) {
    const hid_t old = H5Dopen2(id, path, H5P_DEFAULT);
    const hid_t type = H5Dget_type(old);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    set(properties);
    H5Dclose(old);
    H5Ldelete(id, path, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(1, &rows, &most);
    const hid_t made = H5Dcreate2(id, path, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    EXPECT_GE(made, 0) << path;
    for (const auto& [close, what] :
         {std::pair{&H5Dclose, made}, {&H5Sclose, space}, {&H5Pclose, properties}, {&H5Tclose, type}})
      close(what);
  }

  /// The last commit says that these tables have so many rows, with a right checksum.
  static void forgeLastCommit(hid_t id, std::initializer_list<Table> tables, std::uint64_t rows) {
    const hid_t set = H5Dopen2(id, "/commits", H5P_DEFAULT);
    const hid_t type = H5Dget_type(set);
    std::array<CommitRow, 4> commits;  // at the beginning, after 250 and 500 steps, at the end
    EXPECT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, commits.data()), 0);
    CommitRow& last = commits.back();
    for (const Table table : tables) last.rows[indexOf(table)] = rows;
    last.own_crc = crc32c(std::as_bytes(std::span(&last, 1)).first(offsetof(CommitRow, own_crc)));
    EXPECT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, commits.data()), 0);
    H5Tclose(type);
    H5Dclose(set);
  }

  Folder folder;
  std::string file = folder.file();
  std::string pipe = folder.file("pipe");
};

TEST_F(RecordingLayout, ValuesInOtherFilesAreRefused) {
  write(folder.file("secret"), std::string(10'000, 's'));
  for (const std::string& source : {folder.file("secret"), pipe, std::string("/dev/zero")})
    for (const char* path : {"/notes/text", "/camera/bytes"}) {
      anew();
      change([&](hid_t id) {
        replace(
            id, path, 10'000, [&](hid_t set) { H5Pset_external(set, source.c_str(), 0, H5F_UNLIMITED); }, 10'000);
      });
      expectRefused(file, std::string(path) + ": its values lie in other files");
    }
}

TEST_F(RecordingLayout, ValuesInOtherDatasetsAreRefused) {
  change([&](hid_t id) {
    replace(id, "/camera/bytes", 100, [&](hid_t set) {
      const hsize_t rows = 100;
      const hid_t space = H5Screate_simple(1, &rows, nullptr);
      EXPECT_GE(H5Pset_virtual(set, space, pipe.c_str(), "/x", space), 0);
      H5Sclose(space);
    });
  });
  expectRefused(file, "/camera/bytes: its values lie in other datasets");
}

TEST_F(RecordingLayout, LinksAreRefusedOnEachStepOfTheWay) {
  for (const char* path : {"/telemetry", "/header", "/header/profile", "/inputs", "/inputs/steps"}) {
    for (const bool elsewhere : {false, true}) {
      anew();
      change([&](hid_t id) {
        H5Lmove(id, path, id, "/moved", H5P_DEFAULT, H5P_DEFAULT);
        const herr_t made = elsewhere ? H5Lcreate_external(pipe.c_str(), "/x", id, path, H5P_DEFAULT, H5P_DEFAULT)
                                      : H5Lcreate_soft("/moved", id, path, H5P_DEFAULT, H5P_DEFAULT);
        EXPECT_GE(made, 0);
      });
      const auto opened = Recording::open(file);
      ASSERT_FALSE(opened);
      EXPECT_THAT(opened.error().text(), HasSubstr(std::string(path) + ": a link to another place"));
    }
  }
}

TEST_F(RecordingLayout, ForeignChunksAndPackingAreRefused) {
  const auto chunks = [](hsize_t rows) { return [rows](hid_t set) { H5Pset_chunk(set, 1, &rows); }; };
  change([&](hid_t id) { replace(id, "/events", 0, chunks(1'000'000)); });
  expectRefused(file, "/events: not in chunks of 170 rows");
  anew();
  change([&](hid_t id) {
    replace(id, "/motors", 600, [&](hid_t set) {
      chunks(250)(set);
      H5Pset_deflate(set, 9);
    });
  });
  expectRefused(file, "/motors: not in chunks of 250 rows, shuffled and deflated");
}

TEST_F(RecordingLayout, MoreRowsThanTheFileCanHoldAreRefusedAtOnce) {
  for (const hsize_t rows : {hsize_t{1} << 33U, hsize_t{1} << 62U}) {
    anew();
    change([&](hid_t id) {
      const hid_t set = H5Dopen2(id, "/commits", H5P_DEFAULT);
      EXPECT_GE(H5Dset_extent(set, &rows), 0);
      H5Dclose(set);
    });
    expectRefused(file, fmt::format("/commits: {} rows of 336 bytes", rows));
    ASSERT_EQ(::truncate(file.c_str(), off_t{1} << 42U), 0);  // 4 TiB of nothing
    expectRefused(file, fmt::format("/commits: {} rows of 336 bytes", rows));
  }
}

TEST_F(RecordingLayout, ACommitThatCountsMoreStepsThanItMayIsNotTaken) {
  change([&](hid_t id) {
    const hsize_t rows = hsize_t{1} << 50U;
    for (const char* path : {"/telemetry", "/inputs/steps", "/motors"}) {
      const hid_t set = H5Dopen2(id, path, H5P_DEFAULT);
      EXPECT_GE(H5Dset_extent(set, &rows), 0);
      H5Dclose(set);
    }
    forgeLastCommit(id, {Table::telemetry, Table::steps, Table::motors}, rows);
  });
  const auto recording = Recording::open(file);
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ((*recording)->info().committed_samples, 500U);
}

TEST_F(RecordingLayout, ACommitThatCountsMoreRowsOfADamagedTableThanTheFileHasRoomForIsNotTaken) {
  for (const Table table : {Table::events, Table::notes, Table::link, Table::pictures}) {
    anew();
    haddr_t header = 0;
    change([&](hid_t id) {
      forgeLastCommit(id, {table}, std::uint64_t{1} << 50U);  // to look for each of them would take years
      H5O_info_t info;
      EXPECT_GE(H5Oget_info_by_name1(id, layoutOf(table).path, &info, H5P_DEFAULT), 0);
      header = info.addr;
    });
    flipBit(file, header + kJournalBytes + 12, 2);
    ASSERT_FALSE(Recording::open(file));
    const auto recovered = recover(file);
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(recovered->result, RecoverResult::whole) << "the commit is mended, and the table had no row";
    EXPECT_EQ(recovered->steps, 600U);
  }
}

TEST_F(RecordingLayout, ValuesThatTheFileDoesNotHoldAreRefusedBeforeTheyTakeMemory) {
  const hsize_t bytes = hsize_t{1} << 31U;
  change([&](hid_t id) {
    const hid_t space = H5Screate_simple(1, &bytes, nullptr);
    H5Dclose(H5Dcreate2(id, "/header/scene", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
  });
  EXPECT_THAT(Recording::open(file).error().text(),
              HasSubstr(fmt::format("/header/scene: says to be {} bytes, while 0 stand in the file", bytes)));
  anew();
  change([&](hid_t id) {
    H5Ldelete(id, "/header/notes", H5P_DEFAULT);
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 1'000'000);
    const hid_t space = H5Screate(H5S_SCALAR);
    H5Dclose(H5Dcreate2(id, "/header/notes", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
    H5Tclose(type);
  });
  EXPECT_THAT(Recording::open(file).error().text(),
              HasSubstr("/header/notes: says to be 1000000 bytes, while 0 stand"));
}

TEST_F(RecordingLayout, NotesWhoseTextsOverlapAreRefused) {
  ::unlink(file.c_str());
  {
    auto writer = RecordingWriter::create(file, header());
    ASSERT_TRUE(writer) << writer.error().text();
    for (const char* text : {"first", "second", "third"}) ASSERT_TRUE((*writer)->append(Note{.text = text}));
    ASSERT_TRUE((*writer)->close());
  }
  EXPECT_EQ((*Recording::open(file))->notes()->at(2).text, "third");
  const TableLayout& notes = layoutOf(Table::notes);
  const auto start = std::ranges::find(notes.columns, "text_start", &Column::name);
  ASSERT_NE(start, notes.columns.end());
  change([&](hid_t id) {
    std::vector<std::byte> rows(3 * notes.row_bytes);
    const hid_t set = H5Dopen2(id, "/notes/index", H5P_DEFAULT);
    const hid_t row = H5Dget_type(set);
    EXPECT_GE(H5Dread(set, row, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
    rows[2 * notes.row_bytes + start->offset] = std::byte{4};  // within "first"
    EXPECT_GE(H5Dwrite(set, row, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
    const hid_t commit_set = H5Dopen2(id, "/commits", H5P_DEFAULT);
    const hid_t commit = H5Dget_type(commit_set);
    std::array<CommitRow, 2> commits;  // at the beginning and at the end
    EXPECT_GE(H5Dread(commit_set, commit, H5S_ALL, H5S_ALL, H5P_DEFAULT, commits.data()), 0);
    CommitRow& last = commits.back();
    last.crc[indexOf(Table::notes)] = crc32c(rows);
    last.own_crc = crc32c(std::as_bytes(std::span(&last, 1)).first(offsetof(CommitRow, own_crc)));
    EXPECT_GE(H5Dwrite(commit_set, commit, H5S_ALL, H5S_ALL, H5P_DEFAULT, commits.data()), 0);
    for (const auto& [close, what] :
         {std::pair{&H5Dclose, set}, {&H5Dclose, commit_set}, {&H5Tclose, row}, {&H5Tclose, commit}})
      close(what);
  });
  const auto opened = Recording::open(file);
  ASSERT_TRUE(opened) << opened.error().text();
  const auto read = (*opened)->notes();
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), HasSubstr("/notes/index: row 2 says that its text begins at byte 4; expected 11"));
}

TEST_F(RecordingLayout, ColumnsThatAreNotWhatTheirNamesSayAreRefused) {
  struct Case {
    std::size_t row_bytes;
    hsize_t chunk;
    hid_t type;
    const char* words;
  };
  for (const Case& each : {Case{24, 170, H5T_IEEE_F64LE, "/notes/index: column when_ns is not of this format's type"},
                           Case{4096, 1, H5T_STD_I64LE, "/notes/index: rows of 4096 bytes; this program's have 24"},
                           Case{16, 170, H5T_STD_I64LE, "/notes/index: not in chunks of 256 rows"}}) {
    anew();
    change([&](hid_t id) {
      H5Ldelete(id, "/notes/index", H5P_DEFAULT);
      const hid_t row = H5Tcreate(H5T_COMPOUND, each.row_bytes);
      EXPECT_GE(H5Tinsert(row, "when_ns", 8, each.type), 0);
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(properties, 1, &each.chunk);
      const hsize_t none = 0;
      const hsize_t most = H5S_UNLIMITED;
      const hid_t space = H5Screate_simple(1, &none, &most);
      const hid_t made = H5Dcreate2(id, "/notes/index", row, space, H5P_DEFAULT, properties, H5P_DEFAULT);
      EXPECT_GE(made, 0);
      for (const auto& [close, what] :
           {std::pair{&H5Dclose, made}, {&H5Sclose, space}, {&H5Pclose, properties}, {&H5Tclose, row}})
        close(what);
    });
    expectRefused(file, each.words);
  }
}

TEST_F(RecordingLayout, WhatAProgramAddsBesideIsNoTrouble) {
  change([](hid_t id) {
    H5Gclose(H5Gcreate2(id, "/mine", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Lcreate_soft("/telemetry", id, "/short", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_hard(id, "/", id, "/inputs/again", H5P_DEFAULT, H5P_DEFAULT);
  });
  const auto checked = verify(file);
  ASSERT_TRUE(checked) << checked.error().text();
  EXPECT_TRUE(checked->intact());
}

}  // namespace
}  // namespace fyd::recording
