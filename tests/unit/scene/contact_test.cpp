// Properties that every contact model must have: force law, damping, units, degenerate triangles, reach.
#include "core/scene/contact/contact.h"

#include <gtest/gtest.h>

#include "tests/sweep.h"
#include "tests/unit/scene/touched_body.h"

namespace fyd::scene {
namespace {

constexpr std::array kAll = {ContactModel::nodes, ContactModel::facet, ContactModel::vicinity, ContactModel::proxy};

class EachModel : public testing::TestWithParam<ContactModel> {};
INSTANTIATE_TEST_SUITE_P(Contact, EachModel, testing::ValuesIn(kAll), [](const auto& model) {
  return std::string(kContactModels[static_cast<std::size_t>(model.param)]);
});

TEST_P(EachModel, ForceIsStiffnessTimesDepthOutOfAPlane) {
  TouchedBody body(shapes::plane(20.0, 60), GetParam(), 0.0, {0.5, 0.0, 0.0, 0.0});
  static_cast<void>(body.at({0.31, 0.2, 2.0}));
  double mean = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Contact c = body.at({0.31 + 0.05 * i, 0.2, -1.0});
    ASSERT_TRUE(c.touching);
    EXPECT_NEAR(length(c.normal - Vec3{0, 0, 1}), 0.0, GetParam() == ContactModel::nodes ? 2e-3 : 1e-6);
    EXPECT_EQ(c.stiffness_N_per_mm, 0.5);
    EXPECT_NE(c.triangle, kNoTriangle);
    mean += 0.01 * c.force_N.z;
    if (GetParam() != ContactModel::nodes) {
      EXPECT_NEAR(c.force_N.z, 0.5, 2e-6);
      EXPECT_NEAR(c.depth_mm, 1.0, 4e-6);
    }
  }
  EXPECT_NEAR(mean, 0.5, 0.03);
}

TEST_P(EachModel, OutsideAndWithNoNumberNothingIsTouched) {
  TouchedBody body(shapes::plane(20.0, 30), GetParam());
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const Vec3 probe : {Vec3{0, 0, 1}, {nan, 0, 0}, {0, inf, 0}, {0, 0, -inf}, {1e300, 0, -1e300}}) {
    const Contact c = body.at(probe);
    EXPECT_FALSE(c.touching);
    EXPECT_EQ(c.force_N, Vec3{});
    EXPECT_EQ(c.stiffness_N_per_mm, 0.0);
    EXPECT_EQ(c.triangle, kNoTriangle);
  }
  EXPECT_TRUE(body.at({0.1, 0.2, -0.5}).force_N.finite());
  EXPECT_TRUE(body.at({0.1, 0.2, -0.5}, {nan, 0, inf}).touching);
}

TEST_P(EachModel, DampingActsAlongTheNormalAndNeverPulls) {
  const auto force = [](double damping, const Vec3& velocity) {
    TouchedBody body(shapes::plane(20.0, 60), GetParam(), 0.0, {0.5, damping, 0.0, 0.0});
    static_cast<void>(body.at({0.3, 0.2, 1.0}));
    return body.at({0.3, 0.2, -1.0}, velocity).force_N;
  };
  const Vec3 still = force(0.002, {});
  EXPECT_NEAR(length(force(0.002, {100, 50, 0}) - still), 0.0, GetParam() == ContactModel::nodes ? 1e-3 : 1e-7);
  EXPECT_NEAR(force(0.002, {0, 0, -100}).z - still.z, 0.2, 1e-6);
  EXPECT_NEAR(force(0.002, {0, 0, 100}).z - still.z, -0.2, 1e-6);
  EXPECT_NEAR(length(force(0.002, {0, 0, 1e6})), 0.0, 1e-12);  // not below zero
  TouchedBody body(shapes::plane(20.0, 60), GetParam(), 0.0, {0.5, 1.0, 0.0, 0.0});
  EXPECT_EQ(body.at({0, 0, 1}, {0, 0, -1000}).force_N, Vec3{});
}

TEST_P(EachModel, TheSameInAnySizeAndAnyUnit) {
  const auto shape = shapes::heights(10.0, 24, [](double x, double y) { return 0.05 * x * y - 0.02 * x * x; });
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    TouchedBody one(shape, GetParam(), 1.0), other(shapes::scaled(shape, scale), GetParam(), scale);
    static_cast<void>(one.at({1, 2, 5}));
    static_cast<void>(other.at(scale * Vec3{1, 2, 5}));
    for (int i = 0; i < 200; ++i) {
      const double x = 6.0 * std::sin(0.05 * i), y = 6.0 * std::cos(0.031 * i);
      const Vec3 probe = {x, y, 0.05 * x * y - 0.02 * x * x - 0.4};
      const Contact a = one.at(probe), b = other.at(scale * probe);
      ASSERT_EQ(a.touching, b.touching);
      ASSERT_NEAR(length(a.force_N - (1.0 / scale) * b.force_N), 0.0, 2e-6) << scale << ' ' << i;
    }
  }
}

TEST_P(EachModel, AnyStiffnessGivesItsOwnForce) {
  for (const double stiffness : {1e-6, 1e-3, 1.0, 1e4}) {
    TouchedBody body(shapes::plane(20.0, 60), GetParam(), 0.0, {stiffness, 0.0, 0.0, 0.0});
    static_cast<void>(body.at({0.3, 0.2, 1}));
    EXPECT_NEAR(body.at({0.3, 0.2, -0.5}).force_N.z / stiffness, 0.5, GetParam() == ContactModel::nodes ? 0.05 : 1e-5);
  }
}

TEST_P(EachModel, AMillionStepsAtRestDoNotDrift) {
  TouchedBody body(shapes::bumps(30), GetParam(), 0.0, {0.5, 0.0, 0.5, 0.3});
  const Vec3 probe = {3.1, 4.2, shapes::Bumps::height(3.1, 4.2) - 1.0};
  const Nearest nearest = body.tree.nearest(probe);
  static_cast<void>(body.at(probe + Vec3{0, 0, 9}));
  Contact first;
  for (int i = 0; i < 100; ++i) first = body.contact.touch(probe, {}, nearest);
  ASSERT_TRUE(first.touching);
  Contact last;
  for (int i = 0; i < 1'000'000; ++i) last = body.contact.touch(probe, {}, nearest);
  EXPECT_NEAR(length(last.force_N - first.force_N), 0.0, 1e-9);
}

TEST_P(EachModel, OneTriangleIsEnough) {
  TriangleSoup soup;
  soup.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  soup.triangles = {{0, 1, 2}};
  TouchedBody body(soup, GetParam(), GetParam() == ContactModel::nodes ? 6.0 : 0.0);
  static_cast<void>(body.at({3, 3, 2}));
  const Contact c = body.at({3, 3, -0.5});
  ASSERT_TRUE(c.touching);
  EXPECT_GT(c.force_N.z, 0.0);
  EXPECT_NEAR(std::abs(c.force_N.x) + std::abs(c.force_N.y), 0.0, GetParam() == ContactModel::nodes ? 0.05 : 1e-7);
  if (GetParam() != ContactModel::nodes) {
    EXPECT_NEAR(c.force_N.z, 0.25, 1e-5);
  }
}

TEST_P(EachModel, ExactlyOnAnEdgeAndAVertexItIsFiniteAndContinuous) {
  TouchedBody body(shapes::sphere(10.0, 24), GetParam());
  static_cast<void>(body.at({0, 0, 20}));
  const auto vertices = body.mesh.vertices();
  for (std::uint32_t t = 0; t < 400; t += 7) {
    const Triangle& c = body.mesh.triangles()[t];
    for (const Vec3& at : {vertices[c[0]], 0.5 * (vertices[c[0]] + vertices[c[1]]), 0.96 * vertices[c[1]]}) {
      body.contact.restore({});
      static_cast<void>(body.at(1.5 * at));
      const Contact here = body.at(at);
      EXPECT_TRUE(here.force_N.finite() && here.normal.finite());
      // At most 0.4 mm deep; nodes see a sphere of three edges.
      EXPECT_LT(length(here.force_N), GetParam() == ContactModel::nodes ? 0.5 : 0.21);
    }
  }
}

TEST_P(EachModel, CoincidentAndNeedleTrianglesGiveNoNonsense) {
  TriangleSoup soup = shapes::plane(10.0, 12);
  const TriangleSoup again = soup;  // every triangle twice
  const auto base = static_cast<std::uint32_t>(soup.vertices.size());
  for (const Vec3& v : again.vertices) soup.vertices.push_back(v);
  for (const Triangle& t : again.triangles) soup.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  // A strip of needles beside the plane, a millionth as wide as long.
  for (std::uint32_t i = 0; i < 20; ++i) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.push_back({10.0 + 1e-5 * i, -10.0, 0.0});
    soup.vertices.push_back({10.0 + 1e-5 * (i + 1), -10.0, 0.0});
    soup.vertices.push_back({10.0 + 1e-5 * i, 10.0, 0.0});
    soup.vertices.push_back({10.0 + 1e-5 * (i + 1), 10.0, 0.0});
    soup.triangles.push_back({n, n + 1, n + 2});
    soup.triangles.push_back({n + 1, n + 3, n + 2});
  }
  TouchedBody body(soup, GetParam(), GetParam() == ContactModel::nodes ? 3.0 : 0.0);
  static_cast<void>(body.at({0, 0.1, 2}));
  for (const double x : stepsBefore(0.0, 9.9, 0.013)) {
    const Contact c = body.at({x, 0.1, -0.3});
    ASSERT_TRUE(c.touching) << x;
    ASSERT_TRUE(c.force_N.finite());
    if (GetParam() != ContactModel::nodes) {
      ASSERT_NEAR(length(c.force_N - Vec3{0, 0, 0.15}), 0.0, 1e-5) << x;
    }
  }
}

TEST(ContactRim, TheForceEndsWithoutAStepBesideTheRim) {
  for (const ContactModel model : {ContactModel::facet, ContactModel::vicinity}) {
    TouchedBody body(shapes::plane(10.0, 8), model, 0.0, {1.0, 0.0, 0.0, 0.0});
    Vec3 last = body.at({9.0, 0.4, -1.0}).force_N;
    EXPECT_NEAR(length(last - Vec3{0, 0, 1}), 0.0, 1e-6);
    for (const double x : stepsBefore(9.0, 12.0, 0.001)) {
      const Contact c = body.at({x, 0.4, -1.0});
      ASSERT_LT(length(c.force_N - last), 0.006) << x;
      EXPECT_GE(c.force_N.z, 0.0);
      EXPECT_GE(c.force_N.x, -1e-9);  // it does not pull back below the sheet
      if (std::abs(x - 11.0) > 1e-6) {
        EXPECT_EQ(c.touching, x < 11.0) << x;
      }
      last = c.force_N;
    }
  }
}

TEST(ContactReach, DeeperThanItsReachThereIsNoForce) {
  const Mesh mesh = shapes::built(shapes::plane(10.0, 8));
  const TriangleTree tree(mesh);
  BodyContact contact(tree, {}, {ContactModel::facet, 0.0, 2.0});
  EXPECT_TRUE(contact.touch({1, 1, -1.9}, {}, tree.nearest({1, 1, -1.9})).touching);
  EXPECT_FALSE(contact.touch({1, 1, -2.1}, {}, tree.nearest({1, 1, -2.1})).touching);
}

TEST(ContactCost, BytesAreThoseOfTheModel) {
  const Mesh mesh = shapes::built(shapes::bumps(71));
  const TriangleTree tree(mesh);
  const auto bytes = [&](ContactModel model) { return BodyContact(tree, {}, {model, 0.0, 0.0}).bytes(); };
  EXPECT_LT(bytes(ContactModel::proxy), 2000U);
  EXPECT_LT(bytes(ContactModel::facet), 3U * mesh.triangles().size());
  EXPECT_LT(bytes(ContactModel::vicinity), 100U * mesh.vertices().size() + 20U * mesh.triangles().size());
}

}  // namespace
}  // namespace fyd::scene
