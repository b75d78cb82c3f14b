// A disk that runs full while it is recorded to: the recording ends before it does, whole, and says so.
#include <filesystem>
#include <thread>

#include "tests/files_of_at_most.h"
#include "tests/integration/recording/recorder_replay_fixture.h"

namespace fyd::recording {
namespace {

using testing::HasSubstr;

class RecorderOnADiskThatRunsFull : public Recorded {};

TEST_F(RecorderOnADiskThatRunsFull, EndsWholeBeforeItWithAnAlarmAndCanBeginAgain) {
  startRecorder({.smallest_free_MB = 10.0});
  run(0.5);
  ASSERT_TRUE(recorder->begin({.path = file("a.h5")}));
  run(1.5);
  ASSERT_EQ(recorder->status().state, RecorderState::recording);
  {
    const FilesOfAtMost little(recorder->status().bytes + 9'000'000);
    // As slowly as in a session: the room is looked at once a second, and must not be used up before.
    for (int i = 0; i < 1000 && recorder->status().state == RecorderState::recording; ++i) {
      run(0.02);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  const RecorderStatus status = recorder->status();
  {
    const FilesOfAtMost less(9'000'000);
    EXPECT_FALSE(recorder->begin({.path = file("b.h5")})) << "less than 10 MB are left";
  }
  ASSERT_EQ(status.state, RecorderState::failed);
  EXPECT_THAT(status.problem.text(), HasSubstr("the disk has less than 10 MB left: recording stopped"));
  EXPECT_THAT(status.problem.text(), HasSubstr("a.h5 is whole up to here"));
  EXPECT_FALSE(std::filesystem::exists(file("a.h5.partial")));
  const auto recording = open("a.h5");
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->info().wholeness, Wholeness::whole);
  EXPECT_GE(recording->info().committed_samples, 2000U);
  const auto notes = recording->notes();
  ASSERT_TRUE(notes);
  ASSERT_EQ(notes->size(), 1U);
  EXPECT_EQ(notes->front().kind, NoteKind::alarm);
  EXPECT_THAT(notes->front().text, HasSubstr("less than 10 MB"));
  ASSERT_TRUE(recorder->begin({.path = file("c.h5")})) << "on a disk with room again";
  ASSERT_TRUE(recorder->end());
}

}  // namespace
}  // namespace fyd::recording
