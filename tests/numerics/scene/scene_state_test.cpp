// Scenes that go on: from bytes as they were built, from a saved state as they were touched. To the bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "core/base/archive.h"
#include "core/base/portable_math.h"
#include "core/scene/scene_bytes.h"
#include "tests/unit/scene/loaded.h"

namespace fyd::scene {
namespace {

std::vector<std::uint64_t> bitsOf(const FeltScene& scene) {
  const SceneTouch& t = scene.touch();
  std::vector<std::uint64_t> bits;
  for (const double value : {t.force_N.x, t.force_N.y, t.force_N.z, t.proxy_mm.x, t.proxy_mm.y, t.proxy_mm.z,
                             t.normal.x, t.normal.y, t.normal.z, t.depth_mm, t.stiffness_N_per_mm,
                             static_cast<double>(t.touching), static_cast<double>(t.body), scene.texture_g()}) {
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  }
  return bits;
}

std::string saved(FeltScene& scene) {
  std::ostringstream bytes;
  StateWriter archive(bytes);
  archive(scene);
  return std::move(bytes).str();
}

void restore(FeltScene& scene, const std::string& state) {
  std::istringstream bytes(state);
  StateReader archive(bytes);
  archive(scene);
}

/// In and out of all that stands around the origin, with leaps now and then.
struct Wander {
  explicit Wander(unsigned seed) : random(seed) {}
  Vec3 next() {
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    t += 1e-3;
    if (random() % 2000 == 0) jump = {20.0 * share(random), 20.0 * share(random), 5.0 * share(random)};
    return jump + Vec3{15.0 * math::sin(3.1 * t), 12.0 * math::sin(4.7 * t), 4.0 * math::sin(9.0 * t)};
  }
  std::mt19937 random;
  double t = 0.0;
  Vec3 jump;
};

struct Case {
  const char* name;
  std::shared_ptr<const LoadedScene> scene;
};

std::vector<Case> cases() {
  const std::string two =
      "[[body]]\nmesh = \"bumps.obj\"\ncontact = \"vicinity\"\nvelocity_mm_per_s = [3, 0, 0]\n"
      "[[body]]\nmesh = \"ball.obj\"\ncontact = \"proxy\"\nradius_mm = 1\nstatic_friction = 0.6\n"
      "kinetic_friction = 0.4\nposition_mm = [10, 0, 2]\nturned_deg = [10, 20, 30]\n";
  return {
      {"rigid", loaded(two, {shapes::bumps(40), shapes::sphere(6.0, 12)}, ribbed())},
      {"nodes and facets", loaded("[[body]]\nmesh = \"a.obj\"\ncontact = \"nodes\"\n[[body]]\nmesh = \"b.obj\"\n"
                                  "contact = \"facet\"\nposition_mm = [0, 0, -3]\n",
                                  {shapes::sphere(15.0, 20), shapes::plane(30.0, 10)})},
      {"soft", loaded("[[body]]\nmesh = \"s.obj\"\nsoft = true\nspread_mm = 4\nviscosity_Ns_per_mm = 0.002\n",
                      {shapes::plane(40.0, 40)})},
      {"swords", loaded("[swords]\nradius_mm = 15\nfriction = 0.3\n", {})},
      {"ball", loaded("[ball]\n[serve]\nz_mm = 100\n", {})},
      {"palpation", loaded("[[body]]\nmesh = \"p.obj\"\n[palpation]\n", {shapes::plane(40.0, 10)})},
  };
}

TEST(SceneState, ASceneGoesOnFromItsStateToTheBit) {
  for (const Case& each : cases()) {
    FeltScene original = felt(each.scene);
    const FeltScene fresh = original;
    std::optional<FeltScene> restored;
    Wander hand(7);
    int touched = 0;
    for (int step = 0; step < 12'000; ++step) {
      if (step % 1700 == 900) {
        const std::string state = saved(original);
        restored.emplace(fresh);
        restore(*restored, state);
        ASSERT_EQ(saved(*restored), state) << each.name;
      }
      const Vec3 probe_mm = hand.next();
      original.step(probe_mm, 1e-3 * step);
      touched += original.touch().touching ? 1 : 0;
      if (!restored) continue;
      restored->step(probe_mm, 1e-3 * step);
      ASSERT_EQ(bitsOf(*restored), bitsOf(original)) << each.name << " at step " << step;
    }
    EXPECT_GT(touched, 100) << each.name;
  }
}

TEST(SceneState, WhatCannotBeIsRefused) {
  for (const Case& each : cases()) {
    FeltScene scene = felt(each.scene);
    Wander hand(3);
    for (int step = 0; step < 500; ++step) scene.step(hand.next(), 1e-3 * step);
    const std::string state = saved(scene);
    std::mt19937 random(11);
    int refused = 0, run = 0;
    for (int i = 0; i < 200; ++i) {
      std::string wrong = state;
      for (int k = 0; k < 4; ++k) wrong[random() % wrong.size()] = static_cast<char>(random());
      FeltScene other = felt(each.scene);
      try {
        restore(other, wrong);
      } catch (const std::exception&) {
        ++refused;
        continue;
      }
      ++run;
      for (int step = 0; step < 20; ++step) other.step(hand.next(), 1.0 + 1e-3 * step);
      EXPECT_TRUE(other.touch().force_N.finite()) << each.name << ", state " << i;
    }
    EXPECT_GT(refused, 10) << each.name;
    EXPECT_GT(run, 100) << each.name;
  }
}

TEST(SceneBytes, ASceneFromBytesFeelsTheSameToTheBit) {
  for (const Case& each : cases()) {
    FeltScene original = felt(each.scene);
    const std::string bytes = packScene(original);
    auto unpacked = unpackScene(bytes);
    ASSERT_TRUE(unpacked) << each.name << ": " << unpacked.error().text();
    EXPECT_EQ(packScene(*unpacked), bytes) << each.name;
    Wander hand(5);
    for (int step = 0; step < 5000; ++step) {
      const Vec3 probe_mm = hand.next();
      original.step(probe_mm, 1e-3 * step);
      unpacked->step(probe_mm, 1e-3 * step);
      ASSERT_EQ(bitsOf(*unpacked), bitsOf(original)) << each.name << " at step " << step;
    }
  }
}

/// A sphere with triangles turned over, doubled and without an area, and vertices that stand twice.
TriangleSoup brokenSphere(unsigned seed) {
  TriangleSoup soup = shapes::sphere(10.0, 15);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < 40; ++i) {
    Triangle& turned = soup.triangles[random() % soup.triangles.size()];
    std::swap(turned[0], turned[1]);
    const Triangle t = turned;  // the list grows
    soup.triangles.push_back(t);
    soup.triangles.push_back({t[0], t[0], t[1]});
    soup.vertices.push_back(soup.vertices[t[2]]);
    soup.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(soup.vertices.size() - 1)});
    soup.triangles.push_back({t[0], static_cast<std::uint32_t>(random() % 100), t[1]});
  }
  return soup;
}

/// A strip with one half turn, which has no consistent orientation, and some of its triangles turned over.
TriangleSoup turnedMoebius(unsigned seed) {
  constexpr unsigned kCells = 30;
  TriangleSoup soup;
  for (unsigned i = 0; i < kCells; ++i) {
    const double around = 2.0 * std::numbers::pi * i / kCells;
    for (const double across : {-3.0, 3.0}) {
      const double radius = 20.0 + across * std::cos(0.5 * around);
      soup.vertices.push_back({radius * std::cos(around), radius * std::sin(around), across * std::sin(0.5 * around)});
    }
  }
  std::mt19937 random(seed);
  for (unsigned i = 0; i < kCells; ++i) {
    const bool closes = i + 1 == kCells;  // the rims change places
    const unsigned a = 2 * i, b = a + 1, c = closes ? 1 : a + 2, d = closes ? 0 : a + 3;
    for (Triangle t : {Triangle{a, b, d}, Triangle{a, d, c}}) {
      if (random() % 4 == 0) std::swap(t[1], t[2]);
      soup.triangles.push_back(t);
    }
  }
  return soup;
}

/// A mesh that had to be mended is packed as mended: mending it again changes nothing, whatever was broken.
TEST(SceneBytes, AMendedMeshStaysAsItIs) {
  std::size_t turned = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    for (const bool strip : {false, true}) {
      FeltScene original = felt(loaded("[[body]]\nmesh = \"m.obj\"\ncontact = \"facet\"\n",
                                       {strip ? turnedMoebius(seed) : brokenSphere(seed)}));
      turned += original.loaded()->meshes[0]->mesh.report().flipped_triangles;
      auto unpacked = unpackScene(packScene(original));
      ASSERT_TRUE(unpacked) << unpacked.error().text();
      EXPECT_TRUE(packScene(*unpacked) == packScene(original)) << (strip ? "strip " : "sphere ") << seed;
      EXPECT_EQ(unpacked->loaded()->meshes[0]->mesh.report().flipped_triangles, 0U);
    }
  }
  EXPECT_GT(turned, 1000U);
}

TEST(SceneBytes, DamagedBytesAreRefusedOrGiveAScene) {
  const std::string bytes = packScene(felt(cases()[0].scene));
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::string wrong = bytes;
    for (int k = 0; k < 3; ++k) wrong[random() % 400] = static_cast<char>(random());
    if (i % 2 == 0) wrong.resize(random() % wrong.size());
    static_cast<void>(unpackScene(wrong));
  }
  EXPECT_FALSE(unpackScene(""));
  EXPECT_FALSE(unpackScene("FYD"));
  EXPECT_FALSE(unpackScene(std::string_view(bytes).substr(0, bytes.size() - 1)));
  EXPECT_FALSE(unpackScene(bytes + "x"));
}

}  // namespace
}  // namespace fyd::scene
