// Computes the cloth's target stiffness from the robot's messages.
//
// A touchpad is an impedance display: it controls the cloth's stiffness only. A finger of force F that presses the
// cloth by x does the work ∫F dx on it. A cloth of constant stiffness gives back no more than that; one that is
// stiffened by dk while it is pressed by x gives back ½·x²·dk more. 1 N·mm = 1 mJ.
//
//   direct  the stiffness that the robot sends, unchanged
//   spring  the paper's force reflection: the robot's delayed force over the present indentation
//   tdpa    the same, with the energy of this touch observed: the target stiffness is limited so that ½·k·x² is no more
//           than was put in (time-domain passivity); a tolerance allows for errors of the sensors and the cloth's curve
//   model   the robot's estimate is stored here and rendered from here. It stiffens out of contact, or where the robot
//           has measured it at another place than the one before, and then with the time constant at which it softens;
//           it softens at any time. A robot that touches nothing gives no information about the surface, unless its
//           tool is beyond the place of contact: then the surface is gone, and the cloth softens as far as possible
//
// For any input the target is a number within the range of targets as soon as the robot has sent a stiffness (direct:
// as sent). Allocates nothing, reads no clock.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/base/api.h"
#include "core/base/vec3.h"

namespace fyd::teleop {

enum class TouchpadCouplingChoice : std::uint8_t { direct, spring, tdpa, model };
inline constexpr std::array<std::string_view, 4> kTouchpadCouplingNames = {"direct", "spring", "tdpa", "model"};

/// Range of target stiffnesses.
inline constexpr double kLeastTarget_N_per_mm = 0.05, kMostTarget_N_per_mm = 3.0;

/// State of the robot as sent by it; NaN: not sent.
struct RobotTold {
  double stiffness_N_per_mm = std::numeric_limits<double>::quiet_NaN();  ///< 0: it touches nothing
  double force_N = std::numeric_limits<double>::quiet_NaN();             ///< of its tool on what it touches
  Vec3 position_mm;                                                      ///< of the tool, z up
};

struct TouchpadCouplingInput {
  TouchpadCouplingChoice choice = TouchpadCouplingChoice::direct;
  double elapsed_s = 0.001;       ///< since the last step
  bool led = false;               ///< the cloth follows the robot now; false: nothing is withheld
  RobotTold robot;                ///< the newest
  std::uint64_t robot_count = 0;  ///< changes with each new `robot`; 0: none in this session
  bool touched = false;
  double indentation_mm = 0.0;  ///< NaN: unknown
  double force_N = 0.0;         ///< of the finger on the cloth; NaN: unknown
  double cloth_N_per_mm =
      std::numeric_limits<double>::quiet_NaN();  ///< by the law, at the stretch of now; NaN: unknown
  double least_indentation_mm = 1.0;             ///< nothing is divided by less
};

struct TouchpadCouplingOutput {
  double target_N_per_mm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing sent (direct: as sent)
  double finger_energy_mJ = std::numeric_limits<double>::quiet_NaN();
  double withheld_mJ = std::numeric_limits<double>::quiet_NaN();
};

/// Energy of one touch: what the finger has put into the cloth less what came back. It begins anew with each touch and
/// stays after it.
///
///   E = ½·F·x − ∫ ½·F·x · d(ln k)     what the cloth holds now, less what its motors put in while it was pressed
///
/// That is ∫F dx of a cloth without losses; with losses the finger's work is larger. Summing F dx directly would sum
/// the noise of the indentation too (half of the energy of a press). k is the law's value at the present stretch.
/// Unknown values are skipped, and made up for with the next known one.
class FYD_API TouchEnergy {
 public:
  /// @return by how much the indentation grew, mm, and its mean meanwhile; 0 where that is not known
  struct Step {
    double mean_mm = 0.0, grew_mm = 0.0;
  };
  Step observe(bool touched, double indentation_mm, double force_N, double cloth_N_per_mm);
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] double energy_mJ() const { return energy_mJ_; }
  [[nodiscard]] bool began() const { return began_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(known_, touched_, began_, depth_mm_, cloth_, given_mJ_, energy_mJ_);
  }

 private:
  bool known_ = false;
  bool touched_ = false;
  bool began_ = false;  // with this step
  double depth_mm_ = 0.0;
  double cloth_ = 0.0;     // k, N/mm; 0: not known yet
  double given_mJ_ = 0.0;  // by the motors
  double energy_mJ_ = 0.0;
};

class FYD_API TouchpadCoupling {
 public:
  [[nodiscard]] TouchpadCouplingOutput step(const TouchpadCouplingInput& input);

  /// Two places of the robot nearer to each other than this count as the same: a resting finger's tremor and the
  /// classic protocol's rounding to whole millimetres are smaller.
  static constexpr double kOnePlace_mm = 2.0;
  /// Estimates that differ by less are the same.
  static constexpr double kSame = 0.01;
  /// tdpa: share by which the target's energy may exceed the energy that was put in.
  static constexpr double kTolerance = 0.1;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(energy_, withheld_mJ_, count_, estimate_, told_place_mm_, met_place_mm_, met_, gone_, model_, place_mm_);
  }

 private:
  void hear(const TouchpadCouplingInput& input);
  void follow(const TouchpadCouplingInput& input);
  [[nodiscard]] double surface() const { return gone_ ? kLeastTarget_N_per_mm : estimate_; }
  [[nodiscard]] double reflected(const TouchpadCouplingInput& input) const;

  TouchEnergy energy_;
  double withheld_mJ_ = 0.0;
  std::uint64_t count_ = 0;
  double estimate_ = 0.0;  // the newest estimate of a surface, N/mm, within the range of targets; 0: none yet
  Vec3 told_place_mm_;     // where the robot felt it
  Vec3 met_place_mm_;      // the same place, at the greatest height at which contact was felt near it
  bool met_ = false;
  bool gone_ = false;   // the tool is beyond the place of contact and touches nothing
  double model_ = 0.0;  // N/mm, as rendered; 0: none yet
  Vec3 place_mm_;       // the place that model_ was estimated at
};

}  // namespace fyd::teleop
