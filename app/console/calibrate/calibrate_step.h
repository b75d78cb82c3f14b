// One part of the calibration: what the operator is to do, which signals a point takes, how points are fitted, what is
// still missing. The place "Calibrate" shows all of them in the same way through this interface.
//
// A new one is a file with its class and a function that makes it, and a line in calibrate_step_list.cpp.
#pragma once

#include <QImage>
#include <QPointF>
#include <QRect>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/calibration/calibration_result.h"
#include "core/device/device_report.h"
#include "core/pipeline/telemetry.h"
#include "core/station/device_test.h"
#include "core/station/profile/profile.h"
#include "widgets/curves/fit_plot.h"

namespace fyd::console {

/// What the operator types for each point.
struct CalibrationEntry {
  QString name;
  QStringList units;             ///< the first is what points are kept in
  std::vector<double> per_unit;  ///< what one of each unit is in the first
  double lowest = 0.0;           ///< in the first unit
  double highest = 0.0;
  int decimals = 2;
  double empty = calibration::kUnknown;  ///< value of an empty field; NaN: something must be typed
};

/// A signal that a point is averaged of.
struct CalibrationSignal {
  QString name;
  QString unit;
  int decimals = 3;
  double largest_spread = 0.0;  ///< standard deviation beyond which it counts as moving
  double turn = 0.0;            ///< from here on it counts from 0 again; 0: it does not
};

/// A point's figures, in the order of `columns`.
using CalibrationPoint = std::vector<double>;

/// What a step may look at.
struct CalibrationScene {
  const std::vector<device::DeviceReport>& devices;
  const pipeline::TelemetrySample& newest;
  const sensing::FingerDetection& finger;  ///< in the newest picture
  const station::Profile& profile;         ///< with the values in force
  const QImage& picture;
  std::optional<QPointF> place_px;          ///< clicked in the picture
  QRect rectangle_px;                       ///< dragged there
  const station::DeviceTestStatus& motion;  ///< state of the motion while the button is held
};

struct CalibrationFit {
  calibration::CalibrationResult result;
  widgets::FitView plot;
  QString legend;            ///< what the lines of the plot are
  QString missing;           ///< coverage: which points to add; empty when there are enough
  QStringList figures = {};  ///< figures of this part beside those of every fit: drift, hysteresis, the law
};

class CalibrationStep {
 public:
  virtual ~CalibrationStep() = default;
  /// The values in force are these now.
  virtual void takeProfile(const station::Profile&) {}
  [[nodiscard]] virtual QString id() const = 0;  ///< "load-cell", "ir-2"
  [[nodiscard]] QString name() const;            ///< calibration::partName
  /// As in the record. Its drawing is resources/icons/calibrate-PROCEDURE.svg, if there is one.
  [[nodiscard]] virtual std::string procedure() const = 0;
  [[nodiscard]] virtual int sensor() const { return 0; }
  /// Id of the parameter that holds the largest accepted held-out error of a fit; empty: there is none.
  [[nodiscard]] virtual std::string_view errorLimit() const { return {}; }
  /// What to do now, in one sentence.
  [[nodiscard]] virtual QString instruction(const std::vector<CalibrationPoint>& points) const = 0;
  [[nodiscard]] virtual QStringList columns() const = 0;
  /// A point as the table shows it, one word for each column.
  [[nodiscard]] virtual QStringList row(const CalibrationPoint& point) const;
  [[nodiscard]] virtual std::vector<CalibrationEntry> entries() const { return {}; }
  [[nodiscard]] virtual std::vector<CalibrationSignal> signalsWanted(const station::Profile&) const { return {}; }
  /// Readings that a point is the mean of, ten a second.
  [[nodiscard]] virtual int readings() const { return 10; }
  /// The signals now; an error says what is missing and what to do.
  [[nodiscard]] virtual Result<std::vector<double>> read(const CalibrationScene& scene) const = 0;
  /// Otherwise: the first signal's mean, what was entered for it, and its spread.
  [[nodiscard]] virtual CalibrationPoint point(const std::vector<double>& entered, const std::vector<double>& mean,
                                               const std::vector<double>& spread) const {
    return {mean[0], entered[0], spread[0]};
  }
  [[nodiscard]] virtual CalibrationFit fit(const std::vector<CalibrationPoint>& points,
                                           const station::Profile& profile) const = 0;
  /// For points that need more than mean and spread: made of all readings. Empty: `point` is used.
  [[nodiscard]] virtual CalibrationPoint pointOf(const std::vector<std::vector<double>>&) const { return {}; }
  /// The point of an experiment, from the rows measured by the haptic loop. Empty: nothing was measured.
  [[nodiscard]] virtual CalibrationPoint pointOfExperiment(const std::vector<texture::SweepRow>&) const { return {}; }
  [[nodiscard]] virtual int interval_ms() const { return 100; }  ///< between readings
  /// Index of the figure of a point that is the first signal's reading, marked beside the live curve. None: −1.
  [[nodiscard]] virtual int readingColumn() const { return 0; }

  /// Motion of the motors while the operator holds the button; points are then taken automatically.
  /// Experiment: one whole press is one point, from the rows that the haptic loop measures meanwhile.
  enum class Motion { none, stretch, sweep, experiment };
  [[nodiscard]] virtual Motion motion() const { return Motion::none; }
  /// Which one runs at the next press of the button.
  [[nodiscard]] virtual device::DeviceTest test(const std::vector<CalibrationPoint>&) const {
    return motion() == Motion::sweep ? device::DeviceTest::sweep : device::DeviceTest::stretch;
  }
  /// Why no point can be taken automatically now; empty: this reading is a new one.
  [[nodiscard]] virtual QString notYet(const CalibrationScene&, const std::vector<CalibrationPoint>&,
                                       const std::vector<double>& /*mean*/) const {
    return {};
  }
  /// What the first field should offer next; NaN: nothing.
  [[nodiscard]] virtual double offer(const std::vector<CalibrationPoint>&) const { return calibration::kUnknown; }
  /// Whether it relies on the measured indentation; the page then warns while the cloth is not calibrated.
  [[nodiscard]] virtual bool trustsIndentation() const { return false; }
  /// Whether its points are read with the values that this calibration finds, and are none of newer ones.
  [[nodiscard]] virtual bool readWith(std::string_view calibration) const;
  /// Whether a new measurement replaces the former one.
  [[nodiscard]] virtual bool onePoint() const { return false; }

  enum class Picture { none, place, rectangle };
  [[nodiscard]] virtual Picture picture() const { return Picture::none; }
  /// Places of the points in the picture.
  [[nodiscard]] virtual std::vector<QPointF> marks(const std::vector<CalibrationPoint>&) const { return {}; }

  /// Points that the simulated touchpad would give, from its own truth and noise; empty: the operator's procedure is
  /// run on the simulation itself, its finger lifted.
  [[nodiscard]] virtual std::vector<CalibrationPoint> simulatedPoints(const station::Profile&) const { return {}; }
};

using CalibrationSteps = std::vector<std::unique_ptr<CalibrationStep>>;
template <class Step, class... Arguments>
[[nodiscard]] CalibrationSteps oneStep(Arguments&&... arguments) {
  CalibrationSteps out;
  out.push_back(std::make_unique<Step>(std::forward<Arguments>(arguments)...));
  return out;
}

/// All steps (calibrate_step_list.cpp).
[[nodiscard]] CalibrationSteps makeCalibrationSteps(const station::Profile& profile);

/// The named value of the first device that has it; an error says what was looked for.
[[nodiscard]] Result<double> liveValue(const std::vector<device::DeviceReport>& devices, const Message& name);

inline constexpr int kDistanceInterval_ms = 20;  ///< about as often as distance sensors measure
/// Readings at that interval whose mean is good to 0.03 mm: 11 s at a noise of 10 mV, four times as long at twice that,
/// at most 60 s.
[[nodiscard]] int distanceReadings(const sensing::IndentationParameters& parameters);

/// A distance sensor with its curve and span in force.
[[nodiscard]] sensing::IrDistance distanceSensorOf(const sensing::IndentationParameters& parameters,
                                                   std::size_t sensor);

/// Whether place and area of the finger are read with the values that this calibration finds.
[[nodiscard]] inline bool placesTheFinger(std::string_view calibration) {
  return calibration == "camera" || calibration == "camera-region";
}

/// A stretch that the operator types, in these limits.
[[nodiscard]] CalibrationEntry stretchEntry(double lowest_deg, double highest_deg);

/// A fit that has no points yet.
/// @param missing which points to take; the empty plot says it too
[[nodiscard]] CalibrationFit noPoints(const QString& missing);

/// A fitted curve of a point's second figure over its first, without the lines themselves.
/// @param titles of the axes
[[nodiscard]] CalibrationFit curveFit(const calibration::CalibrationResult& result,
                                      const std::vector<CalibrationPoint>& points, widgets::FitView titles);

/// What to add, as in the verdict, while there are too few points.
[[nodiscard]] QString missingOf(const calibration::CalibrationResult& result);
[[nodiscard]] std::vector<double> columnOf(const std::vector<CalibrationPoint>& points, std::size_t column);

}  // namespace fyd::console
