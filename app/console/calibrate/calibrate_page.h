// The place "Calibrate": the parts with the age of their calibration, instructions, the live signal, the points, the
// fit. Nothing is changed before "Accept". Motors move only while the operator holds the button of a part that needs
// it, as the station's device tests do, and stand still when it is let go.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/console/calibrate/calibrate_average.h"
#include "app/console/calibrate/calibrate_buttons.h"
#include "app/console/calibrate/calibrate_entries.h"
#include "app/console/calibrate/calibrate_fit_panel.h"
#include "app/console/calibrate/calibrate_part_list.h"
#include "app/console/calibrate/calibrate_points.h"
#include "app/console/calibrate/calibrate_step.h"
#include "app/console/calibrate/held_motion.h"
#include "app/console/shell/page.h"
#include "widgets/basics/heading_table.h"
#include "widgets/curves/live_trace.h"
#include "widgets/devices/picture_pick.h"

namespace fyd::console {

class CalibratePage : public Page {
  Q_OBJECT
 public:
  explicit CalibratePage(const PageContext& context, QWidget* parent = nullptr);
  void addCommands(PlaceCommands& commands) override;
  void enter() override;
  void leave() override;

  /// Shows a part by its id, "load-cell" or "ir-2"; an unknown one changes nothing.
  void choose(const QString& id);
  /// Reads the signals once, without waiting for the timer.
  void poll();

  [[nodiscard]] const std::vector<CalibrationPoint>& points() const { return points_.of(step_); }
  [[nodiscard]] QListWidget* parts() const { return parts_; }
  [[nodiscard]] QString instruction() const { return instruction_->text(); }
  [[nodiscard]] QString live() const { return live_->text(); }
  [[nodiscard]] QString hint() const { return hint_->text(); }
  [[nodiscard]] QString missing() const { return missing_->text(); }
  [[nodiscard]] CalibrationEntryForm* entries() const { return entries_; }
  [[nodiscard]] CalibrationFitPanel* fitPanel() const { return fit_panel_; }
  [[nodiscard]] widgets::PicturePick* picture() const { return picture_; }
  [[nodiscard]] widgets::HeadingTable* table() const { return table_; }
  [[nodiscard]] QPushButton* takeButton() const { return buttons_->take(); }
  [[nodiscard]] QPushButton* backButton() const { return buttons_->back(); }
  [[nodiscard]] QPushButton* simulateButton() const { return buttons_->simulate(); }
  [[nodiscard]] QPushButton* discardButton() const { return buttons_->discard(); }
  [[nodiscard]] QPushButton* acceptButton() const { return buttons_->accept(); }
  [[nodiscard]] QPushButton* reportButton() const { return buttons_->report(); }
  [[nodiscard]] widgets::HoldButton* moveButton() const { return buttons_->moveButton(); }
  [[nodiscard]] widgets::LiveTrace* trace() const { return trace_; }

 private:
  static constexpr int kPoll_ms = 100;  ///< as often as the devices' reports are renewed

  void build();
  QWidget* buildLeft();
  QWidget* buildMiddle();
  void connectButtons();
  void showStep(int step);
  void startPoint();
  void endPoint(const QString& why_not);
  void takePoint();
  void takeBack();
  void discard();
  void accept();
  void simulate();
  void startMotion();
  void showMotionEnded();
  void takeByItself(const std::vector<CalibrationSignal>& wanted);
  void takeExperiment();
  void offerNext();
  void restartTrace();
  void refreshDrawing();
  void writeReport();
  [[nodiscard]] PointOrigin originOfReadings() const;
  void refit();
  void refreshTable();
  void refreshButtons();
  void say(const QString& hint, bool warning);
  [[nodiscard]] CalibrationStep& step() const { return *steps_[static_cast<std::size_t>(step_)]; }
  [[nodiscard]] CalibrationScene scene() const;

  PageContext context_;
  std::vector<std::unique_ptr<CalibrationStep>> steps_;
  int step_ = 0;
  bool step_known_ = false;  ///< one was shown
  CalibrationPoints points_;
  CalibrationFit fit_;
  station::Profile profile_;  ///< with the values in force
  QTimer timer_;              ///< while the page is shown
  QElapsedTimer clock_;       ///< of the live curve
  std::size_t traced_ = 0;    ///< signals on the live curve, the first ones
  CalibrationAverage recent_;
  CalibrationAverage taking_;
  bool taking_now_ = false;
  bool lifted_ = false;  ///< the simulated finger is held away from the cloth
  std::vector<double> entered_;
  std::vector<device::DeviceReport> devices_;
  pipeline::TelemetrySample newest_;
  sensing::FingerDetection finger_;
  bool silent_ = false;
  bool can_move_ = false;
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;

  CalibrationPartList* parts_;
  QLabel* drawing_;  ///< drawing of the instruction
  QLabel* instruction_;
  QLabel* live_;
  QLabel* hint_;
  QLabel* missing_;
  QProgressBar* progress_;
  CalibrationEntryForm* entries_;
  CalibrationFitPanel* fit_panel_;
  widgets::PicturePick* picture_;
  widgets::LiveTrace* trace_;
  widgets::HeadingTable* table_;
  CalibrationButtons* buttons_;
  HeldMotion* motion_ = nullptr;
};

}  // namespace fyd::console
