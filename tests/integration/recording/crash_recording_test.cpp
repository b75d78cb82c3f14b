// Killed recorders, power cuts, write errors: committed data are never lost or wrong.
// FYD_CRASHES=200 and FYD_POWER_CUTS=500 set the full counts; without them there are fewer.
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "core/recording/writer/picture_history.h"
#include "core/recording/writer/recording_writer.h"
#include "remembering_disk.h"
#include "tests/child_process.h"
#include "tests/unit/recording/recording_damage.h"
#include "tests/unit/recording/recording_samples.h"

namespace fyd::recording {
namespace {

using namespace samples;

constexpr std::size_t kSector_bytes = 512;

std::size_t countFrom(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

/// Every committed row is the plain step it was. @return how many rows
std::uint64_t expectPlain(const Recording& recording, std::uint64_t at_least) {
  const std::uint64_t rows = recording.info().committed_samples;
  EXPECT_GE(rows, at_least);
  for (std::uint64_t row = 0; row < rows; row += row + 300 < rows ? 7 : 1) {
    const auto step = recording.step(row);
    EXPECT_TRUE(step) << (step ? "" : step.error().text());
    if (!step || !sameRecord(*step, plainStep(row))) {
      ADD_FAILURE() << "row " << row << " of " << rows;
      break;
    }
  }
  return rows;
}

constexpr std::uint64_t kStepsPerPicture = 33;

std::uint64_t expectCrashedAndWhole(const std::string& file, std::uint64_t at_least) {
  const auto recording = Recording::open(file);
  if (!recording) {
    ADD_FAILURE() << recording.error().text();
    return 0;
  }
  return expectPlain(**recording, at_least);
}

const cv::Rect kRegion(10, 5, 40, 30);

/// A picture that tells its number.
cv::Mat plainPicture(std::uint64_t number) {
  cv::Mat picture(48, 64, CV_8UC1);
  cv::RNG random(number + 1);
  random.fill(picture, cv::RNG::UNIFORM, 0, 255);
  return picture;
}

/// Every third picture has the whole beside its region.
EncodedPicture plainEncoded(std::uint64_t number) {
  return encodePicture({.picture = plainPicture(number),
                        .region_px = kRegion,
                        .taken = plainStep(number * kStepsPerPicture).inputs.now,
                        .number = number},
                       number % 3 == 0);
}

/// Every committed picture is the one it was, and all up to the last committed step are there.
void expectPlainPictures(const Recording& recording) {
  const RecordingInfo& info = recording.info();
  EXPECT_GE(info.frames * kStepsPerPicture + kStepsPerPicture, info.committed_samples);
  for (std::uint64_t i = 0; i < info.frames; ++i) {
    const auto picture = recording.picture(i);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ(picture->number, i);
    EXPECT_EQ(cv::norm(picture->region, plainPicture(i)(kRegion), cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(picture->whole(kRegion), picture->region, cv::NORM_INF), 0.0);
  }
}

/// Records plain steps and pictures until it is killed, telling through the pipe what was committed.
[[noreturn]] void recordForEver(const std::string& file, int tell) {
  auto writer = RecordingWriter::create(file, header());
  if (!writer) ::_exit(1);
  std::uint64_t told = 0;
  (void)!::write(tell, &told, sizeof told);
  for (std::uint64_t row = 0;; ++row) {
    if (row % kStepsPerPicture == 0 && !(*writer)->append(plainEncoded(row / kStepsPerPicture))) ::_exit(3);
    if (!(*writer)->append(plainStep(row))) ::_exit(2);
    if ((*writer)->committedSteps() == told) continue;
    told = (*writer)->committedSteps();
    (void)!::write(tell, &told, sizeof told);
  }
}

TEST(CrashRecording, AKilledRecorderLosesNothingItAcknowledged) {
  std::mt19937 random(11);
  const std::size_t crashes = countFrom("FYD_CRASHES", 12);
  for (std::size_t i = 0; i < crashes; ++i) {
    const Folder folder;
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ChildProcess child([&]() -> int {
      ::close(ends[0]);
      recordForEver(folder.file(), ends[1]);
    });
    ::close(ends[1]);
    std::uint64_t acknowledged = 0;
    std::uint64_t word = 0;
    ASSERT_EQ(::read(ends[0], &word, sizeof word), static_cast<ssize_t>(sizeof word));
    {
      const auto growing = Recording::open(folder.file());
      ASSERT_TRUE(growing) << growing.error().text();
      EXPECT_EQ((*growing)->info().wholeness, Wholeness::growing);
      EXPECT_FALSE(recover(folder.file()));
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 120'000));
      ASSERT_EQ(child.kill(), SIGKILL);  // it had not ended by itself
      while (::read(ends[0], &word, sizeof word) == static_cast<ssize_t>(sizeof word)) acknowledged = word;
      ::close(ends[0]);
      const auto news = (*growing)->refresh();  // a reader that was there sees the recorder's end too
      ASSERT_TRUE(news) << news.error().text();
      EXPECT_EQ((*growing)->info().wholeness, Wholeness::crashed);
      expectPlain(**growing, acknowledged);
    }
    const std::uint64_t rows = expectCrashedAndWhole(folder.file(), acknowledged);
    const auto checked = verify(folder.file());
    ASSERT_TRUE(checked);
    EXPECT_TRUE(checked->intact()) << checked->first_damage.text();
    const auto recovered = recover(folder.file());
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(recovered->result, RecoverResult::whole);
    const auto whole = Recording::open(folder.file());
    ASSERT_TRUE(whole) << whole.error().text();
    EXPECT_EQ((*whole)->info().wholeness, Wholeness::whole);
    EXPECT_EQ(expectPlain(**whole, acknowledged), rows);
    expectPlainPictures(**whole);
    EXPECT_FALSE(std::filesystem::exists(partialOf(folder.file())));
    if (HasFailure()) break;
  }
}

/// Its process is killed in the middle of one write: half of it is there, and nothing after it.
class MortalDisk final : public DiskCalls {
 public:
  explicit MortalDisk(std::size_t whole_writes) : whole_writes_(whole_writes) {}
  int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
    if (writes++ < whole_writes_) return DiskCalls::write(file, bytes, at);
    if (writes == whole_writes_ + 1) (void)DiskCalls::write(file, bytes.first(bytes.size() / 2), at);
    return EIO;
  }
  int sync(int) override { return 0; }
  int resize(int file, std::uint64_t bytes) override {
    return writes > whole_writes_ ? EIO : DiskCalls::resize(file, bytes);
  }
  std::size_t writes = 0;

 private:
  std::size_t whole_writes_;
};

/// Records plain steps and pictures until the disk ends, or until `steps`; `look` after each commit.
template <class Look>
std::uint64_t recordUntilItsEnd(RecordingWriter& writer, std::uint64_t steps, Look&& look) {
  std::uint64_t committed = 0;
  for (std::uint64_t row = 0; row < steps; ++row) {
    if (row % kStepsPerPicture == 0 && !writer.append(plainEncoded(row / kStepsPerPicture))) break;
    if (!writer.append(plainStep(row))) break;
    if (writer.committedSteps() == committed) continue;
    committed = writer.committedSteps();
    look();
  }
  return writer.committedSteps();
}

TEST(CrashRecording, AReaderThatWasThereHasTheJournalOfARecorderKilledInTheMiddleOfAnyWrite) {
  constexpr std::uint64_t kSteps = 1300;  // more than one overview row of 1000, and chunks of an index of their own
  const auto counting = std::make_shared<MortalDisk>(std::numeric_limits<std::size_t>::max());
  std::size_t begun = 0;
  {
    const Folder folder;
    auto writer = createRecording(folder.file(), header(), counting);
    ASSERT_TRUE(writer);
    begun = counting->writes;
    recordUntilItsEnd(**writer, kSteps, [] {});
  }
  const std::size_t kills = countFrom("FYD_CRASHES", 30);
  const std::size_t step = std::max<std::size_t>(1, (counting->writes - begun) / kills);
  std::size_t checked_to_the_end = 0;
  for (std::size_t whole = begun; whole < counting->writes; whole += step) {
    SCOPED_TRACE(fmt::format("killed in write {} of {}", whole, counting->writes));
    const Folder folder;
    auto writer = createRecording(folder.file(), header(), std::make_shared<MortalDisk>(whole));
    ASSERT_TRUE(writer) << writer.error().text();
    // One reader looks again after the end, one reads on without a look, one is in the middle, one comes only then.
    const auto looks = Recording::open(folder.file());
    const auto reads = Recording::open(folder.file());
    ASSERT_TRUE(looks && reads);
    const std::uint64_t acknowledged = recordUntilItsEnd(**writer, kSteps, [&] {
      EXPECT_TRUE((*looks)->refresh());
      EXPECT_TRUE((*reads)->refresh());
    });
    const std::uint64_t known = (*reads)->info().committed_samples;
    const auto checked = verify(folder.file(), [&](double) {
      writer->reset();
      return true;
    });
    if (checked) {  // not at its beginning: what is torn there is being written, for all that can be known
      EXPECT_TRUE(checked->intact()) << checked->first_damage.text();
      ++checked_to_the_end;
    }
    writer->reset();
    const auto news = (*looks)->refresh();
    ASSERT_TRUE(news) << news.error().text();
    EXPECT_TRUE(*news);
    EXPECT_EQ((*looks)->info().wholeness, Wholeness::crashed);
    const std::uint64_t rows = expectPlain(**looks, acknowledged);
    expectPlainPictures(**looks);
    EXPECT_EQ(expectPlain(**reads, known), known);
    const auto again = (*reads)->refresh();
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_TRUE(*again);
    EXPECT_EQ((*reads)->info().wholeness, Wholeness::crashed);
    EXPECT_EQ((*reads)->info().committed_samples, rows);
    EXPECT_EQ(expectCrashedAndWhole(folder.file(), acknowledged), rows);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(checked_to_the_end, 0U);
}

TEST(CrashRecording, APowerCutLosesNothingAcknowledged) {
  const Folder folder;
  const auto disk = std::make_shared<LoggingDisk>();
  auto writer = createRecording(folder.file(), header(), disk);
  ASSERT_TRUE(writer);
  struct Acknowledged {
    std::size_t calls;
    std::uint64_t rows;
  };
  std::vector<Acknowledged> acknowledged{{disk->calls.size(), 0}};
  for (std::uint64_t row = 0; row < 2600; ++row) {
    ASSERT_TRUE((*writer)->append(plainStep(row)));
    if (row % 700 == 99) {
      ASSERT_TRUE((*writer)->commit());
    }
    acknowledged.push_back({disk->calls.size(), (*writer)->committedSteps()});
  }
  ASSERT_TRUE((*writer)->close());
  acknowledged.push_back({disk->calls.size(), 2600});

  std::mt19937 random(5);
  const std::size_t cuts = countFrom("FYD_POWER_CUTS", 150);
  for (std::size_t i = 0; i < cuts; ++i) {
    std::size_t end = acknowledged[0].calls + random() % (disk->calls.size() - acknowledged[0].calls + 1);
    if (i % 2 == 0)  // just before a sync is when most is at stake
      while (end < disk->calls.size() && !disk->calls[end].sync) ++end;
    std::uint64_t rows = 0;
    for (const Acknowledged& a : acknowledged)
      if (a.calls <= end) rows = std::max(rows, a.rows);
    const std::string after = folder.file("after.h5");
    {
      const auto bytes = diskAfterCut(disk->calls, end, kSector_bytes, random);
      std::ofstream(partialOf(after), std::ios::binary)
          .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    const std::uint64_t found = expectCrashedAndWhole(after, rows);
    const auto recovered = recover(after);
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(recovered->result, RecoverResult::whole) << recovered->first_damage.text();
    EXPECT_EQ(expectCrashedAndWhole(after, rows), found);
    EXPECT_TRUE(othersOpen(after));
    std::filesystem::remove(after);
    ASSERT_FALSE(HasFailure()) << "cut " << i << " after call " << end << " of " << disk->calls.size();
  }
}

TEST(CrashRecording, APowerCutWhileItBeginsNeverCrashesTheReader) {
  const Folder folder;
  const auto disk = std::make_shared<LoggingDisk>();
  ASSERT_TRUE(createRecording(folder.file(), header(), disk));
  std::mt19937 random(6);
  for (std::size_t end = 0; end < disk->calls.size(); end += 1 + disk->calls.size() / 25) {
    const auto bytes = diskAfterCut(disk->calls, end, kSector_bytes, random);
    const std::string after = folder.file("b.h5");
    std::ofstream(after, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const auto recording = Recording::open(after);
    if (recording) {
      EXPECT_EQ((*recording)->info().committed_samples, 0U);
    }
    EXPECT_TRUE(recover(after));
  }
}

/// Refuses from its n-th call on.
class BrokenDisk final : public DiskCalls {
 public:
  BrokenDisk(int good_calls, int error, bool syncs_only) : left_(good_calls), error_(error), syncs_only_(syncs_only) {}
  int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
    if (!syncs_only_ && left_-- <= 0) return error_;
    return DiskCalls::write(file, bytes, at);
  }
  int sync(int) override { return syncs_only_ && left_-- <= 0 ? error_ : 0; }
  int resize(int file, std::uint64_t bytes) override {
    if (!syncs_only_ && left_-- <= 0) return error_;
    return DiskCalls::resize(file, bytes);
  }

 private:
  int left_;
  int error_;
  bool syncs_only_;
};

void expectHonestOn(const std::shared_ptr<DiskCalls>& disk, const char* words, bool& reached_the_end) {
  const Folder folder;
  auto writer = createRecording(folder.file(), header(), disk);
  reached_the_end = false;
  if (!writer) {
    EXPECT_NE(writer.error().text().find("a.h5"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(partialOf(folder.file())));  // the name is free for the next attempt
    return;
  }
  std::uint64_t row = 0;
  Result<void> put;
  for (; row < 1200 && put; ++row) put = (*writer)->append(plainStep(row));
  if (put) put = (*writer)->close();
  reached_the_end = put.has_value();
  if (!put) {
    EXPECT_NE(put.error().text().find(words), std::string::npos) << put.error().text();
    EXPECT_FALSE((*writer)->append(plainStep(row)));  // over is over
    EXPECT_FALSE((*writer)->close());
    EXPECT_FALSE(std::filesystem::exists(folder.file()));
  }
  const std::uint64_t committed = (*writer)->committedSteps();
  writer->reset();
  expectCrashedAndWhole(folder.file(), committed);
}

TEST(CrashRecording, ADiskThatGetsFullIsAnErrorAndLosesNothingCommitted) {
  bool through = false;
  for (int good = 0; !through; good += 13)
    expectHonestOn(std::make_shared<BrokenDisk>(good, ENOSPC, false), "", through);
}

TEST(CrashRecording, ASyncThatFailsIsAnError) {
  bool through = false;
  for (int good = 0; !through; ++good)
    expectHonestOn(std::make_shared<BrokenDisk>(good, EIO, true), "Input/output error", through);
}

/// Runs `work` in a process of its own, whose limits may be anything. @return its exit code
template <class Work>
int inOwnProcess(Work&& work) {
  const int status = ChildProcess(std::forward<Work>(work)).wait();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + status;
}

TEST(CrashRecording, AFileThatMayNotGrowIsAnError) {
  const Folder folder;
  const int code = inOwnProcess([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    auto writer = RecordingWriter::create(folder.file(), header());
    if (!writer) return 1;
    const rlimit limit{(*writer)->bytes() + 60'000, (*writer)->bytes() + 60'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    RandomSteps random(3);
    for (int i = 0; i < 20'000; ++i)
      if (const auto put = (*writer)->append(random.next()); !put)
        return put.error().text().find(folder.file()) == 0 ? 0 : 2;
    return 3;
  });
  EXPECT_EQ(code, 0);
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ((*recording)->info().wholeness, Wholeness::crashed);
}

TEST(CrashRecording, NoFileHandleLeftIsAnError) {
  const Folder folder;
  EXPECT_EQ(inOwnProcess([&] {
              const int next = ::dup(0);
              ::close(next);
              const rlimit limit{static_cast<rlim_t>(next), static_cast<rlim_t>(next)};
              ::setrlimit(RLIMIT_NOFILE, &limit);
              const auto writer = RecordingWriter::create(folder.file(), header());
              if (writer) return 1;
              return Recording::open(folder.file()) ? 2 : 0;
            }),
            0);
}

TEST(CrashRecording, PlacesThatCannotHoldARecording) {
  const Folder folder;
  const auto refused = [](const std::string& path) {
    const auto writer = RecordingWriter::create(path, header());
    return writer ? std::string() : writer.error().text();
  };
  EXPECT_NE(refused(folder.file("none/a.h5")), "");
  EXPECT_NE(refused("/proc/a.h5"), "");
  std::ofstream(folder.file("file")) << "x";
  EXPECT_NE(refused(folder.file("file/a.h5")), "");
  EXPECT_NE(refused(folder.file("file")).find("exists"), std::string::npos);
  std::ofstream(folder.file("b.h5.partial")) << "x";
  EXPECT_NE(refused(folder.file("b.h5")).find("b.h5.partial: exists"), std::string::npos);
  std::filesystem::create_symlink("nowhere", folder.file("c.h5"));
  EXPECT_NE(refused(folder.file("c.h5")).find("exists"), std::string::npos);
  for (const char* notes : {"d.h5.notes.json", "e.h5.partial.notes.json"}) {
    std::ofstream(folder.file(notes)) << "{}";
    const std::string own = folder.file(std::string(notes).substr(0, 4));
    EXPECT_NE(refused(own).find("notes of another recording"), std::string::npos) << notes;
    EXPECT_FALSE(std::filesystem::exists(own + ".partial"));
  }
}

TEST(CrashRecording, ANameTakenMeanwhileIsNotReplaced) {
  const Folder folder;
  auto writer = RecordingWriter::create(folder.file(), header());
  ASSERT_TRUE(writer);
  for (std::uint64_t row = 0; row < 300; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
  std::ofstream(folder.file()) << "somebody else's";
  EXPECT_FALSE((*writer)->close());
  EXPECT_EQ(std::filesystem::file_size(folder.file()), 15U);
  const auto recording = Recording::open(partialOf(folder.file()));
  ASSERT_TRUE(recording);
  expectPlain(**recording, 300);
}

TEST(CrashRecording, AnotherFileInItsPlaceIsNotGivenItsName) {
  const Folder folder;
  auto writer = RecordingWriter::create(folder.file(), header());
  ASSERT_TRUE(writer);
  for (std::uint64_t row = 0; row < 300; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
  EXPECT_TRUE((*writer)->safe());
  std::filesystem::remove(partialOf(folder.file()));
  std::ofstream(partialOf(folder.file())) << "somebody else's";
  EXPECT_FALSE((*writer)->safe());
  EXPECT_FALSE((*writer)->close());
  EXPECT_FALSE(std::filesystem::exists(folder.file()));
  EXPECT_EQ(std::filesystem::file_size(partialOf(folder.file())), 15U);
}

TEST(CrashRecording, AFolderThatGoesIsAnErrorAtTheEnd) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() + "/in");
  auto writer = RecordingWriter::create(folder.file("in/a.h5"), header());
  ASSERT_TRUE(writer);
  std::filesystem::remove_all(folder.path() + "/in");
  for (std::uint64_t row = 0; row < 300; ++row) (void)(*writer)->append(plainStep(row));
  EXPECT_FALSE((*writer)->close());
}

}  // namespace
}  // namespace fyd::recording
