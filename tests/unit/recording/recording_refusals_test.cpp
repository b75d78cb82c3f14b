// Values and tables that HDF5 allows and a recording does not have: each is refused by its name, and told what it is.
#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/file/recording_driver.h"
#include "core/recording/file/recording_hdf5.h"
#include "core/recording/file/recording_layout.h"
#include "core/recording/file/recording_table.h"
#include "core/recording/file/recording_values.h"
#include "core/recording/recovery/recording_repair.h"
#include "recording_damage.h"
#include "recording_samples.h"

namespace fyd::recording {
namespace {

using testing::HasSubstr;

Handle placeOf(std::vector<hsize_t> size, std::vector<hsize_t> most = {}) {
  if (size.empty()) return {H5Screate(H5S_SCALAR), H5Sclose, "a space"};
  return {H5Screate_simple(static_cast<int>(size.size()), size.data(), most.empty() ? nullptr : most.data()), H5Sclose,
          "a space"};
}

Handle propertiesOf(std::vector<hsize_t> chunk = {}) {
  Handle made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
  if (!chunk.empty()) check(H5Pset_chunk(made.id(), static_cast<int>(chunk.size()), chunk.data()), "chunks");
  return made;
}

class RecordingRefusals : public testing::Test {
 protected:
  static constexpr std::uint64_t kRows = 600;

  void anew(const RecordingHeader& header = samples::header()) const { samples::record(file, kRows, header); }

  /// Of a recording that was good before.
  void change(const std::function<void(hid_t)>& how) const {
    anew();
    samples::change(file, how);
  }

  /// Another dataset in a place, which the recording may have or not. Nothing is written to it.
  static Handle put(hid_t id, const char* path, hid_t type, const Handle& space,
                    const Handle& properties = propertiesOf()) {
    if (H5Lexists(id, path, H5P_DEFAULT) > 0) check(H5Ldelete(id, path, H5P_DEFAULT), path);
    return {H5Dcreate2(id, path, type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose, path};
  }

  [[nodiscard]] std::string refusal() const {
    const auto opened = Recording::open(file);
    return opened ? "" : opened.error().text();
  }

  Folder folder;
  std::string file = folder.file();
};

// --- single values

TEST_F(RecordingRefusals, ATextThatIsNone) {
  change([](hid_t id) { put(id, "/header/notes", H5T_STD_I64LE, placeOf({})); });
  EXPECT_THAT(refusal(), HasSubstr("/header/notes: not a text"));
  change([](hid_t id) {
    const Handle endless(H5Tcopy(H5T_C_S1), H5Tclose, "a type");
    H5Tset_size(endless.id(), H5T_VARIABLE);
    put(id, "/header/notes", endless.id(), placeOf({}));
  });
  EXPECT_THAT(refusal(), HasSubstr("/header/notes: not a text")) << "one whose length stands elsewhere in the file";
  change([](hid_t id) { put(id, "/header/notes", textType(4).id(), placeOf({2})); });
  EXPECT_THAT(refusal(), HasSubstr("/header/notes: not one text"));
  change([](hid_t id) { put(id, "/header/notes", textType(kLongestText + 1).id(), placeOf({})); });
  EXPECT_THAT(refusal(), HasSubstr("/header/notes: a text of 67108865 bytes"));
  change([](hid_t id) { put(id, "/header/notes", textType(4).id(), placeOf({1}), propertiesOf({1})); });
  EXPECT_THAT(refusal(), HasSubstr("/header/notes: not in one piece"));
}

TEST_F(RecordingRefusals, ATextThatAnotherProgramPackedIntoItsHeaderIsRead) {
  const std::string who = samples::header().operator_name;
  change([&](hid_t id) {
    const Handle compact = propertiesOf();
    H5Pset_layout(compact.id(), H5D_COMPACT);
    const Handle text = textType(who.size());
    const Handle made = put(id, "/header/operator", text.id(), placeOf({}), compact);
    check(H5Dwrite(made.id(), text.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, who.data()), "a text");
  });
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ((*Recording::open(file))->info().header.operator_name, who);
}

TEST_F(RecordingRefusals, BytesThatAreNone) {
  change([](hid_t id) { put(id, "/header/step_state", H5T_STD_I16LE, placeOf({5})); });
  EXPECT_THAT(refusal(), HasSubstr("/header/step_state: not bytes"));
  change([](hid_t id) { put(id, "/header/step_state", H5T_STD_U8LE, placeOf({kLongestText + 1})); });
  EXPECT_THAT(refusal(), HasSubstr("/header/step_state: 67108865 bytes"));
}

TEST_F(RecordingRefusals, BytesForWhichTheDiskHasOnlyAHole) {
  constexpr hsize_t kBytes = 100U << 20U;
  change([](hid_t id) {
    const Handle at_once = propertiesOf();
    H5Pset_alloc_time(at_once.id(), H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(at_once.id(), H5D_FILL_TIME_NEVER);
    put(id, "/header/scene", H5T_STD_U8LE, placeOf({kBytes}), at_once);
  });
  ASSERT_GT(std::filesystem::file_size(file), kBytes);
  EXPECT_THAT(refusal(),
              HasSubstr(fmt::format("/header/scene: says to be {0} bytes, while {0} stand in the file of", kBytes)));
}

TEST_F(RecordingRefusals, NumbersThatAreNoneOrNoneOfTheirs) {
  change([](hid_t id) {
    H5Adelete(id, "started_ns");
    const Handle two(H5Acreate2(id, "started_ns", H5T_STD_I64LE, placeOf({2}).id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                     "a number");
  });
  EXPECT_THAT(refusal(), HasSubstr("started_ns: not one number"));
  for (const std::int64_t wrong : {std::int64_t{0}, std::int64_t{1'000'001}}) {
    change([&](hid_t id) {
      const Handle number(H5Aopen(id, "arithmetic", H5P_DEFAULT), H5Aclose, "a number");
      check(H5Awrite(number.id(), H5T_NATIVE_INT64, &wrong), "a number");
    });
    EXPECT_THAT(refusal(), HasSubstr(fmt::format("arithmetic {}: expected 1 or more", wrong)));
  }
}

// --- the header's lists, whose items end with a line feed

TEST_F(RecordingRefusals, LineFeedsWithinAnItemAreSpaces) {
  RecordingHeader header = samples::header();
  header.tags = {"two\nlines", "one"};
  header.missing = {{.table = "/motors", .first = 3, .count = 2, .why = "cut\nshort"}};
  anew(header);
  const auto opened = Recording::open(file);
  ASSERT_TRUE(opened) << opened.error().text();
  const RecordingHeader& read = (*opened)->info().header;
  EXPECT_THAT(read.tags, testing::ElementsAre("two lines", "one"));
  header.missing[0].why = "cut short";
  EXPECT_EQ(read.missing, header.missing);
}

TEST_F(RecordingRefusals, AMissingPartWithoutItsNumbersIsQuoted) {
  change([](hid_t id) {
    constexpr std::string_view kLine = "/motors three 2 cut\n";
    const Handle text = textType(kLine.size());
    const Handle made = put(id, "/header/missing", text.id(), placeOf({}));
    check(H5Dwrite(made.id(), text.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, kLine.data()), "a text");
  });
  EXPECT_THAT(refusal(), HasSubstr("/header/missing: \"/motors three 2 cut\""));
}

// --- groups and tables

TEST_F(RecordingRefusals, AGroupThatIsNone) {
  change([](hid_t id) { put(id, "/inputs", H5T_STD_U8LE, placeOf({1})); });
  EXPECT_THAT(refusal(), HasSubstr("/inputs: not a group as a recording has it"));
}

TEST_F(RecordingRefusals, AGroupOfTheOldKindWhoseIndexMayRunInACircle) {
  const std::string other = folder.file("old.h5");
  change([&](hid_t id) {
    const Handle old(H5Fcreate(other.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "a file");
    { const Handle group(H5Gcreate2(old.id(), "inputs", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "a group"); }
    check(H5Ldelete(id, "/inputs", H5P_DEFAULT), "/inputs");
    check(H5Ocopy(old.id(), "inputs", id, "/inputs", H5P_DEFAULT, H5P_DEFAULT), "/inputs");
  });
  EXPECT_THAT(refusal(), HasSubstr("/inputs: not a group as a recording has it"));
}

TEST_F(RecordingRefusals, ATableOfTwoDimensionsOrWithOtherFilters) {
  change([](hid_t id) {
    const Handle old(H5Dopen2(id, "/events", H5P_DEFAULT), H5Dclose, "/events");
    const Handle row(H5Dget_type(old.id()), H5Tclose, "a row");
    put(id, "/events", row.id(), placeOf({0, 1}, {H5S_UNLIMITED, 1}), propertiesOf({170, 1}));
  });
  EXPECT_THAT(refusal(), HasSubstr("/events: not in chunks of 170 rows"));
  change([](hid_t id) {
    const Handle old(H5Dopen2(id, "/motors", H5P_DEFAULT), H5Dclose, "/motors");
    const Handle row(H5Dget_type(old.id()), H5Tclose, "a row");
    const Handle two = propertiesOf({250});
    H5Pset_deflate(two.id(), 1);
    H5Pset_fletcher32(two.id());
    put(id, "/motors", row.id(), placeOf({kRows}, {H5S_UNLIMITED}), two);
  });
  EXPECT_THAT(refusal(), HasSubstr("/motors: not in chunks of 250 rows, shuffled and deflated"));
}

TEST_F(RecordingRefusals, RowsThatAreNotOfColumns) {
  change([](hid_t id) { put(id, "/events", H5T_STD_I64LE, placeOf({0}, {H5S_UNLIMITED}), propertiesOf({170})); });
  EXPECT_THAT(refusal(), HasSubstr("/events: its columns are not those of this format"));
  change([](hid_t id) {
    const Handle row(H5Tcreate(H5T_COMPOUND, 1), H5Tclose, "a row");
    check(H5Tinsert(row.id(), "byte", 0, H5T_STD_U8LE), "a row");
    put(id, "/notes/text", row.id(), placeOf({0}, {H5S_UNLIMITED}), propertiesOf({4096}));
  });
  EXPECT_THAT(refusal(), HasSubstr("/notes/text: its columns are not those of this format"));
}

TEST_F(RecordingRefusals, AColumnOfTwoDimensions) {
  change([](hid_t id) {
    const std::array<hsize_t, 2> one_by_one{1, 1};
    const Handle square(H5Tarray_create2(H5T_STD_I64LE, 2, one_by_one.data()), H5Tclose, "a column");
    const Handle row(H5Tcreate(H5T_COMPOUND, 24), H5Tclose, "a row");
    check(H5Tinsert(row.id(), "when_ns", 0, square.id()), "a row");
    put(id, "/notes/index", row.id(), placeOf({0}, {H5S_UNLIMITED}), propertiesOf({170}));
  });
  EXPECT_THAT(refusal(), HasSubstr("/notes/index: column when_ns is not of this format's type"));
}

TEST_F(RecordingRefusals, AListThatALaterProgramAddedToARowIsPassedOver) {
  const TableLayout& notes = layoutOf(Table::notes);
  constexpr hsize_t kItems = 3;
  const std::size_t row_bytes = notes.row_bytes + kItems * sizeof(double);
  change([&](hid_t id) {
    const Handle old(H5Dopen2(id, "/notes/index", H5P_DEFAULT), H5Dclose, "/notes/index");
    const Handle old_row(H5Dget_type(old.id()), H5Tclose, "a row");
    const Handle row(H5Tcreate(H5T_COMPOUND, row_bytes), H5Tclose, "a row");
    for (unsigned i = 0; i < notes.columns.size(); ++i) {
      const Handle member(H5Tget_member_type(old_row.id(), i), H5Tclose, "a column");
      check(H5Tinsert(row.id(), notes.columns[i].name.c_str(), notes.columns[i].offset, member.id()), "a column");
    }
    const Handle list(H5Tarray_create2(H5T_IEEE_F64LE, 1, &kItems), H5Tclose, "a column");
    check(H5Tinsert(row.id(), "later", notes.row_bytes, list.id()), "a column");
    put(id, "/notes/index", row.id(), placeOf({0}, {H5S_UNLIMITED}), propertiesOf({4096 / row_bytes}));
  });
  EXPECT_EQ(refusal(), "");
  EXPECT_TRUE((*Recording::open(file))->notes()->empty());
}

TEST_F(RecordingRefusals, AChunkLargerThanItsRowsCanBe) {
  const std::size_t rows_bytes = 250 * layoutOf(Table::motors).row_bytes;
  const std::size_t bytes = 2 * rows_bytes + 1'025;
  change([&](hid_t id) {
    const Handle motors(H5Dopen2(id, "/motors", H5P_DEFAULT), H5Dclose, "/motors");
    const std::string much(bytes, 'm');
    const hsize_t first = 250;
    check(H5Dwrite_chunk(motors.id(), H5P_DEFAULT, 0, &first, much.size(), much.data()), "/motors");
  });
  const auto opened = Recording::open(file);
  ASSERT_TRUE(opened) << opened.error().text();
  const auto step = (*opened)->step(300);
  ASSERT_FALSE(step);
  EXPECT_THAT(step.error().text(), HasSubstr(fmt::format("/motors: rows from 250 on take {} bytes", bytes)));
  const auto before = (*opened)->step(249);
  ASSERT_TRUE(before) << before.error().text();
  EXPECT_TRUE(samples::sameRecord(*before, samples::plainStep(249)));
}

TEST_F(RecordingRefusals, RowsThatWereNeverWritten) {
  change([](hid_t id) {
    const Handle old(H5Dopen2(id, "/motors", H5P_DEFAULT), H5Dclose, "/motors");
    const Handle row(H5Dget_type(old.id()), H5Tclose, "a row");
    const Handle ours = propertiesOf({250});
    H5Pset_shuffle(ours.id());
    H5Pset_deflate(ours.id(), 1);
    put(id, "/motors", row.id(), placeOf({kRows}, {H5S_UNLIMITED}), ours);
  });
  const auto opened = Recording::open(file);
  ASSERT_TRUE(opened) << opened.error().text();
  const auto step = (*opened)->step(0);
  ASSERT_FALSE(step);
  EXPECT_THAT(step.error().text(), HasSubstr("/motors: rows from 0 on take 0 bytes"));
}

// --- asked directly

TEST_F(RecordingRefusals, RowsBeyondATablesEnd) {
  anew();
  const auto lock = hdf5Lock();
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const auto disk = std::make_shared<JournaledFile>(descriptor, JournaledFile::Mode::read, true);
  {
    const Handle access = accessThrough(disk);
    const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, "the file");
    const Hdf5Table table = Hdf5Table::open(opened.id(), layoutOf(Table::telemetry));
    ASSERT_EQ(table.rows(), kRows);
    ASSERT_NE(table.column("now_ns"), nullptr);
    EXPECT_EQ(table.column("now_ns")->unit, layoutOf(Table::telemetry).columns[0].unit);
    EXPECT_EQ(table.column("nothing"), nullptr);
    std::vector<std::byte> room(2 * table.rowBytes());
    const auto refused = [&](std::uint64_t first, std::uint64_t count) -> std::string {
      try {
        table.read(first, count, room);
      } catch (const RecordingFailure& failure) {
        return failure.message.text();
      }
      return "";
    };
    EXPECT_EQ(refused(kRows - 2, 2), "");
    EXPECT_EQ(refused(kRows - 1, 2), "/telemetry: rows 599+2 of 600");
    EXPECT_EQ(refused(kRows + 1, 0), "/telemetry: rows 601+0 of 600");
    EXPECT_EQ(refused(1, std::numeric_limits<std::uint64_t>::max()),
              fmt::format("/telemetry: rows 1+{} of 600", std::numeric_limits<std::uint64_t>::max()));
    EXPECT_EQ(refused(0, 3), "/telemetry: room for other rows than asked");
  }
  ::close(descriptor);
  Hdf5Table none;
  none.refresh();
  EXPECT_EQ(none.rows(), 0U);
  none.read(0, 0, {});
}

TEST_F(RecordingRefusals, AnyOtherFirstByte) {
  anew();
  const std::string good = samples::contentOf(file);
  const auto said = [&](int flags) -> std::string {
    const int descriptor = ::open(file.c_str(), flags | O_CLOEXEC);
    std::string words;
    try {
      checkStart(JournaledFile(descriptor, JournaledFile::Mode::read, false));
    } catch (const RecordingFailure& failure) {
      words = failure.message.text();
    }
    ::close(descriptor);
    return words;
  };
  EXPECT_EQ(said(O_RDONLY), "");
  EXPECT_THAT(said(O_WRONLY), HasSubstr("its first bytes cannot be read"));
  constexpr std::size_t kSignature = 8, kOpenedBy = 11, kEnd = 28;
  for (std::size_t at = 0; at < kEnd; ++at) {
    std::string other = good;
    other[kJournalBytes + at] = static_cast<char>(other[kJournalBytes + at] ^ 1);
    samples::write(file, other);
    EXPECT_EQ(said(O_RDONLY), at < kSignature   ? "not a recording, or too damaged to open"
                              : at == kOpenedBy ? ""
                                                : "an HDF5 file, but not a recording of the console, or its first "
                                                  "bytes are damaged")
        << "byte " << at;
  }
}

TEST_F(RecordingRefusals, ARepairOfAFileThatHdf5DoesNotOpenLeavesItAsItIs) {
  anew();
  constexpr std::size_t kChecksum = 44;  // of the superblock, whose first 28 bytes are looked at before
  samples::flipBit(file, kJournalBytes + kChecksum, 3);
  const std::string before = samples::contentOf(file);
  const auto repaired = finishRecording(file);
  ASSERT_FALSE(repaired);
  EXPECT_THAT(repaired.error().text(), HasSubstr(file));
  EXPECT_TRUE(samples::contentOf(file) == before);
}

TEST(MostRows, AreThoseThatSoManyCommitsCanHold) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(mostRows(Table::steps, 0), 250U);
  EXPECT_EQ(mostRows(Table::motors, 7), 2'000U);
  EXPECT_EQ(mostRows(Table::telemetry, kMost / 250 - 1), kMost / 250 * 250);
  EXPECT_EQ(mostRows(Table::telemetry, kMost / 250), kMost) << "their number cannot overflow";
  EXPECT_EQ(mostRows(Table::events, 0), kMost);
}

}  // namespace
}  // namespace fyd::recording
