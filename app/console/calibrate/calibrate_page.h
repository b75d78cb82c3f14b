// The place "Calibrate": shows the parts with the age of their calibration, instructions, the live signal, the points
// and the fit of a CalibrationRun.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <vector>

#include "app/console/calibrate/calibrate_buttons.h"
#include "app/console/calibrate/calibrate_entries.h"
#include "app/console/calibrate/calibrate_fit_panel.h"
#include "app/console/calibrate/calibrate_part_list.h"
#include "app/console/calibrate/calibration_run.h"
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
  [[nodiscard]] QString unfinished() const override;

  /// Shows a part by its id, "load-cell" or "ir-2"; an unknown one changes nothing.
  void choose(const QString& id);
  /// Reads the signals once, without waiting for the timer.
  void poll();

  [[nodiscard]] const std::vector<CalibrationPoint>& points() const { return run_->points(); }
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

  QWidget* buildLeft();
  QWidget* buildMiddle();
  void connectRun();
  void connectButtons();
  void changeDevices();
  void showStep(int step);
  void showReading(const Result<std::vector<double>>& reading);
  void showPointTaken(bool by_hand);
  void startPoint();
  void offerNext();
  void restartTrace();
  void refreshDrawing();
  void refreshParts();
  void refreshFit();
  void refreshTable();
  void refreshButtons();
  void say(const QString& hint, bool warning);
  [[nodiscard]] CalibrationRun::Picks picks() const;

  PageContext context_;
  QTimer timer_;            ///< while the page is shown
  QElapsedTimer clock_;     ///< of the live curve
  std::size_t traced_ = 0;  ///< signals on the live curve, the first ones

  CalibrationPartList* parts_ = nullptr;
  QLabel* drawing_ = nullptr;  ///< drawing of the instruction
  QLabel* instruction_ = nullptr;
  QLabel* live_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* missing_ = nullptr;
  QProgressBar* progress_ = nullptr;
  CalibrationEntryForm* entries_ = nullptr;
  CalibrationFitPanel* fit_panel_ = nullptr;
  widgets::PicturePick* picture_ = nullptr;
  widgets::LiveTrace* trace_ = nullptr;
  widgets::HeadingTable* table_ = nullptr;
  CalibrationButtons* buttons_ = nullptr;
  CalibrationRun* run_ = nullptr;
};

}  // namespace fyd::console
