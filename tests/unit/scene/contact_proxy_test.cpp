// The proxy contact model: finite radius, edges and corners, friction, fast and random probe paths.
#include <gtest/gtest.h>

#include <random>

#include "tests/sweep.h"
#include "tests/unit/scene/touched_body.h"

namespace fyd::scene {
namespace {

using shapes::box;

/// Along a straight way in steps. @return the last contact
Contact walk(TouchedBody& body, const Vec3& from, const Vec3& to, int steps) {
  Contact last;
  for (int i = 0; i <= steps; ++i) last = body.at(from + (double(i) / steps) * (to - from));
  return last;
}

class ProxyRadius : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(PointAndFinger, ProxyRadius, testing::Values(0.0, 1.0));

TEST_P(ProxyRadius, AWallOfAHundredthOfAMillimetreHoldsAtOneMetreASecondAndMore) {
  const double r = GetParam();
  for (const double step_mm : {0.1, 1.0, 7.0, 1e3}) {
    for (const double slant : {0.0, 0.3, 2.0}) {
      TouchedBody body(box(20.0, 20.0, 0.005), ContactModel::proxy, r);
      for (const double z : stepsBefore(5.0, -8.0, -step_mm))
        static_cast<void>(body.at({slant * z, 0.3 * slant * z, z}));
      const Contact c = body.at({-8.0 * slant, -2.4 * slant, -8.0});
      ASSERT_TRUE(c.touching) << step_mm << ' ' << slant;
      EXPECT_NEAR(c.proxy_mm.z, 0.005 + r, 1e-5);
      EXPECT_NEAR(c.force_N.z, 0.5 * (8.005 + r), 1e-5);
      EXPECT_NEAR(c.force_N.x, 0.0, 1e-5);
    }
  }
}

TEST_P(ProxyRadius, ItLetsGoWhenTheProbeComesBack) {
  const double r = GetParam();
  TouchedBody body(box(20.0, 20.0, 0.005), ContactModel::proxy, r);
  ASSERT_TRUE(walk(body, {0, 0, 3}, {0, 0, -3}, 60).touching);
  const Contact c = walk(body, {0, 0, -3}, {0, 0, 3}, 60);
  EXPECT_FALSE(c.touching);
  EXPECT_EQ(c.force_N, Vec3{});
  EXPECT_EQ(body.contact.state().proxy_mm, (Vec3{0, 0, 3}));
}

TEST_P(ProxyRadius, SlidingOverAnEdgeItFallsDownTheSide) {
  const double r = GetParam();
  TouchedBody body(box(10.0, 10.0, 10.0), ContactModel::proxy, r);
  static_cast<void>(walk(body, {0, 0, 12}, {0, 0, 9}, 30));
  static_cast<void>(walk(body, {0, 0, 9}, {14, 0, 9}, 140));
  const Contact c = walk(body, {14, 0, 9}, {9.5, 0, 0}, 100);
  ASSERT_TRUE(c.touching);
  EXPECT_NEAR(c.proxy_mm.x, 10.0 + r, 1e-5);
  EXPECT_NEAR(c.proxy_mm.z, 0.0, 1e-5);
}

/// A box that is open at the top, seen from within: its floor and walls are concave edges and corners.
TriangleSoup room() {
  TriangleSoup soup = box(10.0, 10.0, 10.0);
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

TEST_P(ProxyRadius, TwoWallsHoldAlongTheirEdgeAndThreeInTheirCorner) {
  const double r = GetParam();
  TouchedBody body(room(), ContactModel::proxy, r);
  static_cast<void>(body.at({0, 0, 0}));
  Contact c = walk(body, {0, 0, 0}, {12, 1, -13}, 50);
  ASSERT_TRUE(c.touching);
  EXPECT_NEAR(c.proxy_mm.x, 10.0 - r, 1e-5);
  EXPECT_NEAR(c.proxy_mm.y, 1.0, 1e-5);
  EXPECT_NEAR(c.proxy_mm.z, -10.0 + r, 1e-5);
  c = walk(body, {12, 1, -13}, {12, 11, -13}, 50);
  EXPECT_NEAR(c.proxy_mm.x, 10.0 - r, 1e-5);
  EXPECT_NEAR(c.proxy_mm.y, 10.0 - r, 1e-5);
  EXPECT_NEAR(c.proxy_mm.z, -10.0 + r, 1e-5);
  EXPECT_NEAR(c.force_N.x, 0.5 * (-2.0 - r), 1e-5);
  EXPECT_NEAR(c.force_N.y, 0.5 * (-1.0 - r), 1e-5);
  EXPECT_NEAR(c.force_N.z, 0.5 * (3.0 + r), 1e-5);
}

TEST_P(ProxyRadius, FromWithinABodyItActsOnlyAfterItCameThrough) {
  const double r = GetParam();
  TouchedBody body(box(10.0, 10.0, 10.0), ContactModel::proxy, r);
  for (const double z : stepsBefore(0.0, 14.0, 0.3)) EXPECT_FALSE(body.at({1.0, 2.0, z}).touching) << z;
  const Contact c = walk(body, {1, 2, 14}, {1, 2, 8}, 20);
  ASSERT_TRUE(c.touching);
  EXPECT_NEAR(c.proxy_mm.z, 10.0 + r, 1e-5);
}

TEST_P(ProxyRadius, AnOpenSheetHoldsOnlyFromOutside) {
  const double r = GetParam();
  TouchedBody body(shapes::plane(10.0, 4), ContactModel::proxy, r);
  for (const double z : stepsBefore(-3.0, 3.0, 0.1)) EXPECT_FALSE(body.at({1.0, 2.0, z}).touching) << z;
  EXPECT_TRUE(walk(body, {1, 2, 3}, {1, 2, -1}, 10).touching);
}

TEST_P(ProxyRadius, BeyondTheRimThereIsNothing) {
  const double r = GetParam();
  TouchedBody body(shapes::plane(10.0, 4), ContactModel::proxy, r);
  EXPECT_FALSE(walk(body, {12, 2, 3}, {12, 2, -3}, 30).touching);
  // And who slides over it falls.
  TouchedBody other(shapes::plane(10.0, 4), ContactModel::proxy, r);
  ASSERT_TRUE(walk(other, {0, 0, 3}, {0, 0, -0.5}, 30).touching);
  EXPECT_FALSE(walk(other, {0, 0, -0.5}, {13, 0, -0.5}, 100).touching);
}

TEST_P(ProxyRadius, NoRandomWayGetsThroughABumpyPlane) {
  const double r = GetParam();
  TouchedBody body(shapes::bumps(71), ContactModel::proxy, r);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-30.0, 30.0), depth(-6.0, 4.0), step(-1.0, 1.0);
  Vec3 p{0, 0, 10};
  static_cast<void>(body.at(p));
  for (int i = 0; i < 20000; ++i) {
    if (i % 50 == 0) p = {place(random), place(random), depth(random)};
    p = p + Vec3{step(random), step(random), 0.3 * step(random)};
    const Contact c = body.at(p);
    const Vec3 proxy = body.contact.state().proxy_mm;
    if (std::abs(proxy.x) > 48.0 || std::abs(proxy.y) > 48.0) continue;
    const Nearest q = body.tree.nearest(proxy);
    const double held = body.contact.state().radius_mm;
    ASSERT_GT(dot(proxy - q.point_mm, body.mesh.normalOf(q.triangle, q.feature)), 0.0) << i;
    ASSERT_GT(std::sqrt(q.squared_mm2), held - 1e-6) << i;
    ASSERT_TRUE(c.force_N.finite());
  }
}

TEST_P(ProxyRadius, ItIsAsNearToTheProbeAsTheOutsideAllows) {
  // On a ball, from wherever it comes: along the line from the ball's middle.
  const double r = GetParam();
  TouchedBody body(shapes::sphere(20.0, 71), ContactModel::proxy, r);
  static_cast<void>(body.at({0.3, 0.2, 30}));
  for (int i = 0; i <= 3000; ++i) {
    const double a = i * 0.003, b = 0.7 * std::sin(a * 0.7);
    const Vec3 out = {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
    const Contact c = body.at(19.0 * out);
    ASSERT_TRUE(c.touching);
    EXPECT_LT(length(c.proxy_mm - (20.0 + r) * out), 0.12) << i;
  }
}

TEST(Proxy, StaticFrictionHoldsAndKineticLagsByItsShareOfTheDepth) {
  Surface surface;
  surface.static_friction = 0.8;
  surface.kinetic_friction = 0.5;
  TouchedBody body(shapes::plane(30.0, 10), ContactModel::proxy, 0.0, surface);
  static_cast<void>(walk(body, {0, 0, 1}, {0, 0, -2}, 30));
  Contact c = walk(body, {0, 0, -2}, {1.59, 0, -2}, 100);
  EXPECT_NEAR(c.force_N.x, -0.5 * 1.59, 1e-6);  // it sticks
  EXPECT_NEAR(c.proxy_mm.x, 0.0, 1e-6);
  c = walk(body, {1.59, 0, -2}, {9.0, 0, -2}, 300);
  EXPECT_NEAR(c.force_N.x, -0.5 * (0.5 * 2.0), 1e-5);  // kinetic friction times the normal force of 1 N
  EXPECT_NEAR(c.force_N.z, 0.5 * 2.0, 1e-5);
  const double stood = c.proxy_mm.x;
  c = walk(body, {9.0, 0, -2}, {8.0, 0, -2}, 100);  // turning back, it sticks where it was
  EXPECT_NEAR(c.proxy_mm.x, stood, 1e-9);
  c = walk(body, {8.0, 0, -2}, {-5.0, 0, -2}, 500);
  EXPECT_NEAR(c.force_N.x, 0.5 * (0.5 * 2.0), 1e-5);
}

TEST(Proxy, FrictionOverASurfaceDoesNotLetItThrough) {
  Surface surface;
  surface.static_friction = 1.2;
  surface.kinetic_friction = 0.9;
  TouchedBody body(shapes::bumps(71), ContactModel::proxy, 0.5, surface);
  static_cast<void>(body.at({0, 0, 5}));
  for (int i = 0; i < 5000; ++i) {
    const double x = 30.0 * std::sin(i * 0.003), y = 25.0 * std::sin(i * 0.0041);
    static_cast<void>(body.at({x, y, shapes::Bumps::height(x, y) - 1.0}));
    const Vec3 proxy = body.contact.state().proxy_mm;
    const Nearest q = body.tree.nearest(proxy);
    ASSERT_GT(dot(proxy - q.point_mm, body.mesh.normalOf(q.triangle, q.feature)), 0.0) << i;
  }
}

TEST(Proxy, ATeleportFromFarAwayStopsAtTheFirstWall) {
  for (const double far : {1e2, 1e4, 1e6, 9e8}) {
    TouchedBody body(box(10.0, 10.0, 0.01), ContactModel::proxy, 0.0);
    static_cast<void>(body.at({0, 0, far}));
    const Contact c = body.at({1, 2, -far});
    ASSERT_TRUE(c.touching) << far;
    EXPECT_GE(c.proxy_mm.z, 0.01) << far;
    EXPECT_LT(c.proxy_mm.z, 0.011) << far;
  }
}

TEST(Proxy, ItComesOutTheSameFromASavedState) {
  TouchedBody body(shapes::bumps(40), ContactModel::proxy, 1.0, {0.5, 0.001, 0.4, 0.3});
  const auto probe = [](int i) {
    const double x = 20.0 * std::sin(i * 0.01), y = 3.0 + 15.0 * std::sin(i * 0.013);
    return Vec3{x, y, shapes::Bumps::height(x, y) - 1.0 + 2.0 * std::sin(i * 0.05)};
  };
  for (int i = 0; i < 500; ++i) static_cast<void>(body.at(probe(i), {1, 2, 3}));
  const ContactState saved = body.contact.state();
  std::vector<Vec3> first;
  for (int i = 500; i < 900; ++i) first.push_back(body.at(probe(i), {1, 2, 3}).force_N);
  body.contact.restore(saved);
  for (int i = 500; i < 900; ++i) ASSERT_EQ(body.at(probe(i), {1, 2, 3}).force_N, first[std::size_t(i - 500)]);
}

}  // namespace
}  // namespace fyd::scene
