// What the choice of a model says of itself, against surfaces that are known without triangles and were not used to
// make it.
#include <gtest/gtest.h>

#include "core/scene/contact/contact_choice.h"
#include "core/scene/soft/soft_choice.h"
#include "tests/unit/scene/shapes.h"
#include "tests/unit/scene/soft_sheet.h"

namespace fyd::scene {
namespace {

struct Known {
  const char* name;
  TriangleSoup soup;
  /// The point of the surface nearest to a probe not far under it.
  Vec3 (*foot)(const Vec3&);
};

Vec3 onBall(const Vec3& p) { return 20.0 * unit(p); }

/// A cylinder along y: its nearest point needs no search, and its curvature is another one in each direction.
constexpr double kRound_mm = 30.0;
Vec3 onCylinder(const Vec3& p) {
  const Vec3 out = unit({p.x, 0.0, p.z + kRound_mm});
  return {kRound_mm * out.x, p.y, kRound_mm * out.z - kRound_mm};
}
double cylinder(double x, double) { return std::sqrt(kRound_mm * kRound_mm - x * x) - kRound_mm; }

std::vector<Known> surfaces() {
  std::vector<Known> out;
  for (const unsigned n : {24U, 48U}) out.push_back({"sphere", shapes::sphere(20.0, n), onBall});
  for (const unsigned n : {50U, 90U}) out.push_back({"bumps", shapes::bumps(n), shapes::Bumps::foot});
  for (const unsigned n : {12U, 30U}) out.push_back({"cylinder", shapes::heights(15.0, n, cylinder), onCylinder});
  return out;
}

/// Mean error of a model's force, as a share, at places all over the mesh that the choice does not use.
double trueError(const Known& known, const TriangleTree& tree, ContactModel model, double depth_mm) {
  const Mesh& mesh = tree.mesh();
  BodyContact contact(tree, {.stiffness_N_per_mm = 1.0}, {.model = model});
  double sum = 0.0;
  int count = 0;
  for (std::uint32_t t = 3; t < mesh.triangles().size(); t += 7) {
    const Triangle& c = mesh.triangles()[t];
    const auto v = mesh.vertices();
    const double a = 0.15 + 0.02 * (t % 30), b = 0.1 + 0.001 * (t % 100);
    const Vec3 at = a * v[c[0]] + b * v[c[1]] + (1.0 - a - b) * v[c[2]];
    const Vec3 probe = at - depth_mm * mesh.triangleNormal(t);
    const Vec3 truth = known.foot(probe) - probe;
    const Vec3 low = mesh.report().lowest_mm, high = mesh.report().highest_mm;
    const bool rim = mesh.report().rim_edges > 0 &&
                     (at.x - low.x < 4.0 || high.x - at.x < 4.0 || at.y - low.y < 4.0 || high.y - at.y < 4.0);
    if (rim) continue;  // there the surface itself ends
    sum += length(contact.touch(probe, {}, tree.nearest(probe)).force_N - truth) / length(truth);
    ++count;
  }
  return sum / count;
}

TEST(ContactChoice, ItsMeasureOfAModelIsThatOnTheSurfaceItselfOrLittleMore) {
  for (const Known& known : surfaces()) {
    const Mesh mesh = shapes::built(known.soup);
    const TriangleTree tree(mesh);
    const ContactChoiceReport report = chooseContact(tree, {.stiffness_N_per_mm = 1.0}, {}, 0.01);
    for (const ModelTrial& trial : report.trials) {
      if (trial.model != ContactModel::facet && trial.model != ContactModel::vicinity) continue;
      const double truth = trueError(known, tree, trial.model, report.depth_mm);
      EXPECT_GE(trial.mean_error, 0.9 * truth) << known.name << ' ' << mesh.triangles().size();
      EXPECT_LE(trial.mean_error, 2.5 * truth + 2e-4) << known.name << ' ' << mesh.triangles().size();
    }
  }
}

TEST(ContactChoice, TheCheapestThatMeetsTheAccuracyIsTaken) {
  const Mesh mesh = shapes::built(shapes::bumps(90));
  const TriangleTree tree(mesh);
  const auto chosen = [&](double accuracy) { return chooseContact(tree, {.stiffness_N_per_mm = 1.0}, {}, accuracy); };
  EXPECT_EQ(chosen(0.5).chosen, ContactModel::facet);
  EXPECT_TRUE(chosen(0.5).met);
  EXPECT_EQ(chosen(0.01).chosen, ContactModel::vicinity);
  EXPECT_TRUE(chosen(0.01).met);
  EXPECT_EQ(chosen(1e-9).chosen, ContactModel::vicinity);
  EXPECT_FALSE(chosen(1e-9).met);
}

TEST(ContactChoice, ACubeNeedsNoMoreThanItsFacets) {
  const Mesh mesh = shapes::built(shapes::box(10.0, 10.0, 10.0));
  const TriangleTree tree(mesh);
  EXPECT_EQ(chooseContact(tree, {.stiffness_N_per_mm = 1.0}, {}, 0.01).chosen, ContactModel::facet);
}

TEST(ContactChoice, AThinWallNeedsAProxy) {
  const Mesh mesh = shapes::built(shapes::box(20.0, 20.0, 0.1));
  const TriangleTree tree(mesh);
  const ContactChoiceReport report = chooseContact(tree, {.stiffness_N_per_mm = 1.0}, {}, 0.01);
  EXPECT_EQ(report.chosen, ContactModel::proxy);
}

TEST(SoftChoice, TheFewestPointsThatMeetTheAccuracyAreTaken) {
  const SoftMaterial material{
      .mass_kg = 0.01, .rigidity_N_per_mm = 0.5, .viscosity_Ns_per_mm = 0.002, .spread_mm = 6.0};
  const Mesh mesh = sheet(40, 60.0);
  const TriangleTree tree(mesh);
  const auto all = chooseSoft(tree, material, 1e-9);
  ASSERT_TRUE(all.has_value());
  for (std::size_t i = 1; i < all->trials.size(); ++i) {
    EXPECT_GT(all->trials[i].most_points, all->trials[i - 1].most_points);
    EXPECT_LT(all->trials[i].mean_error, all->trials[i - 1].mean_error);
  }
  EXPECT_GT(all->trials.front().mean_error, 0.02);
  EXPECT_LT(all->trials.back().mean_error, 1e-3);
  const double between = 0.5 * (all->trials[1].mean_error + all->trials[2].mean_error);
  const auto some = chooseSoft(tree, material, between);
  ASSERT_TRUE(some.has_value());
  EXPECT_TRUE(some->met);
  EXPECT_EQ(some->chosen.most_points, all->trials[2].most_points);
  // What is said holds in a press that the choice does not make: elsewhere, slower, deeper.
  const auto force = [&](std::size_t most_points) {
    SoftBody body = *SoftBody::build(tree, material, {.most_points = most_points});
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) sum += body.step(1e-3, {4.3, -3.1, 0.2 - 0.008 * i}).force_N.z;
    return sum;
  };
  const double whole = force(SIZE_MAX);
  EXPECT_LT(std::abs(force(some->chosen.most_points) - whole), 2.0 * between * whole);
}

}  // namespace
}  // namespace fyd::scene
