// The link's panel beside the Operate place: how the link is doing, and which robot there is to be.
#pragma once

#include "app/console/side_dock.h"
#include "core/pipeline/telemetry.h"
#include "widgets/coupling_form.h"
#include "widgets/link_panel.h"
#include "widgets/robot_form.h"

namespace fyd::console {

class LinkDock : public SideDock {
  Q_OBJECT
 public:
  explicit LinkDock(widgets::TuningModel& model, QWidget* parent = nullptr);

  /// The robot may be changed only while the motors are off; what it tells decides what a coupling can do.
  void showSample(const pipeline::TelemetrySample& newest);
  /// The haptic loop says nothing: whether something can move is not known.
  void showSilence(bool silent);
  /// The session began anew; what it does is known with its first sample. @param open false: there is none now, and
  /// nothing can move
  void restart(bool open);

  /// A change of the robot is under way: another has to wait. @param words what is done; empty: nothing
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
