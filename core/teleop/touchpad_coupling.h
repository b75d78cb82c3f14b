// What comes back from the robot, as the stiffness asked of the cloth.
//
// A touchpad is an impedance display: it chooses how stiff the cloth is, and nothing else. A finger of force F that
// presses the cloth by x puts ∫F dx into it. A cloth that does not change gives no more than that back; one that is
// stiffened by dk while it is pressed by x gives ½·x²·dk more. N·mm are mJ.
//
//   direct  the stiffness that the robot tells, as it comes
//   spring  the paper's, force reflection: the robot's force, late as it is, over the indentation of now
//   tdpa    the same, with the energy of this touch observed: the cloth is never asked to be so stiff that ½·k·x² is
//           more than was put in (time-domain passivity); a tolerance pays for what the sensors and the cloth's curve
//           are off
//   model   the robot's estimate is kept here and felt from here. It stiffens out of contact, or where the robot has
//           felt it at another place than the one before, and then with the time constant at which it softens; it
//           softens at any time. A robot that touches nothing says nothing of the surface, unless its tool is beyond
//           where it met it: then the surface is gone, and the cloth softens as far as it may
//
// Whatever comes in, the target is a number within the range of targets as soon as the robot has told one (direct:
// what it told). Allocates nothing, reads no clock.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/base/vec3.h"

namespace fyd::teleop {

enum class TouchpadCouplingChoice : std::uint8_t { direct, spring, tdpa, model };
inline constexpr std::array<std::string_view, 4> kTouchpadCouplingNames = {"direct", "spring", "tdpa", "model"};

/// What a cloth may be asked for.
inline constexpr double kLeastTarget_N_per_mm = 0.05, kMostTarget_N_per_mm = 3.0;

/// NaN: not told.
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
  std::uint64_t robot_count = 0;  ///< changes with each that is told; 0: nothing told in this session
  bool touched = false;
  double indentation_mm = 0.0;  ///< NaN: unknown
  double force_N = 0.0;         ///< of the finger on the cloth; NaN: unknown
  double cloth_N_per_mm =
      std::numeric_limits<double>::quiet_NaN();  ///< by the law, at the stretch of now; NaN: unknown
  double least_indentation_mm = 1.0;             ///< nothing is divided by less
};

struct TouchpadCouplingOutput {
  double target_N_per_mm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing told (direct: as told)
  double finger_energy_mJ = std::numeric_limits<double>::quiet_NaN();
  double withheld_mJ = std::numeric_limits<double>::quiet_NaN();
};

/// Energy of one touch: what the finger has put into the cloth less what came back. It begins anew with each touch and
/// stays after it.
///
///   E = ½·F·x − ∫ ½·F·x · d(ln k)     what the cloth holds now, less what its motors put in while it was pressed
///
/// That is ∫F dx of a cloth without losses, of which the finger pays more. Summing F dx itself would sum what the
/// indentation wanders by (half of the energy of a press). k is what the stretch of now gives by the law; what is not
/// known is passed over, and made up for with the next that is.
class TouchEnergy {
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

class TouchpadCoupling {
 public:
  [[nodiscard]] TouchpadCouplingOutput step(const TouchpadCouplingInput& input);

  /// Two places of the robot nearer to each other than this are one: a resting finger's tremor and a classic robot's
  /// whole millimetres lie within.
  static constexpr double kOnePlace_mm = 2.0;
  /// Estimates that differ by less are the same.
  static constexpr double kSame = 0.01;
  /// tdpa: so much more than was put in may be asked for, as a part of it.
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
  double estimate_ = 0.0;  // the newest that tells of a surface, N/mm, within the range of targets; 0: none yet
  Vec3 told_place_mm_;     // where the robot felt it
  Vec3 met_place_mm_;      // there, and as high as it felt something near there
  bool met_ = false;
  bool gone_ = false;   // its tool is beyond, and touches nothing
  double model_ = 0.0;  // N/mm, what is felt; 0: none yet
  Vec3 place_mm_;       // whose estimate that is
};

}  // namespace fyd::teleop
