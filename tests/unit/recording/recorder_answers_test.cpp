// What the recorder answers when it cannot do what it was asked: a name for a subject, a second recording, a disk that
// fails in the worst moment or does not answer. Each time the file is looked at afterwards.
#include <cerrno>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/pipeline/pipeline.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/writer/recorder.h"
#include "refusal.h"
#include "tests/files_of_at_most.h"
#include "tests/temporary_folder.h"
#include "tests/wait.h"
#include "troubled_disk.h"

namespace fyd::recording {
namespace {

using testing::HasSubstr;

/// Answers no sync while its gate is shut.
class GatedDisk final : public TroubledDisk {
 public:
  int sync(int file) override {
    {
      std::unique_lock lock(mutex_);
      waits_ = shut_;
      opened_.wait(lock, [this] { return !shut_; });
      waits_ = false;
    }
    return TroubledDisk::sync(file);
  }
  void shut() {
    const std::lock_guard lock(mutex_);
    shut_ = true;
  }
  void open() {
    const std::lock_guard lock(mutex_);
    shut_ = false;
    opened_.notify_all();
  }
  [[nodiscard]] bool waits() const {
    const std::lock_guard lock(mutex_);
    return waits_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable opened_;
  bool shut_ = false;
  bool waits_ = false;
};

/// A recorder, and the loop that feeds it.
class Fed {
 public:
  explicit Fed(const RecorderOptions& options = {}, const pipeline::LocalModel& local = {},
               std::function<std::optional<LinkRow>()> link = {})
      : pipeline_(pipeline::Parameters(), local),
        recorder(options, {}, local, {},
                 {.profile = [](const auto&) { return std::string(); }, .link = std::move(link)}) {
    recorder.writeThrough(disk);
    recorder.start();
  }
  ~Fed() { disk->open(); }  // else its thread never ends
  Fed(const Fed&) = delete;
  Fed& operator=(const Fed&) = delete;

  void push(int count) {
    for (int i = 0; i < count; ++i) {
      pipeline::Inputs inputs;
      inputs.now = instantAt(100.0) + std::chrono::milliseconds(pushed_++);
      const pipeline::Outputs& outputs = pipeline_.step(inputs);
      recorder.push({.inputs = inputs, .outputs = outputs});
    }
  }
  void pushAndWait(int count) {
    push(count);
    ASSERT_TRUE(comesTrue("the recorder to take its steps", [this] { return recorder.status().taken >= pushed_; }));
  }

 private:
  pipeline::Pipeline pipeline_;
  std::uint64_t pushed_ = 0;

 public:
  std::shared_ptr<GatedDisk> disk = std::make_shared<GatedDisk>();
  Recorder recorder;
};

class RecorderAnswers : public testing::Test {
 protected:
  /// What a reader finds in a file, which may be the growing one.
  static std::uint64_t committedIn(const std::string& path, Wholeness expected) {
    const auto found = Recording::open(path);
    EXPECT_TRUE(found) << (found ? "" : found.error().text());
    if (!found) return 0;
    EXPECT_EQ((*found)->info().wholeness, expected);
    return (*found)->info().committed_samples;
  }

  Folder folder;
  std::string path = folder.file();
};

TEST_F(RecorderAnswers, ASubjectsNameIsRefusedBeforeAFileIsMade) {
  Fed fed;
  EXPECT_THAT(refusal(fed.recorder.begin({.path = path, .subject = "Ada Lovelace"})), HasSubstr("never a name"));
  EXPECT_EQ(fed.recorder.status().state, RecorderState::idle);
  EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
}

TEST_F(RecorderAnswers, OfTwoRecordingsBegunAtOnceTheSecondIsRefused) {
  Fed fed;
  fed.disk->shut();
  Result<void> first = fail("not answered");
  std::thread other([&] { first = fed.recorder.begin({.path = path}); });
  const auto reached = comesTrue("the first to be made", [&] { return fed.disk->waits(); });
  const std::string second = refusal(fed.recorder.begin({.path = folder.file("b.h5")}));
  fed.disk->open();
  other.join();
  ASSERT_TRUE(reached);
  EXPECT_THAT(second, HasSubstr("b.h5: another recording is being started"));
  EXPECT_TRUE(first) << refusal(first);
  EXPECT_TRUE(fed.recorder.end());
  EXPECT_THAT(namesIn(folder.path()), testing::ElementsAre("a.h5"));
}

TEST_F(RecorderAnswers, NoStepIsLostToASlowDiskHoweverShortThePreTriggerIs) {
  for (const double pre_trigger_s : {0.0, 1.0}) {
    Fed fed({.pre_trigger_s = pre_trigger_s});
    const std::string file = folder.file(fmt::format("{}.h5", pre_trigger_s));
    ASSERT_TRUE(fed.recorder.begin({.path = file}));
    fed.disk->shut();
    fed.push(300);
    ASSERT_TRUE(comesTrue("the first commit", [&] { return fed.disk->waits(); }));
    fed.push(5000);  // the loop goes on for five seconds
    fed.disk->open();
    fed.pushAndWait(1);
    ASSERT_TRUE(fed.recorder.end());
    EXPECT_EQ(fed.recorder.status().lost, 0U);
    const auto made = Recording::open(file);
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_EQ((*made)->info().committed_samples, 5301U) << pre_trigger_s;
    EXPECT_EQ((*made)->info().gaps, 0U);
  }
}

TEST_F(RecorderAnswers, StepsLostWhileTheFileIsMadeAreShownAndStandInTheFile) {
  Fed fed;
  fed.pushAndWait(100);
  fed.disk->shut();
  Result<void> begun = fail("not answered");
  std::thread other([&] { begun = fed.recorder.begin({.path = path}); });
  const auto reached = comesTrue("the file to be made", [&] { return fed.disk->waits(); });
  fed.push(20'000);  // more than the ring holds, and nobody takes them
  fed.disk->open();
  other.join();
  ASSERT_TRUE(reached);
  ASSERT_TRUE(begun) << refusal(begun);
  ASSERT_TRUE(comesTrue("the loss to be shown", [&] { return fed.recorder.status().lost > 0; }));
  const std::uint64_t lost = fed.recorder.status().lost;
  ASSERT_TRUE(fed.recorder.end());
  const auto made = Recording::open(path);
  ASSERT_TRUE(made) << made.error().text();
  EXPECT_EQ((*made)->info().gaps, lost) << "though no later step shows the gap";
  EXPECT_EQ((*made)->info().committed_samples, 20'100U - lost);
}

TEST_F(RecorderAnswers, ANoteWhileTheFileIsClosedIsInItOrRefused) {
  Fed fed;
  ASSERT_TRUE(fed.recorder.begin({.path = path}));
  fed.pushAndWait(100);
  ASSERT_TRUE(fed.recorder.note(NoteKind::note, "before"));
  fed.disk->shut();
  std::thread ends([&] { EXPECT_TRUE(fed.recorder.end()); });
  const auto reached = comesTrue("the closing", [&] { return fed.disk->waits(); });
  const Result<void> late = fed.recorder.note(NoteKind::note, "late");
  fed.disk->open();
  ends.join();
  ASSERT_TRUE(reached);
  const auto made = Recording::open(path);
  ASSERT_TRUE(made) << made.error().text();
  EXPECT_EQ((*made)->notes()->size(), late ? 2U : 1U);
  EXPECT_FALSE(fed.recorder.note(NoteKind::note, "after"));
}

TEST_F(RecorderAnswers, TheSurfaceThatIsFeltStandsInTheFile) {
  texture::SurfaceModel surface{.name = "velvet", .description = "soft"};
  surface.bands = {{.frequency_Hz = 80.0, .quality = 2.0, .rms_g = 0.1}};
  Fed fed({}, {.surface = surface, .scene = nullptr});
  fed.pushAndWait(10);
  ASSERT_TRUE(fed.recorder.begin({.path = path}));
  ASSERT_TRUE(fed.recorder.end());
  EXPECT_EQ(fed.recorder.status().differences, 0U);
  const auto recording = Recording::open(path);
  ASSERT_TRUE(recording) << recording.error().text();
  const auto read = texture::parseSurface((*recording)->info().header.surface, path);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->name, "velvet");
  ASSERT_EQ(read->bands.size(), 1U);
  EXPECT_EQ(read->bands[0].frequency_Hz, 80.0);
}

TEST_F(RecorderAnswers, ADiskThatFailsWhileARecordingIsEndedForWantOfRoomDoesNotMakeItWhole) {
  // Of 100 steps all are written when the room is looked at, and closing fails; of 2000 the next block fails before.
  constexpr double kSmallest_MB = 10.0;
  for (const auto& [steps, committed] : {std::pair{100, 0U}, {2'000, 250U}}) {
    SCOPED_TRACE(steps);
    const std::string file = folder.file(std::to_string(steps) + ".h5");
    GatedDisk* disk = nullptr;
    Fed fed({.smallest_free_MB = kSmallest_MB}, {}, [&]() -> std::optional<LinkRow> {
      disk->trouble = EIO;  // asked once a second, just before the room is looked at
      return std::nullopt;
    });
    disk = fed.disk.get();
    fed.pushAndWait(steps);
    {
      const FilesOfAtMost little(static_cast<rlim_t>(1e6 * kSmallest_MB));  // it may begin, and then has too little
      ASSERT_TRUE(fed.recorder.begin({.path = file}));
      ASSERT_TRUE(comesTrue("the end", [&] { return fed.recorder.status().state == RecorderState::failed; }));
    }
    EXPECT_THAT(fed.recorder.status().problem.text(), HasSubstr("Input/output error"));
    EXPECT_THAT(fed.recorder.status().problem.text(), HasSubstr("fyd session recover"));
    EXPECT_THAT(fed.recorder.status().problem.text(), testing::Not(HasSubstr("is whole")));
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_EQ(committedIn(partialOf(file), Wholeness::crashed), committed);
  }
}

TEST_F(RecorderAnswers, AFolderThatGoesEndsTheRecordingAndIsNamed) {
  const std::string inner = folder.file("in");
  std::filesystem::create_directory(inner);
  Fed fed({}, {}, [&]() -> std::optional<LinkRow> {
    std::filesystem::rename(inner, folder.file("moved"));
    return std::nullopt;
  });
  fed.pushAndWait(300);
  ASSERT_TRUE(fed.recorder.begin({.path = inner + "/a.h5"}));
  ASSERT_TRUE(comesTrue("the end", [&] { return fed.recorder.status().state == RecorderState::failed; }));
  EXPECT_THAT(fed.recorder.status().problem.text(), HasSubstr(inner + ": No such file or directory"));
  EXPECT_EQ(committedIn(folder.file("moved/a.h5.partial"), Wholeness::crashed), 250U);
}

TEST_F(RecorderAnswers, ADiskThatFailsWhenTheProgramEndsLeavesWhatWasCommitted) {
  Fed fed;
  fed.pushAndWait(300);
  ASSERT_TRUE(fed.recorder.begin({.path = path}));
  ASSERT_TRUE(comesTrue("300 written steps", [&] { return fed.recorder.status().samples == 300; }));
  fed.disk->trouble = EIO;
  fed.recorder.shutDown();
  EXPECT_EQ(fed.recorder.status().state, RecorderState::failed);
  EXPECT_THAT(fed.recorder.status().problem.text(), HasSubstr("Input/output error"));
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(committedIn(partialOf(path), Wholeness::crashed), 250U);
  const auto recovered = recover(path);
  ASSERT_TRUE(recovered) << recovered.error().text();
  EXPECT_EQ(recovered->result, RecoverResult::whole);
  EXPECT_EQ(committedIn(path, Wholeness::whole), 250U);
}

TEST_F(RecorderAnswers, AnEndThatMeetsAFailedRecordingSaysWhatIsSafe) {
  // The disk fails while the end waits for its answer; should the recorder find that before it is asked, once more.
  std::string words;
  for (int attempt = 0; attempt < 50 && words.find("fyd session recover") == std::string::npos; ++attempt) {
    const std::string file = folder.file(std::to_string(attempt) + ".h5");
    Fed fed;
    fed.pushAndWait(100);
    ASSERT_TRUE(fed.recorder.begin({.path = file}));
    ASSERT_TRUE(comesTrue("100 written steps", [&] { return fed.recorder.status().samples == 100; }));
    fed.disk->trouble = EIO;
    fed.push(150);  // the last of them makes the block that is committed
    words = refusal(fed.recorder.end());
    ASSERT_NE(words, "");
    EXPECT_EQ(fed.recorder.status().state, RecorderState::failed);
    EXPECT_EQ(committedIn(partialOf(file), Wholeness::crashed), 0U);
  }
  EXPECT_THAT(words, HasSubstr("Input/output error"));
  EXPECT_THAT(words, HasSubstr("fyd session recover"));
}

// Waits as long as the recorder does: half a minute.
TEST_F(RecorderAnswers, ADiskThatDoesNotAnswerIsToldAndWhatItThenDoesIsPutInOrder) {
  Fed begins, fails, ends;
  const std::string ended = folder.file("ended.h5");
  ASSERT_TRUE(ends.recorder.begin({.path = ended}));
  ends.disk->shut();
  ends.push(300);
  ASSERT_TRUE(comesTrue("the commit", [&] { return ends.disk->waits(); }));
  std::array<std::string, 2> said;  // asked twice while it waits
  std::vector<std::thread> asking;
  asking.reserve(said.size());
  for (std::string& words : said) asking.emplace_back([&] { words = refusal(ends.recorder.end()); });

  begins.disk->shut();
  fails.disk->shut();
  const std::string failing = folder.file("failing.h5");
  std::string failed;
  asking.emplace_back([&] { failed = refusal(fails.recorder.begin({.path = failing})); });
  const std::string begun = refusal(begins.recorder.begin({.path = path}));
  for (std::thread& each : asking) each.join();
  fails.disk->trouble = EIO;
  for (const Fed* each : {&begins, &fails, &ends}) each->disk->open();
  EXPECT_EQ(begun, path + ": the disk does not answer; a file that it still makes is closed at once");
  EXPECT_EQ(failed, failing + ": the disk does not answer; a file that it still makes is closed at once");
  for (const std::string& words : said)
    EXPECT_EQ(words, ended + ": the disk does not answer; the file is closed when it does");

  ASSERT_TRUE(comesTrue("the file to be closed", [&] { return ends.recorder.status().state == RecorderState::idle; }));
  EXPECT_EQ(committedIn(ended, Wholeness::whole), 300U);
  ASSERT_TRUE(comesTrue("what was begun to be ended", [&] {
    return std::filesystem::exists(path) && begins.recorder.status().state == RecorderState::idle;
  }));
  EXPECT_EQ(committedIn(path, Wholeness::whole), 0U);
  ASSERT_TRUE(begins.recorder.begin({.path = folder.file("next.h5")}));
  EXPECT_TRUE(begins.recorder.end());

  std::string other;
  ASSERT_TRUE(comesTrue("the beginning that failed to be over", [&] {
    other = refusal(fails.recorder.begin({.path = folder.file("other.h5")}));
    return other.find("is being started") == std::string::npos;
  }));
  EXPECT_THAT(other, HasSubstr("Input/output error"));
  fails.disk->trouble = 0;
  ASSERT_TRUE(fails.recorder.begin({.path = failing})) << "nothing of it is left in the way";
  EXPECT_TRUE(fails.recorder.end());
}

}  // namespace
}  // namespace fyd::recording
