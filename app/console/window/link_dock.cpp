#include "app/console/window/link_dock.h"

#include <cmath>

#include "core/teleop/prediction/predictor.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::console {

using pipeline::SafetyState;

LinkDock::LinkDock(widgets::TuningModel& model, QWidget* parent)
    : LinkDock(new widgets::LinkPanel, new widgets::CouplingForm(model), new widgets::RobotForm, parent) {}

LinkDock::LinkDock(widgets::LinkPanel* panel, widgets::CouplingForm* coupling, widgets::RobotForm* form,
                   QWidget* parent)
    : SideDock(tr("Link"), QStringLiteral("link_close"), tr("Close the link's panel"), {panel, coupling, form}, parent),
      panel_(panel),
      coupling_(coupling),
      form_(form) {
  QStringList predictors{QStringLiteral("default")};
  for (const std::string_view name : teleop::kPredictorNames) {
    const QString word = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    if (!predictors.contains(word)) predictors.append(word);
  }
  form_->setPredictors(predictors << QStringLiteral("thesis"));
}

void LinkDock::showSample(const pipeline::TelemetrySample& newest) {
  using Force = widgets::CouplingForm::Force;
  can_move_ = newest.state == SafetyState::active || newest.state == SafetyState::held;
  coupling_->setForce(std::isnan(newest.robot_stiffness_N_per_mm) ? Force::unknown
                      : std::isnan(newest.robot_force_N)          ? Force::not_told
                                                                  : Force::told);
  if (!newest.contact) coupling_->setEnergy(newest.finger_energy_mJ, newest.coupling_withheld_mJ);
  refresh();
}

void LinkDock::showSilence(bool silent) {
  silent_ = silent;
  refresh();
}

void LinkDock::restart(bool open) {
  closed_ = !open;
  can_move_ = true;
  refresh();
}

void LinkDock::showWork(const QString& words, bool can_be_cancelled) { form_->setWork(words, can_be_cancelled); }

bool LinkDock::mayReconnect() const { return closed_ || (!can_move_ && !silent_); }

}  // namespace fyd::console
