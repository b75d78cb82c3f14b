// The calibration of one part at a time: signals are read, points taken, fitted and accepted. Without widgets: the
// place "Calibrate" shows it. Nothing is changed before accept(). Motors move only while the operator holds the button
// of a part that needs it; points are then taken automatically, because the other hand may press the cloth.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "app/console/calibrate/calibrate_average.h"
#include "app/console/calibrate/calibrate_points.h"
#include "app/console/calibrate/calibrate_records.h"
#include "app/console/calibrate/calibrate_step.h"
#include "app/console/calibrate/held_motion.h"
#include "app/console/shell/page.h"

namespace fyd::console {

class CalibrationRun : public QObject {
  Q_OBJECT
 public:
  /// @param move_button held while motors move
  CalibrationRun(const PageContext& context, widgets::HoldButton* move_button, QObject* parent);

  /// What the operator picked in the camera's picture.
  struct Picks {
    QImage picture;
    std::optional<QPointF> place_px;
    QRect rectangle_px;
  };
  /// What the operator typed for a point, in each entry's first unit; none: an entry is wrong.
  using Entered = std::optional<std::vector<double>>;

  [[nodiscard]] const CalibrationSteps& steps() const { return steps_; }
  [[nodiscard]] const CalibrationStep& step() const { return *steps_[static_cast<std::size_t>(step_)]; }
  [[nodiscard]] const std::vector<CalibrationPoint>& points() const { return points_.of(step_); }
  /// Each part with points that were not accepted, and how many: "Load cell 5".
  [[nodiscard]] QStringList unaccepted() const;
  [[nodiscard]] bool holdsSimulated() const { return points_.holdsSimulated(step_); }
  [[nodiscard]] const CalibrationFit& fit() const { return fit_; }
  [[nodiscard]] const station::Profile& profile() const { return profile_; }  ///< with the values in force
  [[nodiscard]] const CalibrationAverage& recent() const { return recent_; }  ///< readings behind the live figures
  [[nodiscard]] bool taking() const { return taking_now_; }                   ///< a point is being averaged
  [[nodiscard]] double progress() const;                                      ///< of it, or of an experiment; 0 to 1
  [[nodiscard]] bool mayMove() const;      ///< nothing renders, and the station answers
  [[nodiscard]] QString whyStill() const;  ///< why nothing may be moved; empty: it may, or the station is silent

  /// Takes the values in force, as after a change of the profile.
  void takeProfile();
  /// A tare: other values are in force, and a point that is being averaged was read with the former ones.
  void takeTare();
  /// A tare, also while another place is shown: discards the points that were read with the former zeros.
  void forgetTared();
  /// Other devices are connected: no point of the former ones remains.
  void changeDevices();
  /// Goes to another part; ends a motion, or a point that is being averaged.
  void choose(int step);
  void end();
  /// Forgets the readings behind the live figures.
  void restartReadings();
  /// Reads the signals once. @return an error says what is missing; a point that is being averaged then ends
  [[nodiscard]] Result<std::vector<double>> read(const Picks& picks);
  /// Adds the reading to the point that is being averaged, or takes the next one automatically.
  void advance(const Picks& picks, const std::vector<double>& reading);

  void startPoint(const Picks& picks, const Entered& entered);
  void takeBack();
  void discard();
  /// Points of the simulator instead of a measurement.
  void simulate();
  void startMotion(const Entered& entered);
  void accept(const AcceptedWords& words);
  void writeReport();

 signals:
  void said(const QString& hint, bool warning);
  void fitted();          ///< points, fit or what may be done have changed
  void allowedChanged();  ///< what may be done has changed
  void pointTaken(bool by_hand);
  void motionEnded();
  void accepted();
  void nameMissing();   ///< nothing is accepted before somebody says who measured
  void fingerLifted();  ///< the simulated finger has left the cloth: a point may be started

 private:
  [[nodiscard]] CalibrationScene scene(const Picks& picks) const;
  void endPoint(const QString& why_not);
  void takePoint();
  void takeByItself(const Picks& picks);
  void takeExperiment();
  void refit();
  /// What was read with other values of this calibration is none with those in force now; tells which parts' it was.
  void discardReadWith(std::string_view procedure);
  /// "Load cell 5".
  [[nodiscard]] QString counted(int part) const;
  [[nodiscard]] PointOrigin originOfReadings() const;
  /// Why points from there cannot be added to this part's, and what to do; empty: they can.
  [[nodiscard]] QString otherOrigin(PointOrigin origin) const;

  PageContext context_;
  HeldMotion* motion_ = nullptr;
  station::Profile profile_;
  CalibrationSteps steps_;
  int step_ = 0;
  std::optional<int> sweep_of_;  ///< the part whose sweep is under way
  CalibrationPoints points_;
  CalibrationFit fit_;
  CalibrationAverage recent_;
  CalibrationAverage taking_;
  bool taking_now_ = false;
  bool lifted_ = false;  ///< the simulated finger is held away from the cloth
  std::vector<double> entered_;
  std::vector<device::DeviceReport> devices_;
  sensing::FingerDetection finger_;
  pipeline::TelemetrySample newest_;
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  bool silent_ = false;
};

}  // namespace fyd::console
