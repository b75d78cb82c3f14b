// A scene in the step: its copies, its texture, and its state for display.
#include "core/scene/felt_scene.h"

#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "core/scene/scene_stage.h"
#include "tests/unit/scene/loaded.h"

namespace fyd::scene {
namespace {

const std::string kBody = "[[body]]\nmesh = \"square.obj\"\n";

TEST(FeltScene, ASlidingFingerIsShakenByTheBodysTexture) {
  FeltScene scene = felt(loaded(kBody + "contact = \"facet\"\n", {shapes::plane(50.0, 4)}, ribbed()));
  const auto rms = [&scene](double speed_mm_s, double z_mm, double from_s) {
    double squares = 0.0;
    for (int i = 0; i < 400; ++i) {
      scene.step({-20.0 + 1e-3 * speed_mm_s * i, 0.3, z_mm}, from_s + 1e-3 * i);
      if (i >= 200) squares += scene.texture_g() * scene.texture_g();  // the speed has settled
    }
    return std::sqrt(squares / 200.0);
  };
  EXPECT_GT(rms(80.0, -2.0, 0.0), 0.05);
  EXPECT_LT(rms(0.0, -2.0, 1.0), 0.02);  // it rings down
  EXPECT_EQ(rms(80.0, 1.0, 2.0), 0.0);   // in the air
  scene.step({0.0, 0.0, NAN}, 3.0);
  EXPECT_EQ(scene.texture_g(), 0.0);
}

TEST(FeltScene, ATouchAtRestIsSilentWhateverTheLastStrokeLeft) {
  const auto scene = loaded(kBody + "contact = \"facet\"\n", {shapes::plane(50.0, 4)}, ribbed());
  for (const Vec3& away_mm : {Vec3{9.9, 0.3, 1.0}, Vec3{NAN, 0.0, 0.0}}) {
    FeltScene stroked = felt(scene);
    double loudest_g = 0.0;
    for (int i = 0; i < 300; ++i) {
      stroked.step({-20.0 + 0.1 * i, 0.3, -2.0}, 1e-3 * i);
      loudest_g = std::max(loudest_g, std::abs(stroked.texture_g()));
    }
    EXPECT_GT(loudest_g, 0.1);
    stroked.step(away_mm, 0.3);
    EXPECT_EQ(stroked.texture_g(), 0.0);
    for (int i = 0; i < 50; ++i) {
      stroked.step({9.9, 0.3, -2.0}, 0.301 + 1e-3 * i);
      EXPECT_TRUE(stroked.touch().touching);
      EXPECT_EQ(stroked.texture_g(), 0.0) << i;
    }
  }
}

TEST(FeltScene, ABodyThatFliesIsSlidOverByItsOwnSpeed) {
  const auto rms = [](double body_mm_s, double finger_mm_s) {
    FeltScene scene =
        felt(loaded(fmt::format("{}contact = \"facet\"\nvelocity_mm_per_s = [{}, 0, 0]\n", kBody, body_mm_s),
                    {shapes::plane(50.0, 4)}, ribbed()));
    double squares = 0.0;
    for (int i = 0; i < 400; ++i) {
      scene.step({1e-3 * finger_mm_s * i, 0.3, -2.0}, 1e-3 * i);
      if (i >= 200) squares += scene.texture_g() * scene.texture_g();
    }
    return std::sqrt(squares / 200.0);
  };
  EXPECT_GT(rms(80.0, 0.0), 0.05);
  EXPECT_LT(rms(80.0, 80.0), 1e-6);
}

TEST(FeltScene, WhereTimeDoesNotPassNothingVibratesAndAClockThatIsSetBackGoesOn) {
  FeltScene scene = felt(loaded(kBody + "contact = \"facet\"\n", {shapes::plane(50.0, 4)}, ribbed()));
  for (int i = 0; i < 300; ++i) scene.step({-20.0 + 0.1 * i, 0.3, -2.0}, 1000.0 + 1e-3 * i);
  EXPECT_NE(scene.texture_g(), 0.0);
  for (const double late_s : {1000.299, 1000.2, 999.5}) {
    EXPECT_TRUE(scene.step({10.0, 0.3, 1.0}, late_s).touching) << "the last touch again";
    EXPECT_EQ(scene.texture_g(), 0.0);
  }
  EXPECT_TRUE(scene.step({10.0, 0.3, 1.0}, 5.0).touching) << "the clock was set back in this step";
  EXPECT_FALSE(scene.step({10.0, 0.3, 1.0}, 5.001).touching);
  EXPECT_NEAR(scene.scene().time_s(), 0.3, 1e-9);
  EXPECT_TRUE(scene.step({10.0, 0.3, -2.0}, 5.002).touching);
}

TEST(FeltScene, WhatDoesNotFitTogetherIsRefused) {
  const auto whole = loaded(kBody + "name = \"plate\"\n", {shapes::plane(50.0, 4)});
  const std::vector<BodyModel> one(1);
  const auto refusal = [](const Result<FeltScene>& built) { return built ? "built" : built.error().text(); };
  const auto with = [&whole](auto&& change) {
    auto out = std::make_shared<LoadedScene>(*whole);
    change(*out);
    return out;
  };
  const auto refusals = [&](const std::shared_ptr<const LoadedScene>& wrong) {
    std::string with_chosen_models = refusal(FeltScene::build(wrong, 1000.0));
    EXPECT_EQ(with_chosen_models, refusal(FeltScene::build(wrong, one, 1000.0)));
    return with_chosen_models;
  };
  EXPECT_EQ(refusals(with([](LoadedScene& scene) { scene.meshes.clear(); })),
            "scene: 0 meshes; expected 1, as there are bodies");
  EXPECT_EQ(refusals(with([](LoadedScene& scene) { scene.textures.clear(); })),
            "scene: 0 textures; expected 1, as there are bodies");
  EXPECT_EQ(refusals(with([](LoadedScene& scene) { scene.meshes = {nullptr}; })), "plate: no mesh; expected one");
  EXPECT_EQ(refusals(with([](LoadedScene& scene) {
              scene.meshes = {std::make_shared<const SearchedMesh>(shapes::built(shapes::plane(50.0, 4)), false)};
            })),
            "plate: its mesh is not walkable; expected one for a rigid body");
  EXPECT_EQ(refusal(FeltScene::build(whole, {}, 1000.0)), "scene: 0 models; expected 1, as there are bodies");
  for (const double rate_Hz : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(refusal(FeltScene::build(whole, rate_Hz)), fmt::format("rate = {} Hz: expected more than 0", rate_Hz));
  }
}

TEST(FeltScene, ACopyGoesItsOwnWay) {
  const FeltScene original = felt(loaded(kBody + "contact = \"proxy\"\nstatic_friction = 0.8\nkinetic_friction = 0.6\n",
                                         {shapes::bumps(30)}, ribbed()));
  FeltScene one = original, two = original;
  for (int i = 0; i < 50; ++i) one.step({0.1 * i, 3.0, 1.0 - 0.05 * i}, 1e-3 * i);
  EXPECT_TRUE(one.touch().touching);
  EXPECT_FALSE(two.touch().touching);
  for (int i = 0; i < 50; ++i) two.step({0.1 * i, 3.0, 1.0 - 0.05 * i}, 1e-3 * i);
  EXPECT_EQ(one.touch().force_N, two.touch().force_N);
  EXPECT_EQ(one.texture_g(), two.texture_g());
}

TEST(SceneStage, WhatIsTouchedIsShown) {
  FeltScene scene =
      felt(loaded(kBody + "contact = \"facet\"\nstiffness_N_per_mm = 0.5\nvelocity_mm_per_s = [100, 0, 0]\n",
                  {shapes::plane(10.0, 1)}));
  SceneStage stage(scene.loaded());
  EXPECT_EQ(stage.scene().meshes.size(), 1U);
  EXPECT_FALSE(stage.newest().stepped);
  const auto stepped = [&](const Vec3& at_mm, double time_s) -> const SceneMoment& {
    scene.step(at_mm, time_s);
    stage.show(scene);
    return stage.newest();
  };
  EXPECT_TRUE(stepped({1.0, 2.0, 3.0}, 3600.0).stepped);
  EXPECT_FALSE(stage.newest().touch.touching);
  const SceneMoment& now = stepped({1.0, 2.0, -2.0}, 3600.02);
  EXPECT_EQ(now.point_mm, (Vec3{1.0, 2.0, -2.0}));
  EXPECT_TRUE(now.touch.touching);
  EXPECT_NEAR(now.touch.force_N.z, 1.0, 1e-12);  // 2 mm deep
  EXPECT_NEAR(now.touch.proxy_mm.z, 0.0, 1e-12);
  EXPECT_NEAR(now.time_s, 0.02, 1e-9);
  EXPECT_NEAR(stage.placements()[0].toScene({}, now.time_s).x, 2.0, 1e-6);
  EXPECT_TRUE(now.shapes_mm[0].empty());  // rigid
}

TEST(SceneStage, ShownAtMostAboutSixtyTimesASecond) {
  FeltScene scene = felt(loaded(kBody + "contact = \"facet\"\n", {shapes::plane(10.0, 1)}));
  SceneStage stage(scene.loaded());
  int changes = 0;
  double last_s = -1.0;
  for (int ms = 0; ms < 1000; ++ms) {
    scene.step({0.0, 0.0, 1.0}, 0.001 * ms + 1e-9);
    stage.show(scene);
    const double now_s = stage.newest().time_s;
    changes += now_s == last_s ? 0 : 1;
    last_s = now_s;
  }
  EXPECT_NEAR(changes, 62, 1);
}

const std::string kSoft = kBody + "soft = true\nstiffness_N_per_mm = 0.5\nspread_mm = 5\nfinger_mm = 5\n";

TEST(SceneStage, APressedSoftBodysShapeIsShown) {
  FeltScene scene = felt(loaded(kSoft, {shapes::plane(10.0, 1)}));
  SceneStage stage(scene.loaded());
  scene.step({0.0, 0.0, 5.0}, 0.0);
  stage.show(scene);
  EXPECT_TRUE(stage.newest().shapes_mm[0].empty());  // at rest
  for (int ms = 1; ms <= 200; ++ms) {
    scene.step({0.0, 0.0, -1.0}, 1e-3 * ms);
    stage.show(scene);
  }
  const std::vector<Vec3>& shape_mm = stage.newest().shapes_mm[0];
  ASSERT_EQ(shape_mm.size(), 4U);
  double lowest_mm = 0.0;
  for (const Vec3& each : shape_mm) lowest_mm = std::min(lowest_mm, each.z);
  EXPECT_LT(lowest_mm, -0.05);
}

TEST(SceneStage, TheThreadThatStepsAllocatesNothingAndEveryVertexIsShownWhereItIs) {
  FeltScene scene = felt(loaded(kSoft + kBody + "contact = \"facet\"\nposition_mm = [0, 0, -50]\n" + kSoft,
                                {shapes::plane(40.0, 60), shapes::plane(10.0, 1), shapes::plane(30.0, 20)}));
  SceneStage stage(scene.loaded());
  std::uint64_t allocated = 0;
  std::size_t most_awake = 0, compared = 0;
  for (int ms = 0; ms <= 6000; ++ms) {
    // Presses and slides, with pauses in which all of it comes to rest; now and then nobody looks for a while.
    const bool pressed = ms % 3000 < 1000;
    const Vec3 at_mm = {-15.0 + 0.02 * (ms % 3000), 3.0, pressed ? -2.0 : 5.0};
    const bench::AllocationCount counted;
    scene.step(at_mm, 1e-3 * ms);
    stage.show(scene);
    allocated += counted.count();
    most_awake = std::max(most_awake, scene.scene().soft(0)->awake().size());
    if (ms % 700 >= 350) continue;
    const SceneMoment& now = stage.newest();
    if (now.time_s != scene.scene().time_s()) continue;  // of an earlier step
    ASSERT_TRUE(now.shapes_mm[1].empty());
    for (const std::size_t body : {0U, 2U}) {
      const auto rest_mm = scene.scene().mesh(body).vertices();
      const std::vector<Vec3>& shape_mm = now.shapes_mm[body];
      if (shape_mm.empty()) continue;
      ASSERT_EQ(shape_mm.size(), rest_mm.size());
      for (std::uint32_t v = 0; v < rest_mm.size(); ++v) {
        ASSERT_EQ(shape_mm[v], rest_mm[v] + scene.scene().soft(body)->displacement_mm(v)) << ms << " ms, " << v;
      }
      ++compared;
    }
  }
  EXPECT_EQ(allocated, 0U);
  EXPECT_GT(most_awake, 50U);
  EXPECT_LT(most_awake, scene.scene().mesh(0).vertices().size());
  EXPECT_GT(compared, 100U);
}

}  // namespace
}  // namespace fyd::scene
