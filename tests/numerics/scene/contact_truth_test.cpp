// Contact against surfaces that are known by formulas: the bumpy plane (nearest point by Newton's method), the sphere,
// planes and boxes. A force by stiffness is in mm; "of analytic" is of what the surface itself gives.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sweep.h"
#include "tests/unit/scene/touched_body.h"

namespace fyd::scene {
namespace {

using shapes::Bumps;

struct Errors {
  double mean = 0.0;   ///< of the force, by the analytic force of 1 mm
  double step = 0.0;   ///< largest vector step of force, by the analytic one's largest
  double force = 0.0;  ///< mean
};

/// A probe about 1 mm deep at 110 mm/s, a step of 1 ms.
Errors alongTheBumps(unsigned cells, ContactModel model, int steps, double pace_s = 1e-3) {
  TouchedBody body(shapes::bumps(cells), model, 0.0, {1.0, 0.0, 0.0, 0.0});
  static_cast<void>(body.at({0.0, 40.0 * std::sin(1.0), 10.0}));
  Errors e;
  double analytic_step = 0.0;
  Vec3 last, last_truth;
  for (int i = 0; i < steps; ++i) {
    const double way = i * pace_s * 110.0;
    const double x = 40.0 * std::sin(way / 40.0), y = 40.0 * std::sin(0.731 * way / 40.0 + 1.0);
    const Vec3 probe = Vec3{x, y, Bumps::height(x, y)} - 1.0 * Bumps::normal(x, y);
    const Vec3 truth = Bumps::foot(probe) - probe;
    const Vec3 force = body.at(probe).force_N;
    e.mean += length(force - truth) / steps;
    e.force += length(force) / steps;
    if (i > 0) {
      e.step = std::max(e.step, length(force - last));
      analytic_step = std::max(analytic_step, length(truth - last_truth));
    }
    last = force;
    last_truth = truth;
  }
  e.step /= analytic_step;
  return e;
}

TEST(ContactTruth, VicinityOnBumpsOf10000Triangles) {
  const Errors e = alongTheBumps(71, ContactModel::vicinity, 60000);
  EXPECT_LT(e.mean, 0.006);  // 0.42 %
  EXPECT_LT(e.step, 2.0);    // 1.5
}

TEST(ContactTruth, VicinityOnBumpsOf100000Triangles) {
  const Errors e = alongTheBumps(224, ContactModel::vicinity, 60000);
  EXPECT_LT(e.mean, 0.0003);  // 0.008 %
  EXPECT_LT(e.step, 1.05);
}

TEST(ContactTruth, AFacetIsWorseThanTheVicinityAndNodesAreWorst) {
  const Errors facet = alongTheBumps(71, ContactModel::facet, 20000);
  EXPECT_GT(facet.mean, 0.06);
  EXPECT_LT(facet.mean, 0.10);
  EXPECT_GT(facet.step, 8.0);
  EXPECT_LT(facet.step, 20.0);
  const Errors proxy = alongTheBumps(71, ContactModel::proxy, 20000);
  EXPECT_LT(proxy.mean, 0.10);
  const Errors nodes = alongTheBumps(71, ContactModel::nodes, 20000);
  EXPECT_NEAR(nodes.force, 1.0, 0.15);  // its stiffness is scaled to that
  EXPECT_GT(nodes.mean, facet.mean);
}

TEST(ContactTruth, VicinityOnASphereOf10000Triangles) {
  TouchedBody body(shapes::sphere(20.0, 71), ContactModel::vicinity, 0.0, {1.0, 0.0, 0.0, 0.0});
  double mean = 0.0, most = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double up = 2.0 * (i + 0.5) / 20000.0 - 1.0, around = 2.399963 * i, across = std::sqrt(1.0 - up * up);
    const Vec3 out = {across * std::cos(around), across * std::sin(around), up};
    const double error = length(body.at(19.0 * out).force_N - out);
    mean += error / 20000.0;
    most = std::max(most, error);
  }
  EXPECT_LT(mean, 5e-5);
  EXPECT_LT(most, 1e-3);
}

TEST(ContactTruth, ACubeIsTouchedWithItsFacesAlsoNearItsEdges) {
  for (const ContactModel model : {ContactModel::facet, ContactModel::vicinity}) {
    TouchedBody body(shapes::box(10.0, 10.0, 10.0), model, 0.0, {1.0, 0.0, 0.0, 0.0});
    for (const double x : stepsBefore(-9.95, 10.0, 0.3111)) {
      for (const double z : stepsBefore(5.1, 10.0, 0.17)) {
        const Contact c = body.at({x, 0.7, z});
        ASSERT_TRUE(c.touching);
        const bool top = 10.0 - z < 10.0 - std::abs(x);
        const Vec3 normal = top ? Vec3{0, 0, 1} : Vec3{x > 0 ? 1.0 : -1.0, 0, 0};
        const double depth = std::min(10.0 - z, 10.0 - std::abs(x));
        EXPECT_NEAR(length(c.force_N - depth * normal), 0.0, 1e-6) << x << ' ' << z;
        EXPECT_NEAR(c.depth_mm, depth, 1e-6);
      }
    }
    EXPECT_FALSE(body.at({0, 0, 10.0001}).touching);
    EXPECT_FALSE(body.at({10.1, 10.1, 10.1}).touching);
  }
}

/// Two half planes with a valley between them: z = |x|·tan, its crease a concave edge; the way out of the body near it
/// leads to the edge.
TEST(ContactTruth, OverAConcaveEdgeTheWayOutLeadsToIt) {
  for (const ContactModel model : {ContactModel::facet, ContactModel::vicinity}) {
    TouchedBody body(shapes::heights(20.0, 8, [](double x, double) { return std::abs(x); }), model, 0.0,
                     {1.0, 0.0, 0.0, 0.0});
    for (const double x : stepsBefore(-0.9, 0.95, 0.1)) {
      const Contact c = body.at({x, 1.3, -1.0});  // the edge is nearest as long as |x| < 1
      ASSERT_TRUE(c.touching) << x;
      EXPECT_NEAR(length(c.force_N - Vec3{-x, 0.0, 1.0}), 0.0, 1e-6) << x;
    }
    const Contact c = body.at({3.0, 1.3, 1.0});
    EXPECT_NEAR(length(c.force_N - Vec3{-1.0, 0.0, 1.0}), 0.0, 1e-6);
  }
}

TEST(ContactTruth, AFanOf100000TrianglesIsFittedAtOnceAndIsFlat) {
  TriangleSoup soup;
  soup.vertices.push_back({0, 0, 0});
  constexpr unsigned kMany = 100'000;
  for (unsigned i = 0; i < kMany; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kMany;
    soup.vertices.push_back({10.0 * std::cos(a), 10.0 * std::sin(a), 0.0});
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % kMany});
  }
  TouchedBody body(std::move(soup), ContactModel::vicinity, 0.0, {1.0, 0.0, 0.0, 0.0});  // in 10¹⁰ steps, if badly
  for (const Vec3 probe : {Vec3{0, 0, -1}, {3, 2, -1}, {-8, 1, -0.5}}) {
    EXPECT_NEAR(length(body.at(probe).force_N - Vec3{0, 0, -probe.z}), 0.0, 1e-6);
  }
}

/// Force along a closed way in the plane, and around it; the work that the body gives.
template <class Body, class Way>
double work(Body& body, Way way, int steps) {
  static_cast<void>(body.at(way(0)));
  static_cast<void>(body.at(way(0)));
  double given = 0.0;
  Vec3 last = way(0), force = body.at(last).force_N;
  for (int i = 1; i <= steps; ++i) {
    const Vec3 p = way(i), now = body.at(p).force_N;
    given += dot(0.5 * (force + now), p - last);
    last = p;
    force = now;
  }
  return given;
}

/// Loops through the surface at many places and phases. @return the most work given, by ½ k d² with d the loop's depth
double mostWork(ContactModel model, unsigned cells, double damping) {
  double most = -1e9;
  TouchedBody body(shapes::bumps(cells), model, 0.0, {1.0, damping, 0.0, 0.0});
  for (int place = 0; place < 24; ++place) {
    const double x0 = -30.0 + 2.6 * place, y0 = 25.0 - 2.1 * place;
    for (const double turn : {1.0, -1.0}) {
      const double phase = 0.4 * place;
      body.contact.restore({});
      const auto way = [&](int i) {
        const double a = 2.0 * std::numbers::pi * turn * i / 4000.0 + std::numbers::pi / 2.0;
        const double across = 1.5 * std::cos(a);
        return Vec3{x0 + across * std::cos(phase), y0 + across * std::sin(phase),
                    Bumps::height(x0, y0) + 0.2 + 1.2 * std::sin(a)};
      };
      most = std::max(most, work(body, way, 4000) / 0.5);
    }
  }
  return most;
}

/// Floats anywhere on the way would be off by 1e-7.
TEST(ContactVicinity, ATiltedPlaneIsFeltInDouble) {
  TouchedBody body(shapes::heights(10.0, 30, [](double x, double y) { return 0.3 * x - 0.17 * y; }),
                   ContactModel::vicinity, 0.0, {1.0, 0.0, 0.0, 0.0});
  const Vec3 normal = (1.0 / std::sqrt(1.0 + 0.3 * 0.3 + 0.17 * 0.17)) * Vec3{-0.3, 0.17, 1.0};
  for (int i = 0; i < 400; ++i) {
    const double x = 0.0391 * (i % 20) - 0.4, y = 0.0417 * (i / 20.0) - 0.4;
    const Vec3 on = {x, y, 0.3 * x - 0.17 * y};
    EXPECT_LT(length(body.at(on - 0.7 * normal).force_N - 0.7 * normal), 1e-11);
  }
}

TEST(ContactEnergy, ClosedWaysGiveNoWorkBeyondWhatTheFitIsOffByItself) {
  // Of ½ k (1 mm)². The forces of facet, proxy and nodes are gradients; the vicinity's is one but for what is blended.
  EXPECT_LT(mostWork(ContactModel::facet, 71, 0.0), 0.002);
  EXPECT_LT(mostWork(ContactModel::proxy, 71, 0.0), 0.002);
  EXPECT_LT(mostWork(ContactModel::vicinity, 71, 0.0), 0.03);
  EXPECT_LT(mostWork(ContactModel::vicinity, 224, 0.0), 0.001);
  EXPECT_LT(mostWork(ContactModel::nodes, 71, 0.0), 0.002);
}

TEST(ContactEnergy, FrictionAndTheRimGiveNoWork) {
  TouchedBody rubbed(shapes::plane(20.0, 10), ContactModel::proxy, 0.5, {1.0, 0.0, 0.6, 0.4});
  const auto loop = [](int i) {
    const double a = 2.0 * std::numbers::pi * i / 1000.0;
    return Vec3{3.0 * std::cos(a), 2.0 * std::sin(2.0 * a), 1.0 + 2.0 * std::cos(a)};
  };
  EXPECT_LT(work(rubbed, loop, 5000), 0.0);
  for (const ContactModel model : {ContactModel::facet, ContactModel::vicinity}) {
    // Around the rim, by which a probe gets below the sheet: in over the sheet and out beside it, and the other way.
    TouchedBody sheet(shapes::plane(10.0, 6), model, 0.0, {1.0, 0.0, 0.0, 0.0});
    for (const double turn : {1.0, -1.0}) {
      const auto around = [&](int i) {
        const double a = 2.0 * std::numbers::pi * turn * i / 20000.0;
        return Vec3{10.0 + 2.0 * std::cos(a), 0.3, -0.5 + 1.0 * std::sin(a)};
      };
      EXPECT_NEAR(work(sheet, around, 20000), 0.0, 2e-4) << turn;
    }
  }
}

TEST(ContactEnergy, TheForceDependsOnThePlaceNotOnThePace) {
  // The same way in steps between 0.2 and 5 ms: at the places they share, the same force.
  for (const ContactModel model : {ContactModel::facet, ContactModel::vicinity, ContactModel::proxy}) {
    TouchedBody even(shapes::bumps(71), model, 0.0, {1.0, 0.0, 0.0, 0.0});
    TouchedBody uneven(shapes::bumps(71), model, 0.0, {1.0, 0.0, 0.0, 0.0});
    const auto way = [](double t_s) {
      const double x = 30.0 * std::sin(1.1 * t_s), y = 20.0 * std::sin(1.7 * t_s);
      return Vec3{x, y, Bumps::height(x, y) - 0.7};
    };
    static_cast<void>(even.at({0, 0, 5}));
    static_cast<void>(uneven.at({0, 0, 5}));
    std::uint32_t random = 1;
    double t_s = 0.0;
    for (int ms = 0; ms < 3000; ++ms) {
      const Contact a = even.at(way(ms * 1e-3));
      if (ms * 1e-3 < t_s) continue;
      random = random * 1664525U + 1013904223U;
      const Contact b = uneven.at(way(ms * 1e-3));
      t_s = ms * 1e-3 + 2e-4 + 4.8e-3 * (random >> 8) / 16777216.0;
      ASSERT_LT(length(a.force_N - b.force_N), model == ContactModel::proxy ? 0.02 : 1e-15) << ms;
    }
  }
}

}  // namespace
}  // namespace fyd::scene
