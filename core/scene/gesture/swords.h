// Distributed touch (tele-gesture paper, "swords"): the force between two blades, as the player of one of them feels
// it.
//
// A blade is a segment, thick by a radius that may be 0: then the two are lines in space. Two blades in touch lie
// within the sum of their radii, or have passed through each other: within each step the ends of both move straight,
// the times at which the four lie in a plane are the roots of a cubic, and where the blades meet at one of them they
// have crossed. So no crossing is missed at any speed. A blade that crossed is pushed back to the side it came from
// until it is back, or has slid over an end.
//
//   depth   radii − distance; crossed: radii + distance of the two lines
//   force   along the shortest line between the blades: gesture.h's spring and damper, at most `most_force_N`; friction
//           against the sliding of the two points in touch
//   ends    the force of a crossed blade that slides to an end fades continuously with the distance to the end, from
//           `fade_mm` or from where it crossed; it never grows again in this contact. The depth at which blades lie
//           within their radii from the beginning, or after one slid over an end, gives no force.
//
// Without friction and damping no closed path gives energy. Two exactly parallel blades cross where one comes to lie on
// the other. Blades of radius 0 that move in one common plane never touch.
// Stability: may change
#pragma once

#include <optional>
#include <stdexcept>

#include "core/base/api.h"
#include "core/scene/gesture/gesture.h"

namespace fyd::scene {

struct SwordParameters {
  double length_mm = 900.0;
  double radius_mm = 0.0;
  double stiffness_N_per_mm = 0.5;
  double damping_Ns_per_mm = 0.0005;
  double friction = 0.0;
  double most_force_N = 6.4;  ///< the paper's arm
  double fade_mm = 20.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("swords.length_mm", length_mm,
           {.unit = "mm", .minimum = 1, .maximum = 1e4, .help = "From the grip to the tip."});
    v.real("swords.radius_mm", radius_mm,
           {.unit = "mm", .minimum = 0, .maximum = 100, .help = "Of each blade; 0: a line, as in the paper."});
    v.real("swords.stiffness_N_per_mm", stiffness_N_per_mm,
           {.unit = "N/mm", .minimum = 1e-6, .maximum = 1e4, .help = "Force by depth."});
    v.real(
        "swords.damping_Ns_per_mm", damping_Ns_per_mm,
        {.unit = "N·s/mm", .minimum = 0, .maximum = 10, .help = "Force by speed, at most as much as that by depth."});
    v.real("swords.friction", friction,
           {.minimum = 0, .maximum = 2, .help = "Where one blade slides along the other."});
    v.real("swords.most_force_N", most_force_N,
           {.unit = "N", .minimum = 0, .maximum = 1000, .help = "Across the blade."});
    v.real("swords.fade_mm", fade_mm,
           {.unit = "mm", .minimum = 0, .maximum = 1000, .help = "Nearer to an end, a blade that crossed is let go."});
  }
};

/// Two players who face each other, each with a device.
struct FencingParameters {
  double apart_mm = 1300.0;
  double scale = 5.0;
  double period_s = 0.010;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("fencing.apart_mm", apart_mm,
           {.unit = "mm", .minimum = 0, .maximum = 1e5, .help = "Between the middles of both players' workspaces."});
    v.real("fencing.scale", scale,
           {.minimum = 0.01, .maximum = 100, .help = "Way of a sword's grip by the way of the device."});
    v.real("fencing.period_s", period_s,
           {.unit = "s",
            .minimum = 0.001,
            .maximum = 10,
            .help = "From message to message; the paper's 10, 100, 250, 500 ms."});
  }
};

struct Blade {
  Vec3 grip_mm, tip_mm;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(grip_mm, tip_mm);
  }
};

/// Both blades rise towards the other player by this angle (14°). Level ones would be parallel, and could only meet where
/// one comes to lie on the other.
inline constexpr double kBladesRise_rad = 0.25;

/// The players face each other: where one of them has a blade, as the other one sees it.
[[nodiscard]] inline Blade seenByTheOther(const FencingParameters& players, const Blade& blade) {
  const auto seen = [&](const Vec3& p) { return Vec3{players.apart_mm - p.x, -p.y, p.z}; };
  return {seen(blade.grip_mm), seen(blade.tip_mm)};
}

/// State carried from one step to the next.
struct SwordState {
  bool known = false;  ///< whether there was a step
  Blade local, distant;
  bool touching = false;
  int side = 0;           ///< sign of the volume between the blades, when it was not 0
  bool crossed = false;   ///< the blades have passed through each other
  Vec3 normal;            ///< from the distant blade to the side where the local one belongs
  double free_mm = 0.0;   ///< depth that gives no force: overlap that did not begin with a contact
  double depth_mm = 0.0;  ///< as felt
  double reach_mm = 0.0;  ///< from where the force fades, while crossed
  double hold = 1.0;      ///< share of the force that has not faded

  template <class Archive>
  void serialize(Archive& archive) {
    archive(known, local, distant, touching, side, crossed, normal, free_mm, depth_mm, reach_mm, hold);
    if (side < -1 || side > 1) throw std::out_of_range("no such side of a sword");
  }
};

struct SwordTouch {
  bool touching = false;
  bool crossed = false;
  bool began = false;        ///< in this step
  double began_ago_s = 0.0;  ///< before the end of this step, if it did
  Vec3 force_N;              ///< on the local sword; the distant one's is its opposite
  Vec3 torque_Nmm;           ///< about the local grip
  Vec3 point_mm;             ///< on the local blade
  Vec3 other_point_mm;       ///< on the distant one, nearest to it
  Vec3 normal;               ///< of unit length, towards where the local blade belongs; zero if nothing is touched
  double depth_mm = 0.0;
  Refusal refusal = Refusal::none;
};

/// One step of two swords. A refused input leaves the state as it was and gives no force.
[[nodiscard]] FYD_API SwordTouch stepSwords(const SwordParameters& parameters, SwordState& state, const Blade& local,
                                            const Blade& distant, double dt_s);

/// Where two segments are nearest; of parallel ones, the middle of the stretch where they overlap.
struct NearestOfBlades {
  double at_a = 0.0, at_b = 0.0;  ///< 0 grip … 1 tip
  Vec3 apart_mm;                  ///< from b's point to a's
};
[[nodiscard]] FYD_API NearestOfBlades nearestOf(const Blade& a, const Blade& b);

}  // namespace fyd::scene
