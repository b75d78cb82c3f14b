// Soft bodies beside closed forms and beside a body that is stepped finer.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "../../unit/scene/soft_sheet.h"

namespace fyd::scene {
namespace {

/// Displacement [mm] at a distance r from a press of 1 N with the weight (1 − r²/R²)² on an endless membrane of tension
/// T on a foundation k, by Hankel transform: the weight's is 48·J3(qR)/(qR)³. `averaged` over the same weight instead
/// of at r.
double membrane(double k, double spread, double radius, double r, bool averaged) {
  const double dq = 0.0005 / radius;
  double sum = 0.0;
  for (int i = 0; i < 120'000; ++i) {
    const double q = (i + 0.5) * dq, x = q * radius;
    const double weight = x < 0.02 ? 1.0 : 48.0 * std::cyl_bessel_j(3.0, x) / (x * x * x);
    const double seen = averaged ? weight : std::cyl_bessel_j(0.0, q * r);
    sum += weight * seen * q / (1.0 + q * q * spread * spread) * dq;
  }
  return sum / (2.0 * std::numbers::pi * k);
}

TEST(SoftMaterialTruth, TheDepthOfAUnitPressIsThatOfTheMembrane) {
  for (const double finger : {0.5, 2.0, 5.0}) {
    for (const double spread : {0.0, 0.3, 1.0, 3.0, 10.0}) {
      const double truth = membrane(1.0, spread, finger, 0.0, true);
      EXPECT_NEAR(depthOfUnitPress(finger, spread), truth, 0.003 * truth) << finger << " " << spread;
    }
  }
}

TEST(SoftBodyTruth, ASlowPressHasItsRigidityAndTheMembranesShape) {
  const SoftMaterial material{0.01, 0.5, 0.01, 3.0, 4.0};
  for (const int cells : {60, 85, 120}) {
    SoftSheet s(cells, 60.0, material);
    ASSERT_EQ(s.body.finger_mm(), 4.0);
    for (int i = 0; i < 2000; ++i) s.body.step(1e-3, {0.13, 0.21, -1.5});
    EXPECT_NEAR(s.body.contact().force_N.z, 0.75, 0.02 * 0.75) << cells;
    const double k = s.body.surface().foundation_N_per_mm3;
    const double top = 0.75 * membrane(k, 3.0, 4.0, 0.0, false);
    for (const double far : {0.0, 1.0, 2.5, 5.0, 8.0}) {
      // The vertex nearest to (far, 0).
      std::uint32_t at = 0;
      const auto off = [&](std::uint32_t v) {
        const Vec3 d = s.mesh.vertices()[v] - Vec3{0.13 + far, 0.21, 0.0};
        return d.norm();
      };
      for (std::uint32_t v = 0; v < s.mesh.vertices().size(); ++v) at = off(v) < off(at) ? v : at;
      const Vec3 d = s.mesh.vertices()[at] - Vec3{0.13, 0.21, 0.0};
      const double truth = 0.75 * membrane(k, 3.0, 4.0, d.norm(), false);
      EXPECT_NEAR(-s.body.displacement_mm(at).z, truth, 0.02 * top) << cells << " at " << far;
    }
  }
}

/// Largest error of a point that was held and let go, as a share of where it was held.
double oscillatorError(double longest_step_s) {
  // Without spread every vertex is alone: the mass of its area on the foundation of its area.
  const double f_Hz = 5.0, damping = 0.2, omega = 2.0 * std::numbers::pi * f_Hz;
  const double rigidity = 0.5, finger = 4.0, side = 20.0;
  const double k = rigidity * 9.0 / (5.0 * std::numbers::pi * finger * finger);  // ∫w² = 9/(5πR²)
  const SoftMaterial material{1000.0 * k * side * side / (omega * omega), rigidity, rigidity * 2.0 * damping / omega,
                              0.0, finger};
  SoftSheet s(20, side, material, {.longest_step_s = longest_step_s, .most_parts = 10, .tolerance = 1e-8});
  for (int i = 0; i < 3000; ++i) s.body.step(1e-3, {0.0, 0.0, -1.0});
  std::uint32_t middle = 0;  // the mesh has an order of its own
  for (std::uint32_t v = 0; v < s.mesh.vertices().size(); ++v) {
    if (s.mesh.vertices()[v].norm() < s.mesh.vertices()[middle].norm()) middle = v;
  }
  const double held = s.body.displacement_mm(middle).z;
  EXPECT_LT(held, -0.9);
  double worst = 0.0;
  const double swing = omega * std::sqrt(1.0 - damping * damping);
  for (int i = 1; i <= 300; ++i) {
    s.body.step(1e-3, {0.0, 0.0, 20.0});
    const double t = 1e-3 * i;
    const double truth =
        held * std::exp(-damping * omega * t) * (std::cos(swing * t) + damping * omega / swing * std::sin(swing * t));
    worst = std::max(worst, std::abs(s.body.displacement_mm(middle).z - truth));
  }
  return worst / -held;
}

TEST(SoftBodyTruth, APointLetGoSwingsAsADampedOscillator) {
  const double fine = oscillatorError(1e-4), coarse = oscillatorError(1e-3);
  RecordProperty("share_of_amplitude_at_1_ms", std::to_string(coarse));
  RecordProperty("share_of_amplitude_at_0_1_ms", std::to_string(fine));
  EXPECT_LT(fine, 0.005);
  EXPECT_LT(coarse, 0.04);  // first order: ten times the finer one's
}

TEST(SoftBodyTruth, PressedAndSlidItsForceIsThatOfABodyAllAwakeAtATenthOfTheStep) {
  for (const double mass : {0.0, 0.1}) {
    const SoftMaterial material{mass, 0.5, 0.01, 3.0, 4.0};
    SoftSheet s(40, 40.0, material);
    SoftSheet truth(40, 40.0, material, {.border = 1e-5, .longest_step_s = 1e-4, .most_parts = 10, .tolerance = 1e-6});
    double worst = 0.0, largest = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double t = 1e-3 * i;
      const double deep = 0.5 * (1.0 - std::cos(6.0 * t));
      const Vec3 hand{t > 0.3 ? 5.0 * (1.0 - std::cos(3.0 * (t - 0.3))) : 0.0, 0.3, 0.2 - 2.0 * deep};
      const Vec3 f = s.body.step(1e-3, hand).force_N, g = truth.body.step(1e-3, hand).force_N;
      worst = std::max(worst, (f - g).norm());
      largest = std::max(largest, g.norm());
    }
    EXPECT_GT(largest, 0.8);
    EXPECT_LT(worst, 0.02 * largest) << "mass " << mass;
    RecordProperty("worst_share_mass_" + std::to_string(mass), std::to_string(worst / largest));
  }
}

TEST(SoftBodyTruth, TwiceTheTrianglesFeelTheSame) {
  const SoftMaterial material{0.05, 0.5, 0.01, 3.0, 4.0};
  SoftSheet coarse(45, 50.0, material), fine(64, 50.0, material);
  double worst = 0.0, largest = 0.0;
  for (int i = 0; i < 1500; ++i) {
    const double t = 1e-3 * i;
    const Vec3 hand{6.0 * std::sin(2.0 * t), 0.3, 0.2 - 1.1 * (1.0 - std::cos(6.0 * t))};
    const Vec3 f = coarse.body.step(1e-3, hand).force_N, g = fine.body.step(1e-3, hand).force_N;
    worst = std::max(worst, (f - g).norm());
    largest = std::max(largest, g.norm());
  }
  EXPECT_GT(largest, 0.8);
  EXPECT_LT(worst, 0.03 * largest);
  RecordProperty("worst_share", std::to_string(worst / largest));
}

}  // namespace
}  // namespace fyd::scene
