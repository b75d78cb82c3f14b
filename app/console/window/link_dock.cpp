#include "app/console/window/link_dock.h"

#include <cmath>

#include "core/teleop/prediction/predictor.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::console {

LinkDock::LinkDock(widgets::TuningModel& model, ConnectionChange& connection, QWidget* parent)
    : LinkDock(new widgets::LinkPanel, new widgets::CouplingForm(model), new widgets::RobotForm, connection, parent) {}

LinkDock::LinkDock(widgets::LinkPanel* panel, widgets::CouplingForm* coupling, widgets::RobotForm* form,
                   ConnectionChange& connection, QWidget* parent)
    : SideDock(tr("Link"), QStringLiteral("link_close"), tr("Close the link's panel"), {panel, coupling, form}, parent),
      connection_(connection),
      panel_(panel),
      coupling_(coupling),
      form_(form) {
  QStringList predictors{QStringLiteral("default")};
  for (const std::string_view name : teleop::kPredictorNames) {
    const QString word = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    if (!predictors.contains(word)) predictors.append(word);
  }
  form_->setPredictors(predictors << QStringLiteral("thesis"));
  connect(form_, &widgets::RobotForm::reconnectAsked, this, [this](const QString& robot, const QString& key_file) {
    ConnectionWords wanted = connection_.present();
    wanted.robot = robot.toStdString();
    wanted.key_file = key_file.toStdString();
    connection_.change(wanted);
  });
  connect(form_, &widgets::RobotForm::cancelAsked, &connection_, &ConnectionChange::cancel);
  connect(&connection_, &ConnectionChange::refreshed, this, &LinkDock::refresh);
  connect(&connection_, &ConnectionChange::arrived, this, &LinkDock::showRobot);
  showRobot(connection_.present());
  refresh();
}

void LinkDock::refresh() {
  form_->setHindrance(connection_.hindrance());
  form_->setWork(connection_.work(), connection_.canBeCancelled());
}

void LinkDock::showRobot(const ConnectionWords& words) {
  form_->setRobot(QString::fromStdString(words.robot), QString::fromStdString(words.key_file));
}

void LinkDock::showSample(const pipeline::TelemetrySample& newest) {
  using Force = widgets::CouplingForm::Force;
  coupling_->setForce(std::isnan(newest.robot_stiffness_N_per_mm) ? Force::unknown
                      : std::isnan(newest.robot_force_N)          ? Force::not_told
                                                                  : Force::told);
  if (!newest.contact) coupling_->setEnergy(newest.finger_energy_mJ, newest.coupling_withheld_mJ);
}

}  // namespace fyd::console
