// The link panel of the window: the state of the link, and the choice of the robot.
#pragma once

#include "app/console/shell/side_dock.h"
#include "core/pipeline/telemetry.h"
#include "widgets/devices/link_panel.h"
#include "widgets/devices/robot_form.h"
#include "widgets/tuning/coupling_form.h"

namespace fyd::console {

class LinkDock : public SideDock {
  Q_OBJECT
 public:
  explicit LinkDock(widgets::TuningModel& model, QWidget* parent = nullptr);

  /// The robot may be changed only while the motors are off; the values that it
  /// sends decide which couplings are possible.
  void showSample(const pipeline::TelemetrySample& newest);
  /// Whether the haptic loop sends no telemetry: it is then unknown whether something can move.
  void showSilence(bool silent);
  /// To be called when the session began anew; its state is known with its first sample. @param open false: there is no
  /// session now, and nothing can move
  void restart(bool open);

  /// A change of the robot is under way: another has to wait. @param words the work under way; empty: none
  void showWork(const QString& words, bool can_be_cancelled);

  [[nodiscard]] bool mayReconnect() const;
  [[nodiscard]] widgets::LinkPanel* panel() const { return panel_; }
  [[nodiscard]] widgets::CouplingForm* coupling() const { return coupling_; }
  [[nodiscard]] widgets::RobotForm* form() const { return form_; }

 private:
  LinkDock(widgets::LinkPanel* panel, widgets::CouplingForm* coupling, widgets::RobotForm* form, QWidget* parent);
  void refresh() { form_->setAllowed(mayReconnect()); }

  bool can_move_ = true;  // until the first sample says otherwise
  bool silent_ = false;
  bool closed_ = false;
  widgets::LinkPanel* panel_;
  widgets::CouplingForm* coupling_;
  widgets::RobotForm* form_;
};

}  // namespace fyd::console
