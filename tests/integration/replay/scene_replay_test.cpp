// A session with a scene: the recording holds the scene, and a replay computes it again.
#include "core/replay/replay.h"
#include "tests/integration/recording/recorder_replay_fixture.h"
#include "tests/unit/scene/loaded.h"

namespace fyd::replay {
namespace {

using testing::HasSubstr;

std::shared_ptr<const scene::FeltScene> sceneOf(const std::string& body) {
  // Higher than a press goes, wherever the demonstration's finger moves.
  return std::make_shared<const scene::FeltScene>(scene::felt(scene::loaded(
      "[scene]\nname = \"bench\"\n[[body]]\nmesh = \"a.obj\"\n" + body +
          "[[body]]\nmesh = \"b.obj\"\ncontact = \"proxy\"\nposition_mm = [0, 0, -2]\n",
      {scene::shapes::scaled(scene::shapes::bumps(40), 1.5, {0.0, 0.0, -2.0}), scene::shapes::sphere(4.0, 10)},
      scene::ribbed())));
}

class SceneReplay : public recording::Recorded {
 protected:
  std::unique_ptr<recording::Recording> record(const std::string& body) {
    options.local.scene = sceneOf(body);
    options.robot_stiffness_N_per_mm = std::numeric_limits<double>::quiet_NaN();
    startRecorder({.pre_trigger_s = 1.0});
    run(5.0);
    const auto begun = recorder->begin({.path = file("session.h5")});
    EXPECT_TRUE(begun) << (begun ? "" : begun.error().text());
    run(4.0);
    EXPECT_TRUE(recorder->end());
    EXPECT_EQ(recorder->status().differences, 0U);
    return open("session.h5");
  }
  /// The session became Active, and the scene was touched.
  void expectFelt(double least_N) const {
    double most_N = 0.0;
    int active = 0;
    for (const pipeline::TelemetrySample& sample : samples) {
      if (sample.state != pipeline::SafetyState::active) continue;
      ++active;
      most_N = std::max(most_N, sample.robot_force_N);
    }
    EXPECT_GT(active, 5000) << "no robot and no hand target is needed";
    EXPECT_GT(most_N, least_N);
  }
};

TEST_F(SceneReplay, IsIdenticalFromTheMiddleOfASession) {
  const auto recording = record("contact = \"vicinity\"\nstiffness_N_per_mm = 0.6\n");
  ASSERT_TRUE(recording);
  expectFelt(1.0);
  double loudest_g = 0.0;
  for (const pipeline::TelemetrySample& sample : samples) {
    if (sample.state != pipeline::SafetyState::active) continue;
    loudest_g = std::max(loudest_g, std::abs(sample.texture_signal_g));
    if (!(sample.robot_force_N > 0.0)) continue;
    EXPECT_GE(sample.target_N_per_mm, 0.4);
  }
  EXPECT_GT(loudest_g, 0.01);
  const auto result = replay::replay(*recording, {});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->identical) << result->first_difference_s << " s " << result->first_difference_field;
  EXPECT_GE(result->samples, 5000U);
}

TEST_F(SceneReplay, OfASoftBodyIsIdenticalToo) {
  const auto recording = record("soft = true\nstiffness_N_per_mm = 0.6\nspread_mm = 5\nviscosity_Ns_per_mm = 0.001\n");
  ASSERT_TRUE(recording);
  expectFelt(0.5);
  const auto result = replay::replay(*recording, {});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->identical) << result->first_difference_s << " s " << result->first_difference_field;
}

/// A what-if that leads the scene's haptic point another way feels another force: the scene is stepped, not repeated.
TEST_F(SceneReplay, AWhatIfFeelsTheSceneElsewhere) {
  const auto recording = record("contact = \"vicinity\"\nstiffness_N_per_mm = 0.6\n");
  ASSERT_TRUE(recording);
  double furthest_N = 0.0;
  const auto result = replay::replay(*recording, {.settings = {"pipeline.motion_depth_scale=0.5"}},
                                     [&](const pipeline::TelemetrySample& now, const pipeline::TelemetrySample& then) {
                                       furthest_N =
                                           std::max(furthest_N, std::abs(now.robot_force_N - then.robot_force_N));
                                     });
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->what_if);
  EXPECT_GT(furthest_N, 0.5);
}

TEST_F(SceneReplay, AStateIsNotThatOfAnotherScene) {
  const auto pipelineOf = [](const std::string& body) {
    return std::make_unique<pipeline::Pipeline>(pipeline::Parameters{}, pipeline::LocalModel{.scene = sceneOf(body)});
  };
  const std::string state = pipelineOf("contact = \"facet\"\n")->saveState();
  EXPECT_TRUE(pipelineOf("contact = \"facet\"\n")->restoreState(state));
  for (const char* other : {"contact = \"vicinity\"\n", "contact = \"facet\"\nstiffness_N_per_mm = 0.6\n"}) {
    const auto refused = pipelineOf(other)->restoreState(state);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("another surface or scene"));
  }
  EXPECT_FALSE(pipeline::Pipeline(pipeline::Parameters{}).restoreState(state));
}

}  // namespace
}  // namespace fyd::replay
