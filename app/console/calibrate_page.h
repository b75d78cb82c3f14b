// The place "Calibrate": the parts with the age of their calibration, what to do now, the live signal, the points, the
// fit. Nothing is changed before "Accept". Motors move only while the operator holds the button of a part that needs
// it, as the station's device tests do, and stand still when it is let go.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <map>
#include <memory>
#include <vector>

#include "app/console/calibrate_average.h"
#include "app/console/calibrate_entries.h"
#include "app/console/calibrate_fit_panel.h"
#include "app/console/calibrate_step.h"
#include "app/console/page.h"
#include "widgets/heading_table.h"
#include "widgets/hold_button.h"
#include "widgets/live_trace.h"
#include "widgets/picture_pick.h"

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

  [[nodiscard]] const std::vector<CalibrationPoint>& points() const { return points_.at(step_); }
  [[nodiscard]] QListWidget* parts() const { return parts_; }
  [[nodiscard]] QString instruction() const { return instruction_->text(); }
  [[nodiscard]] QString live() const { return live_->text(); }
  [[nodiscard]] QString hint() const { return hint_->text(); }
  [[nodiscard]] QString missing() const { return missing_->text(); }
  [[nodiscard]] CalibrationEntryForm* entries() const { return entries_; }
  [[nodiscard]] CalibrationFitPanel* fitPanel() const { return fit_panel_; }
  [[nodiscard]] widgets::PicturePick* picture() const { return picture_; }
  [[nodiscard]] widgets::HeadingTable* table() const { return table_; }
  [[nodiscard]] QPushButton* takeButton() const { return take_; }
  [[nodiscard]] QPushButton* backButton() const { return back_; }
  [[nodiscard]] QPushButton* simulateButton() const { return simulate_; }
  [[nodiscard]] QPushButton* discardButton() const { return discard_; }
  [[nodiscard]] QPushButton* acceptButton() const { return accept_; }
  [[nodiscard]] QPushButton* reportButton() const { return report_; }
  [[nodiscard]] widgets::HoldButton* moveButton() const { return move_; }
  [[nodiscard]] widgets::LiveTrace* trace() const { return trace_; }

 private:
  static constexpr int kPoll_ms = 100;  ///< as often as the devices' reports are renewed

  void build();
  QWidget* buildLeft();
  QWidget* buildMiddle();
  QWidget* buildButtons();
  void showStep(int step);
  void startPoint();
  void endPoint(const QString& why_not);
  void takePoint();
  void takeBack();
  void discard();
  void accept();
  void simulate();
  void startMotion();
  void endMotion();
  void holdOn();
  void takeByItself(const std::vector<CalibrationSignal>& wanted);
  void takeExperiment();
  void offerNext();
  void restartTrace();
  void refreshDrawing();
  void writeReport();
  void refit();
  void refreshTable();
  void refreshParts();
  void refreshButtons();
  void say(const QString& hint, bool warning);
  [[nodiscard]] CalibrationStep& step() const { return *steps_[static_cast<std::size_t>(step_)]; }
  [[nodiscard]] CalibrationScene scene() const;

  PageContext context_;
  std::vector<std::unique_ptr<CalibrationStep>> steps_;
  int step_ = 0;
  std::map<int, std::vector<CalibrationPoint>> points_;  ///< of each step, until accepted or discarded
  std::map<int, bool> simulated_;                        ///< which of them hold simulated points
  std::map<int, bool> on_simulation_;                    ///< and which were measured on the simulated touchpad
  CalibrationFit fit_;
  station::Profile profile_;  ///< with the values in force
  QTimer timer_;              ///< while the page is shown
  QTimer hold_timer_;         ///< while the button is held
  QElapsedTimer clock_;       ///< of the live curve
  station::DeviceTestStatus motion_;
  std::size_t traced_ = 0;  ///< signals on the live curve, the first ones
  CalibrationAverage recent_;
  CalibrationAverage taking_;
  bool taking_now_ = false;
  bool lifted_ = false;    ///< the simulated finger is held away from the cloth
  bool pressing_ = false;  ///< the simulated finger presses while the button is held
  QElapsedTimer pressing_since_;
  std::vector<double> entered_;
  std::vector<device::DeviceReport> devices_;
  pipeline::TelemetrySample newest_;
  sensing::FingerDetection finger_;
  bool silent_ = false;
  bool can_move_ = false;
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;

  QListWidget* parts_;
  QLabel* drawing_;  ///< what the instruction says, as a picture
  QLabel* instruction_;
  QLabel* live_;
  QLabel* hint_;
  QLabel* why_still_;  ///< why motors may not be moved now
  QLabel* missing_;
  QProgressBar* progress_;
  CalibrationEntryForm* entries_;
  CalibrationFitPanel* fit_panel_;
  widgets::PicturePick* picture_;
  widgets::LiveTrace* trace_;
  widgets::HeadingTable* table_;
  widgets::HoldButton* move_;
  QPushButton* report_;
  QPushButton* back_;
  QPushButton* take_;
  QPushButton* simulate_;
  QPushButton* discard_;
  QPushButton* accept_;
};

}  // namespace fyd::console
