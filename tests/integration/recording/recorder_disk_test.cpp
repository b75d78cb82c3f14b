// The disk fails during a recording: the error is reported, committed data stay readable, the session continues.
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>

#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "tests/integration/recording/recorder_replay_fixture.h"
#include "tests/unit/recording/troubled_disk.h"
#include "tests/wait.h"

namespace fyd::recording {
namespace {

using testing::HasSubstr;

class RecorderOnATroubledDisk : public Recorded {
 protected:
  void SetUp() override {
    Recorded::SetUp();
    disk = troubled;
    startRecorder();
    run(0.5);
    ASSERT_TRUE(recorder->begin({.path = file("a.h5")}));
    run(1.5);
    ASSERT_TRUE(comesTrue("1000 committed steps", [this] {
      const auto growing = Recording::open(file("a.h5"));
      committed = growing ? (*growing)->info().committed_samples : 0;
      return committed >= 1000;
    }));
  }

  /// Once the recorder has met the trouble.
  void expectHonest(const std::string& why) {
    for (int i = 0; i < 1000 && recorder->status().state == RecorderState::recording; ++i) run(0.1);
    const RecorderStatus status = recorder->status();
    ASSERT_EQ(status.state, RecorderState::failed);
    EXPECT_THAT(status.problem.text(), HasSubstr(why));
    EXPECT_THAT(status.problem.text(), HasSubstr("a.h5.partial"));
    EXPECT_THAT(status.problem.text(), HasSubstr("fyd session recover"));
    const std::size_t before = samples.size();
    run(0.5);
    EXPECT_EQ(samples.size(), before + 500) << "the loop goes on";
    EXPECT_EQ(recorder->status().lost, 0U);
    EXPECT_EQ(recorder->status().differences, 0U);
    EXPECT_FALSE(recorder->note(NoteKind::bookmark, "too late"));

    const auto recovered = recover(file("a.h5"));
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(recovered->result, RecoverResult::whole);
    const auto recording = open("a.h5");
    ASSERT_TRUE(recording);
    ASSERT_GE(recording->info().committed_samples, committed) << "what was acknowledged";
    for (std::uint64_t row = 0; row < recording->info().committed_samples; row += 50) {
      const auto step = recording->step(row);
      ASSERT_TRUE(step) << step.error().text();
      EXPECT_EQ(step->telemetry.step, samples[row].step);
      EXPECT_EQ(step->telemetry.force_N, samples[row].force_N);
    }

    troubled->trouble = 0;
    troubled->full_at = std::numeric_limits<std::uint64_t>::max();
    ASSERT_TRUE(recorder->begin({.path = file("b.h5")})) << "on a disk that works again";
    run(0.3);
    ASSERT_TRUE(recorder->end());
  }

  std::shared_ptr<TroubledDisk> troubled = std::make_shared<TroubledDisk>();
  std::uint64_t committed = 0;
};

TEST_F(RecorderOnATroubledDisk, ThatBecomesFullKeepsWhatWasAcknowledged) {
  troubled->full_at = std::filesystem::file_size(file("a.h5.partial")) + 50'000;
  expectHonest("No space left on device");
}

TEST_F(RecorderOnATroubledDisk, ThatIsPulledOutKeepsWhatWasAcknowledged) {
  troubled->trouble = EIO;
  expectHonest("Input/output error");
}

TEST_F(RecorderOnATroubledDisk, ThatCannotReadItsMediumIsNotTakenForAnotherProgramsDeed) {
  troubled->trouble = ENODATA;
  expectHonest("No data available");
}

/// Another program does something to the file: it ends failed, and nothing is called whole or safe.
class RecorderWhoseFileIsTouched : public RecorderOnATroubledDisk {
 protected:
  void expectNothingPromised(const testing::Matcher<const std::string&>& why) {
    EXPECT_TRUE(comesTrue("the recorder to see it, unasked",
                          [this] { return recorder->status().state == RecorderState::failed; }));
    EXPECT_FALSE(recorder->end());
    const RecorderStatus status = recorder->status();
    EXPECT_EQ(status.state, RecorderState::failed);
    EXPECT_THAT(status.problem.text(), why);
    EXPECT_THAT(status.problem.text(), HasSubstr("Nothing is promised of " + file("a.h5") + ".partial"));
    EXPECT_THAT(status.problem.text(), testing::Not(HasSubstr("is safe in")));
    EXPECT_FALSE(std::filesystem::exists(file("a.h5")));
  }
  std::string partial() const { return file("a.h5.partial"); }
  static constexpr const char* kAnother = "it is not the file any more that was written";
};

TEST_F(RecorderWhoseFileIsTouched, Shortened) {
  // Again where it fell between the recorder's look and its write (RecorderWhoseFileIsShortenedUnseen).
  for (int i = 0; i < 20 && recorder->status().state == RecorderState::recording; ++i) {
    std::filesystem::resize_file(partial(), 1000);
    run(0.1);
  }
  // Whichever of its two looks is first: before a write, or once a second.
  expectNothingPromised(testing::AnyOf(HasSubstr("another program has made the file shorter"), HasSubstr(kAnother)));
}

/// Another program is so quick that the recorder's write makes the file long again, with a hole.
class RecorderWhoseFileIsShortenedUnseen : public RecorderOnATroubledDisk {
 protected:
  struct Shortening : TroubledDisk {
    int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
      struct stat status {};
      const bool behind_its_end = ::fstat(file, &status) == 0 && at >= static_cast<std::uint64_t>(status.st_size);
      if (behind_its_end && shortens.exchange(false)) (void)!::ftruncate(file, 1000);
      return TroubledDisk::write(file, bytes, at);
    }
    std::atomic<bool> shortens = false;
  };
  RecorderWhoseFileIsShortenedUnseen() { troubled = shortening; }
  std::shared_ptr<Shortening> shortening = std::make_shared<Shortening>();
};

TEST_F(RecorderWhoseFileIsShortenedUnseen, IsNotCalledIntactByVerify) {
  shortening->shortens = true;
  for (int i = 0; i < 20 && shortening->shortens; ++i) run(0.1);
  ASSERT_FALSE(shortening->shortens);
  EXPECT_TRUE(recorder->end()) << "it looks at the length only";
  const auto checked = verify(file("a.h5"));
  EXPECT_FALSE(checked && checked->intact());
}

TEST_F(RecorderWhoseFileIsTouched, Renamed) {
  std::filesystem::rename(partial(), file("mine.h5"));
  expectNothingPromised(HasSubstr(kAnother));
  ASSERT_TRUE(recorder->begin({.path = file("a.h5")})) << "the name is free, and the operator begins anew";
  run(0.3);
  EXPECT_TRUE(recorder->end());
}

TEST_F(RecorderWhoseFileIsTouched, Removed) {
  std::filesystem::remove(partial());
  expectNothingPromised(HasSubstr(kAnother));
}

TEST_F(RecorderWhoseFileIsTouched, Replaced) {
  std::filesystem::rename(partial(), file("mine"));
  std::ofstream(partial()) << "another's";
  expectNothingPromised(HasSubstr(kAnother));
  EXPECT_EQ(std::filesystem::file_size(partial()), 9U);
}

}  // namespace
}  // namespace fyd::recording
