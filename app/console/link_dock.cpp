#include "app/console/link_dock.h"

#include "core/teleop/predictor.h"

namespace fyd::console {

using pipeline::SafetyState;

LinkDock::LinkDock(QWidget* parent) : LinkDock(new widgets::LinkPanel, new widgets::RobotForm, parent) {}

LinkDock::LinkDock(widgets::LinkPanel* panel, widgets::RobotForm* form, QWidget* parent)
    : SideDock(tr("Link"), QStringLiteral("link_close"), tr("Close the link's panel"), {panel, form}, parent),
      panel_(panel),
      form_(form) {
  QStringList predictors{QStringLiteral("default")};
  for (const std::string_view name : teleop::kPredictorNames) {
    const QString word = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    if (!predictors.contains(word)) predictors.append(word);
  }
  form_->setPredictors(predictors << QStringLiteral("thesis"));
}

void LinkDock::showState(SafetyState state) {
  can_move_ = state == SafetyState::active || state == SafetyState::held;
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

bool LinkDock::mayReconnect() const { return closed_ || (!can_move_ && !silent_); }

}  // namespace fyd::console
