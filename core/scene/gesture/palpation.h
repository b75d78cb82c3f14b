// Static touch (tele-gesture paper, "tele-echography"): a probe on a soft abdomen, guided by a hand for a robot far
// away that cannot move as fast as a hand.
//
//   along the normal     the abdomen's own force, as the remote robot's sensor measures it; where nothing is measured,
//                        gesture.h's spring and damper of the contact
//   across the normal    nothing up to the remote robot's speed limit; beyond it a force against the hand that grows by
//                        `steepness_Ns_per_mm` with each mm/s too many and saturates at `most_tangential_N`. It grows
//                        with the depth up to `engage_mm`, so that a contact made in motion begins without a step of
//                        the force.
//
// The hand's speed is the slope of its positions, smoothed over `speed_time_constant_s` against the steps of encoders,
// exactly for any time step. Smoothing delays the force, so it could drive a hand that has turned back. Therefore the
// energy that the force takes from the hand is counted. When it has given more than it took, the force is scaled down,
// to zero at 2 mJ; this debt decays with a time constant of 1 s.
// Stability: may change
#pragma once

#include <optional>

#include "core/base/api.h"
#include "core/scene/gesture/gesture.h"

namespace fyd::scene {

struct PalpationParameters {
  double stiffness_N_per_mm = 0.5;
  double damping_Ns_per_mm = 0.002;
  double most_force_N = 20.0;
  double speed_limit_mm_per_s = 50.0;
  double steepness_Ns_per_mm = 0.05;
  double most_tangential_N = 5.0;
  double engage_mm = 1.0;
  double speed_time_constant_s = 0.01;
  double segment_mm_per_N = 10.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("palpation.stiffness_N_per_mm", stiffness_N_per_mm,
           {.unit = "N/mm",
            .minimum = 1e-6,
            .maximum = 1e4,
            .help = "Stiffness of the abdomen where the scene has no body of its own; more feels harder."});
    v.real(
        "palpation.damping_Ns_per_mm", damping_Ns_per_mm,
        {.unit = "N·s/mm",
         .minimum = 0,
         .maximum = 10,
         .help = "Damping: force along the normal per speed of pressing, never larger than the force of the spring."});
    v.real("palpation.most_force_N", most_force_N,
           {.unit = "N", .minimum = 0, .maximum = 1000, .help = "Largest force along the normal."});
    v.real(
        "palpation.speed_limit_mm_per_s", speed_limit_mm_per_s,
        {.unit = "mm/s",
         .minimum = 0,
         .maximum = 1e4,
         .help =
             "Highest speed of the remote robot along the surface; a hand that is faster feels a force against it."});
    v.real("palpation.steepness_Ns_per_mm", steepness_Ns_per_mm,
           {.unit = "N·s/mm",
            .minimum = 0,
            .maximum = 1,
            .help = "How fast the force against the hand grows with its speed above the limit. To be stable in steps "
                    "of 1 ms it must be less than the hand's mass in kg."});
    v.real("palpation.most_tangential_N", most_tangential_N,
           {.unit = "N",
            .minimum = 0,
            .maximum = 1000,
            .help = "Upper limit of the force against a hand that is too fast."});
    v.real("palpation.engage_mm", engage_mm,
           {.unit = "mm",
            .minimum = 1e-3,
            .maximum = 100,
            .help = "Depth from which a hand that is too fast feels the whole force against it; at less depth it feels "
                    "a part."});
    v.real(
        "palpation.speed_time_constant_s", speed_time_constant_s,
        {.unit = "s",
         .minimum = 0,
         .maximum = 1,
         .help =
             "Time constant of the low-pass filter on the hand's speed; with more, the force is smoother but later."});
    v.real("palpation.segment_mm_per_N", segment_mm_per_N,
           {.unit = "mm/N",
            .minimum = 0,
            .maximum = 1e4,
            .help = "Length of the green line that shows the force, for each newton."});
  }
};

/// The abdomen of a scene without a body of its own.
struct PlaneParameters {
  double x_mm = 0.0, y_mm = 0.0, z_mm = 0.0;
  double normal_x = 0.0, normal_y = 0.0, normal_z = 1.0;

  template <class Visitor>
  void describe(Visitor& v) {
    const ParameterInfo place{.unit = "mm",
                              .minimum = -1e6,
                              .maximum = 1e6,
                              .help = "Position of any point of the plane that stands for the abdomen."};
    const ParameterInfo normal{.minimum = -1,
                               .maximum = 1,
                               .help = "Direction of the plane's normal, out of the abdomen; of any length but 0."};
    v.real("plane.x_mm", x_mm, place);
    v.real("plane.y_mm", y_mm, place);
    v.real("plane.z_mm", z_mm, place);
    v.real("plane.normal_x", normal_x, normal);
    v.real("plane.normal_y", normal_y, normal);
    v.real("plane.normal_z", normal_z, normal);
  }
};

/// What the probe touches, from whichever contact model; of a plane: `touchPlane`.
struct PalpatedSurface {
  Vec3 normal{0.0, 0.0, 1.0};  ///< outwards, of any length but 0
  double depth_mm = 0.0;       ///< ≤ 0: nothing is touched
  double stiffness_N_per_mm = 0.0;
};
[[nodiscard]] FYD_API PalpatedSurface touchPlane(const PalpationParameters& parameters, const PlaneParameters& plane,
                                                 const Vec3& probe_mm);

struct PalpationInputs {
  Vec3 probe_mm;
  PalpatedSurface touch;
  std::optional<double> measured_N;  ///< along the normal, by the remote robot's sensor; held to 0 … most_force_N
};

/// State carried from one step to the next.
struct PalpationState {
  bool known = false;
  Vec3 probe_mm;
  double depth_mm = 0.0;
  Vec3 velocity_mm_per_s;  ///< smoothed
  Vec3 tangential_N;
  double taken_mJ = 0.0;  ///< by the tangential force, from the hand; below 0: given

  template <class Archive>
  void serialize(Archive& archive) {
    archive(known, probe_mm, depth_mm, velocity_mm_per_s, tangential_N, taken_mJ);
  }
};

struct PalpationForce {
  bool touching = false;
  Vec3 force_N;  ///< on the hand: normal_N + tangential_N
  Vec3 normal_N, tangential_N;
  double speed_mm_per_s = 0.0;     ///< across the normal
  double too_fast_mm_per_s = 0.0;  ///< beyond the limit
  ForceSegment segment;            ///< the paper's green segment
  Refusal refusal = Refusal::none;
};

/// A refused input leaves the state as it was and gives no force.
[[nodiscard]] FYD_API PalpationForce stepPalpation(const PalpationParameters& parameters, PalpationState& state,
                                                   const PalpationInputs& inputs, double dt_s);

}  // namespace fyd::scene
