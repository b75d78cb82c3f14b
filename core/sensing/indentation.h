// Indentation of the cloth under the finger from distance sensors beside it [thesis §4.1.2].
//
// contact: as membrane, with the radius from the area that the camera sees, the camera's perspective removed, and with
//   the uncertainty of the shares (contact_cloth.h). The force fusion learns the compliance at the middle of the cloth;
//   place and contact area convert it to that under the finger.
// membrane: each sensor sees its own share of the indentation δ, zᵢ = dᵢ − offsetᵢ = −sᵢ(x, y)·δ, with sᵢ from
//   membrane.h at the camera's (x, y). Two Kalman filters of δ, one for a finger that holds and one for a finger that
//   moves, mix their estimates at each reading (interacting multiple models); readings far from what the moving one
//   expects are left out until they persist.
//   While the load cell gives a force, the two filters serve only as a check, and δ = c·F with the touch's compliance c
//   learnt from the same readings (force_fusion.h).
// thesis: plane through the sensors at (x, y), accepted when it moved < 2 mm, smoothed 0.8/0.2. As printed, the gate
//   can shut for good; here it opens again after five readings that agree with each other. Three valid sensors are
//   needed.
//
// Sensors outside their span, or stuck while the others move, are left out while the rest suffice. A lifted
// finger is no fault: available, 0 mm, as long as enough sensors are valid.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "core/base/api.h"
#include "core/base/timed.h"
#include "core/sensing/cloth_plane.h"
#include "core/sensing/contact_cloth.h"
#include "core/sensing/finger_types.h"
#include "core/sensing/force_fusion.h"
#include "core/sensing/indentation_filter.h"
#include "core/sensing/indentation_parameters.h"
#include "core/sensing/ir_distance.h"
#include "core/sensing/membrane.h"
#include "core/sensing/readings.h"

namespace fyd::sensing {

enum class IndentationReason : std::uint8_t {
  measured,         ///< all sensors used
  untouched,        ///< no finger on the cloth
  some_invalid,     ///< measured without the sensors that are invalid
  inconsistent,     ///< the sensors contradict each other: uncertainty raised
  uncertain,        ///< uncertainty above the limit: unavailable
  too_few_sensors,  ///< too few valid sensors, or too near to one line: unavailable
  ir_stale,         ///< distance readings missing or too old: unavailable
  finger_stale,     ///< no recent picture: unavailable
};

[[nodiscard]] FYD_API std::string_view toString(IndentationReason reason);

struct IndentationEstimate {
  double indentation_mm = 0.0;  ///< downward positive; the last one while unavailable; always finite
  double sigma_mm = 0.0;        ///< standard deviation; 0 while untouched
  bool available = false;
  bool touched = false;  ///< the camera sees a finger
  IndentationReason reason = IndentationReason::ir_stale;
  std::uint32_t sensors = 0;                            ///< how many the touchpad has
  std::array<bool, kMaximumIrSensors> valid{};          ///< per sensor: used now
  std::array<double, kMaximumIrSensors> distance_mm{};  ///< per sensor; NaN when out of span
  Instant taken{};                                      ///< of the distance readings
  std::uint64_t count = 0;                              ///< grows with each new set of readings

  template <class Archive>
  void serialize(Archive& archive) {
    archive(indentation_mm, sigma_mm, available, touched, within(reason, IndentationReason::finger_stale),
            within(sensors, kMaximumIrSensors), contents(valid), distance_mm, taken, count);
  }
};

/// One press as the sensors read it.
struct PressReading {
  std::span<const double> codes;  ///< 12-bit codes or means of them, in the profile's order; NaN: none
  double x_mm = 0.0;              ///< of the contact on the cloth, perspective removed
  double y_mm = 0.0;
  double area_mm2 = std::numeric_limits<double>::quiet_NaN();  ///< of the contact; NaN or 0: unknown
};

class FYD_API IndentationEstimator {
 public:
  explicit IndentationEstimator(const IndentationParameters& parameters = {});
  /// Live changes: no allocation, the present estimate is kept unless the mode changes.
  void configure(const IndentationParameters& parameters);
  /// Readings older than these are stale.
  void setMaximumAges(Duration ir, Duration finger);

  /// @param force_N this step's force on the cloth, NaN when invalid; without one the distances are used alone
  [[nodiscard]] IndentationEstimate step(Instant now, const Timed<IrCounts>& ir, const Timed<FingerDetection>& finger,
                                         const Timed<double>& force_N = {});

  /// One set of readings on its own: no filter, nothing kept for the next step.
  /// contact and membrane: least squares over the sensors' shares, weighted by their noise and, in contact, by what the
  /// model does not know; thesis: the plane.
  [[nodiscard]] IndentationEstimate once(const PressReading& press);

  /// Where the finger of a picture touches the cloth: in contact mode with the camera's perspective at the present
  /// indentation removed and the whole patch on the cloth, else as it was seen.
  [[nodiscard]] Contact contactOf(const FingerDetection& finger) const;

  /// Stiffness of the cloth under this finger over that under a sphere of 8 mm pressed 3 mm deep in the middle: by
  /// place and by the contact's area (contact_cloth.h). NaN while not touched and in the other modes.
  [[nodiscard]] double placeFactor() const;

  /// New distances to the untouched cloth, one per sensor (see tare.h).
  void tare(std::span<const double> offset_mm);
  [[nodiscard]] std::span<const double> offsets_mm() const { return parameters_.ir_offset_mm.view(); }

  /// Condition number of the plane through all sensors; infinite when they lie on one line.
  [[nodiscard]] double conditionNumber() const { return condition_number_; }

  void reset();

  /// 2: adds relative_compliance_ and relative_sigma_; 3: adds log_compliance_sigma_ and seen_depth_mm_
  static constexpr std::uint16_t kStateVersion = 3;

  template <class Archive>
  void serialize(Archive& archive) {
    restore(archive, kStateVersion);
  }
  template <class Archive>
  void restore(Archive& archive, std::uint16_t version) {
    archive(readings_, last_codes_, unchanged_, others_travel_, filter_, fusion_, smoother_, touched_, last_count_,
            was_readable_, was_available_, within(last_reason_, IndentationReason::finger_stale), estimate_);
    if (version >= 2) archive(relative_compliance_, relative_sigma_);
    if (version >= 3) archive(log_compliance_sigma_, seen_depth_mm_);
  }

 private:
  struct Reading {
    IrReading ir;
    double z_mm = 0.0;      // distance less offset
    double sigma_mm = 0.0;  // of one reading
    bool used = false;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(ir.distance_mm, ir.slope_mm_per_V, ir.valid, z_mm, sigma_mm, used);
    }
  };

  void readSensors(const IrCounts& counts);
  void readSensor(std::size_t i, double code);
  void noticeStuck(const IrCounts& counts);
  void updateMembrane(double dt_s, Instant taken, const FingerDetection& finger);
  void updateContact(double dt_s, Instant taken, const FingerDetection& finger);
  void readFilters(Instant now);
  void restartTouch();
  void stepThesis(const FingerDetection& finger);
  void updateShapes(double x_mm, double y_mm);
  /// From one set of readings.
  struct Depth {
    double indentation_mm = 0.0;
    double variance_mm2 = 0.0;
  };
  [[nodiscard]] Depth readPlane(double x_mm, double y_mm) const;
  [[nodiscard]] Depth readShares() const;
  [[nodiscard]] Depth readCloth(const Contact& contact);
  [[nodiscard]] std::uint32_t usedMask() const;
  [[nodiscard]] bool enoughSensors();

  static constexpr double kShapeError = 0.02;  // relative error of δ that the membrane's formula leaves for a disc

  IndentationParameters parameters_;
  Duration ir_maximum_age_ = std::chrono::milliseconds(100);
  Duration finger_maximum_age_ = std::chrono::milliseconds(250);
  std::uint32_t sensor_count_ = 0;
  std::array<SensorPosition, kMaximumIrSensors> positions_{};
  std::array<IrDistance, kMaximumIrSensors> curves_{};
  std::array<Reading, kMaximumIrSensors> readings_{};
  std::array<std::uint16_t, kMaximumIrSensors> last_codes_{};
  std::array<std::uint32_t, kMaximumIrSensors> unchanged_{};  // readings since the code last changed
  std::array<double, kMaximumIrSensors> others_travel_{};     // counts the others moved meanwhile
  Membrane membrane_;
  ContactCloth cloth_;
  ClothPlane plane_;
  std::uint32_t plane_mask_ = 0;
  double condition_number_ = 0.0;
  std::array<double, kMaximumIrSensors> shapes_{};  // at the finger's last position
  double shapes_x_mm_ = 0.0;
  double shapes_y_mm_ = 0.0;
  bool shapes_known_ = false;
  double relative_compliance_ = 1.0;     // contact: compliance here over that in the middle
  double relative_sigma_ = kShapeError;  // relative standard deviation of δ from the shares' errors
  double log_compliance_sigma_ = 0.0;    // standard deviation of ln relative_compliance_
  double seen_depth_mm_ = 0.0;           // contact: low-passed depth, to remove the picture's perspective
  IndentationFilter filter_;
  ForceFusion fusion_;
  ThesisSmoother smoother_;
  bool touched_ = false;
  std::uint64_t last_count_ = 0;
  bool was_readable_ = false;
  bool was_available_ = false;
  IndentationReason last_reason_ = IndentationReason::ir_stale;
  IndentationEstimate estimate_;
};

}  // namespace fyd::sensing
