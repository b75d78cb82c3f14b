// The link panel of the window: the state of the link, and the choice of the robot.
#pragma once

#include "app/console/shell/connection_change.h"
#include "app/console/shell/side_dock.h"
#include "core/pipeline/telemetry.h"
#include "widgets/devices/link_panel.h"
#include "widgets/devices/robot_form.h"
#include "widgets/tuning/coupling_form.h"

namespace fyd::console {

class LinkDock : public SideDock {
  Q_OBJECT
 public:
  LinkDock(widgets::TuningModel& model, ConnectionChange& connection, QWidget* parent = nullptr);

  /// The values that the robot sends decide which couplings are possible.
  void showSample(const pipeline::TelemetrySample& newest);

  [[nodiscard]] widgets::LinkPanel* panel() const { return panel_; }
  [[nodiscard]] widgets::CouplingForm* coupling() const { return coupling_; }
  [[nodiscard]] widgets::RobotForm* form() const { return form_; }

 private:
  LinkDock(widgets::LinkPanel* panel, widgets::CouplingForm* coupling, widgets::RobotForm* form,
           ConnectionChange& connection, QWidget* parent);
  void refresh();
  void showRobot(const ConnectionWords& words);

  ConnectionChange& connection_;
  widgets::LinkPanel* panel_ = nullptr;
  widgets::CouplingForm* coupling_ = nullptr;
  widgets::RobotForm* form_ = nullptr;
};

}  // namespace fyd::console
