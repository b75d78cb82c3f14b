// The order of a commit, call by call: what HDF5 overwrites reaches its place only after the journal that can repeat it
// has been synced, and a journal is replaced only after the places of the one before have been.
#include "core/recording/file/recording_disk.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/recording/remembering_disk.h"
#include "tests/reference_crc.h"
#include "tests/temporary_folder.h"

namespace fyd::recording {
namespace {

using samples::LoggingDisk;
using testing::ElementsAre;
using DiskBytes = std::vector<std::byte>;

constexpr std::uint64_t kFirst = kJournalBytes;  // where HDF5's own bytes begin
constexpr std::size_t kHead_bytes = 40;          // of the journal

DiskBytes bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// "journal", "sync", "end" for a cleared journal, "@OFFSET:TEXT" for bytes of the file, "=SIZE" for a new length.
std::vector<std::string> words(const std::vector<LoggingDisk::Call>& calls, std::size_t from = 0) {
  std::vector<std::string> out;
  for (std::size_t i = from; i < calls.size(); ++i) {
    const LoggingDisk::Call& call = calls[i];
    if (call.sync) {
      out.emplace_back("sync");
    } else if (call.bytes.empty()) {
      out.push_back("=" + std::to_string(call.at - kFirst));
    } else if (call.at == 0) {
      const bool cleared = std::ranges::all_of(call.bytes, [](std::byte b) { return b == std::byte{0}; });
      out.emplace_back(cleared ? "end" : "journal");
    } else {
      const auto* text = reinterpret_cast<const char*>(call.bytes.data());
      out.push_back("@" + std::to_string(call.at - kFirst) + ":" + std::string(text, call.bytes.size()));
    }
  }
  return out;
}

/// Fails with `error` at its call number `fails_at` of one kind, and works otherwise.
class FailingDisk final : public DiskCalls {
 public:
  int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
    ++writes;
    return writes == failing_write ? EIO : DiskCalls::write(file, bytes, at);
  }
  int sync(int) override { return ++syncs == failing_sync ? ENOSPC : 0; }
  int resize(int, std::uint64_t) override { return EFBIG; }
  int writes = 0;
  int syncs = 0;
  int failing_write = -1;
  int failing_sync = -1;
};

class Journaled : public testing::Test {
 protected:
  Journaled() { file = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644); }
  ~Journaled() override { ::close(file); }

  JournaledFile fresh() { return {file, JournaledFile::Mode::write, false, disk}; }
  static std::string textAt(const JournaledFile& from, std::uint64_t at, std::size_t size) {
    std::string out(size, '?');
    EXPECT_EQ(from.read(kFirst + at, std::as_writable_bytes(std::span(out))), 0);
    return out;
  }
  static void write(JournaledFile& to, std::uint64_t at, std::string_view text) {
    to.write(kFirst + at, bytesOf(text));
  }
  /// "abcd", committed, and then `over` at its beginning, committed too: what a writer that ended leaves.
  void leaveJournalOf(std::string_view over) {
    JournaledFile journaled = fresh();
    write(journaled, 0, "abcd");
    ASSERT_EQ(journaled.commit(), 0);
    write(journaled, 0, over);
    ASSERT_EQ(journaled.commit(), 0);
  }

  Folder folder;
  std::string path = folder.file("journaled");
  int file = -1;
  std::shared_ptr<LoggingDisk> disk = std::make_shared<LoggingDisk>();
};

TEST_F(Journaled, WhatIsNewGoesToItsPlaceAtOnceAndNeedsNoJournal) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "abcd");
  EXPECT_THAT(words(disk->calls), ElementsAre("@0:abcd"));
  ASSERT_EQ(journaled.commit(), 0);
  EXPECT_THAT(words(disk->calls, 1), ElementsAre("sync"));
}

TEST_F(Journaled, WhatIsOverwrittenWaitsForASyncedJournal) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "abcd");
  ASSERT_EQ(journaled.commit(), 0);
  const std::size_t before = disk->calls.size();
  write(journaled, 1, "XY");
  EXPECT_EQ(disk->calls.size(), before) << "nothing committed may change before the commit";
  EXPECT_EQ(textAt(journaled, 0, 4), "aXYd") << "its own reader sees what waits";
  ASSERT_EQ(journaled.commit(), 0);
  EXPECT_THAT(words(disk->calls, before), ElementsAre("sync", "journal", "sync", "@1:XY"));
  // The next one syncs those places before it replaces their journal.
  write(journaled, 0, "Z");
  ASSERT_EQ(journaled.commit(), 0);
  EXPECT_THAT(words(disk->calls, before + 4), ElementsAre("sync", "journal", "sync", "@0:Z"));
}

TEST_F(Journaled, AWriteAcrossTheCommittedEndIsDivided) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "abcd");
  ASSERT_EQ(journaled.commit(), 0);
  const std::size_t before = disk->calls.size();
  write(journaled, 2, "CDEF");
  EXPECT_THAT(words(disk->calls, before), ElementsAre("@4:EF"));
  write(journaled, 4, "ef");  // not committed yet: at once again
  EXPECT_THAT(words(disk->calls, before + 1), ElementsAre("@4:ef"));
  ASSERT_EQ(journaled.commit(), 0);
  EXPECT_THAT(words(disk->calls, before + 2), ElementsAre("sync", "journal", "sync", "@2:CD"));
  write(journaled, 5, "F");  // committed now
  EXPECT_EQ(disk->calls.size(), before + 6);
}

TEST_F(Journaled, WhatWaitsIsWrittenInTheOrderInWhichItCame) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "abcd");
  ASSERT_EQ(journaled.commit(), 0);
  const std::size_t before = disk->calls.size();
  write(journaled, 0, "12");
  write(journaled, 1, "34");
  EXPECT_EQ(textAt(journaled, 0, 4), "134d");
  ASSERT_EQ(journaled.commit(), 0);
  EXPECT_THAT(words(disk->calls, before), ElementsAre("sync", "journal", "sync", "@0:12", "@1:34"));
  EXPECT_EQ(textAt(journaled, 0, 4), "134d");
}

TEST_F(Journaled, ItsEndIsACommitThenASyncThenAClearedJournal) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "abcd");
  ASSERT_EQ(journaled.commit(), 0);
  write(journaled, 0, "A");
  const std::size_t before = disk->calls.size();
  ASSERT_EQ(journaled.dropJournal(), 0);
  EXPECT_THAT(words(disk->calls, before), ElementsAre("sync", "journal", "sync", "@0:A", "sync", "end", "sync"));
  EXPECT_EQ(disk->calls.back().sync, true);
  EXPECT_EQ(disk->calls[disk->calls.size() - 2].bytes.size(), kHead_bytes);
}

TEST_F(Journaled, AfterAnyCutWithAnyPartOfWhatWasNotSyncedItIsOneOfTheCommits) {
  const std::vector<std::string> versions = {"abcd", "aXYdE", "aXZdEF", "QXZdEF"};
  std::vector<std::size_t> acknowledged;
  {
    JournaledFile journaled = fresh();
    write(journaled, 0, "abcd");
    ASSERT_EQ(journaled.commit(), 0);
    acknowledged.push_back(disk->calls.size());
    write(journaled, 1, "XY");
    write(journaled, 4, "E");
    ASSERT_EQ(journaled.commit(), 0);
    acknowledged.push_back(disk->calls.size());
    write(journaled, 5, "F");
    write(journaled, 2, "Z");
    ASSERT_EQ(journaled.commit(), 0);
    acknowledged.push_back(disk->calls.size());
    write(journaled, 0, "Q");
    ASSERT_EQ(journaled.dropJournal(), 0);
    acknowledged.push_back(disk->calls.size());
  }
  const auto& calls = disk->calls;
  int tried = 0;
  for (std::size_t end = acknowledged.front(); end <= calls.size(); ++end) {
    std::size_t synced = 0;
    for (std::size_t i = 0; i < end; ++i)
      if (calls[i].sync) synced = i;
    std::vector<std::size_t> open;  // may or may not have reached the disk
    for (std::size_t i = synced; i < end; ++i)
      if (!calls[i].sync) open.push_back(i);
    std::size_t least = 0;
    for (std::size_t v = 0; v < acknowledged.size(); ++v)
      if (acknowledged[v] <= end) least = v;
    ASSERT_LT(open.size(), 10U);
    for (std::size_t subset = 0; subset < (std::size_t{1} << open.size()); ++subset) {
      const std::string cut = folder.file("cut");
      const int left = ::open(cut.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0644);
      DiskCalls plain;
      for (std::size_t i = 0; i < end; ++i) {
        if (calls[i].sync) continue;
        const auto at = std::ranges::find(open, i);
        if (at != open.end() && (subset >> (at - open.begin()) & 1U) == 0) continue;
        ASSERT_EQ(plain.write(left, calls[i].bytes, calls[i].at), 0);
      }
      const JournaledFile found(left, JournaledFile::Mode::read, true);
      bool known = false;
      std::string text;
      for (std::size_t v = least; v < versions.size() && !known; ++v) {
        text = textAt(found, 0, versions[v].size());
        known = text == versions[v];
      }
      EXPECT_TRUE(known) << "cut at " << end << ", of " << open.size() << " open calls the set " << subset << ": "
                         << text;
      ::close(left);
      ++tried;
    }
  }
  EXPECT_GT(tried, 25);
}

TEST_F(Journaled, AJournalWithOneWrongBitIsNone) {
  leaveJournalOf("X");
  DiskCalls plain;
  ASSERT_EQ(plain.write(file, bytesOf(std::string_view("a")), kFirst), 0);  // its place was not reached
  const DiskBytes journal = disk->calls[3].bytes;
  ASSERT_GT(journal.size(), kHead_bytes);
  {
    const JournaledFile sound(file, JournaledFile::Mode::read, true);
    EXPECT_TRUE(sound.foundJournal());
    EXPECT_EQ(textAt(sound, 0, 4), "Xbcd");
    const JournaledFile without(file, JournaledFile::Mode::read, false);
    EXPECT_FALSE(without.foundJournal());
    EXPECT_EQ(textAt(without, 0, 4), "abcd");
  }
  constexpr std::size_t kReserved = 36;  // four bytes of the head that mean nothing
  for (std::size_t at = 0; at < journal.size(); ++at) {
    if (at >= kReserved && at < kHead_bytes) continue;
    DiskBytes wrong = journal;
    wrong[at] ^= std::byte{0x10};
    ASSERT_EQ(plain.write(file, wrong, 0), 0);
    const JournaledFile damaged(file, JournaledFile::Mode::read, true);
    EXPECT_FALSE(damaged.foundJournal()) << "byte " << at;
    EXPECT_EQ(textAt(damaged, 0, 4), "abcd") << "byte " << at;
  }
}

template <class T>
T numberAt(const DiskBytes& bytes, std::size_t at) {
  T out{};
  std::memcpy(&out, bytes.data() + at, sizeof out);
  return out;
}

// Read here as the page of the recording's format describes it.
TEST_F(Journaled, AJournalIsWrittenAsTheFormatsPageSays) {
  {
    JournaledFile journaled = fresh();
    write(journaled, 0, "abcdef");
    ASSERT_EQ(journaled.commit(), 0);
    write(journaled, 1, "XY");
    write(journaled, 4, "Z");
    ASSERT_EQ(journaled.commit(), 0);
    write(journaled, 0, "Q");
    ASSERT_EQ(journaled.commit(), 0);
  }
  JournaledFile again(file, JournaledFile::Mode::write, true, disk);
  ASSERT_EQ(again.applyJournal(), 0);
  write(again, 0, "R");
  ASSERT_EQ(again.commit(), 0);
  std::vector<DiskBytes> journals;
  for (const LoggingDisk::Call& call : disk->calls)
    if (!call.sync && call.at == 0) journals.push_back(call.bytes);
  ASSERT_EQ(journals.size(), 3U);
  constexpr std::string_view kMagic = "FYD journal 1";
  constexpr std::size_t kNumbers = 16;  // behind the magic: sequence and bytes
  for (std::size_t i = 0; i < journals.size(); ++i) {
    SCOPED_TRACE(i);
    const DiskBytes& journal = journals[i];
    ASSERT_GT(journal.size(), kHead_bytes);
    EXPECT_EQ(std::memcmp(journal.data(), kMagic.data(), kMagic.size()), 0);
    EXPECT_EQ(numberAt<std::uint64_t>(journal, kNumbers), i + 1) << "the number continues the ended recorder's";
    EXPECT_EQ(numberAt<std::uint64_t>(journal, kNumbers + 8), journal.size() - kHead_bytes);
    DiskBytes proven(journal.begin() + kNumbers, journal.begin() + kNumbers + 16);
    proven.insert(proven.end(), journal.begin() + kHead_bytes, journal.end());
    EXPECT_EQ(numberAt<std::uint32_t>(journal, kNumbers + 16), referenceCrc32c(proven));
  }
  DiskBytes pieces(journals[0].begin() + kHead_bytes, journals[0].end());
  for (std::byte& b : pieces) b ^= std::byte{0xA5};
  ASSERT_EQ(pieces.size(), 16U + 2U + 16U + 1U);
  EXPECT_EQ(numberAt<std::uint64_t>(pieces, 0), kFirst + 1);
  EXPECT_EQ(numberAt<std::uint64_t>(pieces, 8), 2U);
  EXPECT_EQ(pieces[16], std::byte{'X'});
  EXPECT_EQ(pieces[17], std::byte{'Y'});
  EXPECT_EQ(numberAt<std::uint64_t>(pieces, 18), kFirst + 4);
  EXPECT_EQ(numberAt<std::uint64_t>(pieces, 26), 1U);
  EXPECT_EQ(pieces[34], std::byte{'Z'});
}

TEST_F(Journaled, AnEndedRecordersJournalIsAppliedAndStaysUntilItsPlacesAreSynced) {
  leaveJournalOf("X");
  DiskCalls plain;
  ASSERT_EQ(plain.write(file, bytesOf("a"), kFirst), 0);
  disk->calls.clear();
  JournaledFile again(file, JournaledFile::Mode::write, true, disk);
  ASSERT_EQ(again.applyJournal(), 0);
  EXPECT_THAT(words(disk->calls), ElementsAre("@0:X"));
  write(again, 1, "Y");
  EXPECT_EQ(disk->calls.size(), 1U) << "the place was committed by the ended recorder";
  ASSERT_EQ(again.commit(), 0);
  EXPECT_THAT(words(disk->calls, 1), ElementsAre("sync", "journal", "sync", "@1:Y"));
  const JournaledFile read(file, JournaledFile::Mode::read, true);
  EXPECT_TRUE(read.foundJournal());
}

TEST_F(Journaled, WhatAnAppliedJournalMadeLongerIsCommittedToItsNewEnd) {
  leaveJournalOf("WXYZ");
  ASSERT_EQ(::ftruncate(file, static_cast<off_t>(kFirst + 2)), 0);
  JournaledFile again(file, JournaledFile::Mode::write, true, disk);
  ASSERT_EQ(again.applyJournal(), 0);
  EXPECT_EQ(again.size(), kFirst + 4);
  const std::size_t before = disk->calls.size();
  write(again, 3, "!");
  EXPECT_EQ(disk->calls.size(), before) << "it waits for a journal of its own";
  EXPECT_EQ(textAt(again, 0, 4), "WXY!");
}

TEST_F(Journaled, OnceACallFailedNothingIsCommittedAnyMore) {
  for (int call = 1; call <= 8; ++call) {
    const bool sync = call > 4;
    const auto failing = std::make_shared<FailingDisk>();
    (sync ? failing->failing_sync : failing->failing_write) = sync ? call - 4 : call;
    ASSERT_EQ(::ftruncate(file, 0), 0);
    JournaledFile journaled(file, JournaledFile::Mode::write, false, failing);
    write(journaled, 0, "abcd");     // write 1
    int error = journaled.commit();  // sync 1
    write(journaled, 0, "XY");
    if (error == 0) error = journaled.commit();  // sync 2, write 2: the journal, sync 3, write 3
    write(journaled, 0, "Z");
    if (error == 0) error = journaled.commit();  // sync 4, write 4
    EXPECT_EQ(error, sync ? ENOSPC : EIO) << "call " << call;
    const int writes = failing->writes;
    const int syncs = failing->syncs;
    write(journaled, 100, "later");
    EXPECT_EQ(textAt(journaled, 100, 5), "later") << "HDF5 goes on over what it wrote";
    EXPECT_EQ(journaled.commit(), error) << "the first error stays";
    EXPECT_EQ(journaled.dropJournal(), error);
    EXPECT_EQ(failing->writes, writes) << "call " << call;
    EXPECT_EQ(failing->syncs, syncs) << "call " << call;
  }
}

TEST_F(Journaled, WhatAFailedWriteWasToWriteIsStillRead) {
  const auto failing = std::make_shared<FailingDisk>();
  JournaledFile journaled(file, JournaledFile::Mode::write, false, failing);
  write(journaled, 0, "abcd");
  ASSERT_EQ(journaled.commit(), 0);
  failing->failing_write = 2;
  write(journaled, 2, "CDEF");  // across the committed end: the part behind it is written, and fails
  EXPECT_EQ(failing->writes, 2);
  EXPECT_EQ(textAt(journaled, 0, 6), "abCDEF") << "HDF5 never hears of a disk that refuses";
  EXPECT_EQ(journaled.commit(), EIO);
}

TEST_F(Journaled, TheEndReportsTheErrorOfEachOfItsOwnCalls) {
  for (int call = 1; call <= 3; ++call) {
    const auto failing = std::make_shared<FailingDisk>();
    ASSERT_EQ(::ftruncate(file, 0), 0);
    JournaledFile journaled(file, JournaledFile::Mode::write, false, failing);
    write(journaled, 0, "abcd");
    ASSERT_EQ(journaled.commit(), 0);  // write 1, sync 1; then sync 2 and 3 of the end, write 2, sync 4
    if (call == 1) failing->failing_sync = 3;
    if (call == 2) failing->failing_write = 2;
    if (call == 3) failing->failing_sync = 4;
    EXPECT_EQ(journaled.dropJournal(), call == 2 ? EIO : ENOSPC);
  }
}

TEST_F(Journaled, ALengthThatTheDiskRefusesIsTheNextCommitsError) {
  const auto failing = std::make_shared<FailingDisk>();
  JournaledFile journaled(file, JournaledFile::Mode::write, false, failing);
  journaled.reach(kFirst + 10);
  EXPECT_EQ(journaled.size(), kFirst + 10);
  EXPECT_EQ(journaled.commit(), EFBIG);
  EXPECT_EQ(failing->syncs, 0);
}

TEST_F(Journaled, ALengthIsOnlyEverMade) {
  JournaledFile journaled = fresh();
  journaled.reach(kFirst + 10);
  journaled.reach(kFirst + 10);
  journaled.reach(kFirst + 5);
  EXPECT_EQ(journaled.size(), kFirst + 10);
  EXPECT_THAT(words(disk->calls), ElementsAre("=10"));
  EXPECT_EQ(journaled.sizeNow(), kFirst + 10);
}

TEST_F(Journaled, MoreThanTheJournalHoldsIsAnErrorAndChangesNothing) {
  JournaledFile journaled = fresh();
  const std::string much(kJournalBytes, 'm');
  write(journaled, 0, much);
  ASSERT_EQ(journaled.commit(), 0);
  const std::size_t before = disk->calls.size();
  write(journaled, 0, std::string(kJournalBytes - kHead_bytes - 2 * sizeof(std::uint64_t), 'n'));
  ASSERT_EQ(journaled.commit(), 0) << "as much as just fits";
  EXPECT_EQ(disk->calls.size(), before + 4);
  write(journaled, 0, std::string(kJournalBytes - kHead_bytes - 2 * sizeof(std::uint64_t) + 1, 'o'));
  EXPECT_EQ(journaled.commit(), EOVERFLOW);
  EXPECT_THAT(words(disk->calls, before + 4), ElementsAre("sync"));
}

TEST_F(Journaled, AnAbandonedFileOrAReadersIsNeverWritten) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "abcd");
  ASSERT_EQ(journaled.commit(), 0);
  const std::size_t before = disk->calls.size();
  journaled.abandon();
  write(journaled, 2, "CDEF");
  journaled.reach(kFirst + 20);
  EXPECT_EQ(journaled.commit(), 0);
  EXPECT_EQ(disk->calls.size(), before);
  EXPECT_EQ(textAt(journaled, 0, 6), "abCDEF");

  JournaledFile reader(file, JournaledFile::Mode::read, true, disk);
  write(reader, 0, "X");
  reader.reach(kFirst + 20);
  EXPECT_EQ(reader.commit(), EROFS);
  EXPECT_EQ(disk->calls.size(), before);
  EXPECT_EQ(textAt(reader, 0, 4), "abcd");
}

TEST_F(Journaled, AFileThatAnotherProgramShortenedIsNeverCalledCommitted) {
  // What is done to a file of four bytes, of which another program has left two.
  const std::vector<std::function<void(JournaledFile&)>> next = {
      [](JournaledFile& /*journaled*/) {},
      [](JournaledFile& journaled) { write(journaled, 0, "X"); },       // to wait for the journal, at its start
      [](JournaledFile& journaled) { write(journaled, 4, "efgh"); },    // beyond the end: it would be long again
      [](JournaledFile& journaled) { journaled.reach(kFirst + 100); },  // the same
  };
  for (const auto& each : next) {
    ASSERT_EQ(::ftruncate(file, 0), 0);
    JournaledFile journaled = fresh();
    write(journaled, 0, "abcd");
    ASSERT_EQ(journaled.commit(), 0);
    EXPECT_FALSE(journaled.shortened());
    ASSERT_EQ(::ftruncate(file, kFirst + 2), 0);
    EXPECT_TRUE(journaled.shortened());
    each(journaled);
    EXPECT_EQ(journaled.commit(), JournaledFile::kShortened);
    EXPECT_EQ(journaled.dropJournal(), JournaledFile::kShortened);
    EXPECT_EQ(std::filesystem::file_size(path), kFirst + 2) << "nothing covers the hole";
  }
  EXPECT_FALSE(JournaledFile(-1, JournaledFile::Mode::write, false).shortened())
      << "of what has no length nothing is said";
}

TEST_F(Journaled, BytesBeyondTheEndAreZero) {
  JournaledFile journaled = fresh();
  write(journaled, 0, "ab");
  EXPECT_EQ(textAt(journaled, 0, 4), std::string("ab\0\0", 4));
}

}  // namespace
}  // namespace fyd::recording
