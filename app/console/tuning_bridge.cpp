#include "app/console/tuning_bridge.h"

#include <QDir>
#include <QFileInfo>

#include "app/console/operate_page.h"
#include "widgets/core_text.h"

namespace fyd::console {

using widgets::Severity;

TuningBridge::TuningBridge(Session& session, QString profile_path, QObject* parent)
    : QObject(parent), session_(session), profile_path_(std::move(profile_path)) {
  station::Profile current = session_.currentProfile();
  station::Profile standard;
  const auto bound = bindParameters(current);
  model_.load(bound, bindParameters(standard));
  for (const Parameter& parameter : bound) names_.push_back(QString::fromStdString(std::string(parameter.id)));
  connect(&model_, &widgets::TuningModel::asked, this, &TuningBridge::apply);
}

void TuningBridge::apply(const QString& id, double value) {
  const std::string name = id.toStdString();
  if (const auto ok = session_.setParameter(name, value); !ok) {
    emit told(Severity::warning, widgets::coreText(ok.error().message));
    station::Profile current = session_.currentProfile();
    const auto bound = bindParameters(current);
    if (const Parameter* real = findParameter(bound, name)) model_.accept(name, real->value());
    return;
  }
  ++under_way_[id];
}

void TuningBridge::hear(const pipeline::Event& event) {
  const bool about_parameter =
      event.kind == pipeline::EventKind::parameter_changed || event.kind == pipeline::EventKind::parameter_refused;
  if (!about_parameter || event.index >= names_.size()) return;
  const QString& id = names_[event.index];
  // While own changes are under way, an echo tells of an older one: the slider must not jump back.
  if (int& waiting = under_way_[id]; waiting > 0 && --waiting >= 0) return;
  if (event.kind == pipeline::EventKind::parameter_changed) model_.accept(id.toStdString(), event.value);
}

void TuningBridge::restart() {
  under_way_.clear();
  station::Profile current = session_.currentProfile();
  for (const Parameter& parameter : bindParameters(current)) {
    if (parameter.kind != ParameterKind::list) model_.accept(parameter.id, parameter.value());
  }
}

void TuningBridge::startWithTarget(bool by_hand) {
  by_hand_ = by_hand;
  emit targetShown(by_hand);
}

void TuningBridge::targetByHand() {
  by_hand_ = true;
  const widgets::TunedParameter* target = std::as_const(model_).find(kHandTarget);
  const double value = target != nullptr ? target->value : 0.0;
  if (!session_.command({.action = pipeline::OperatorAction::target_by_hand, .value = value})) {
    emit told(Severity::error, tr("The station did not take the target: too many commands at once. Try again."));
  }
}

void TuningBridge::targetFromRobot() {
  by_hand_ = false;
  if (!session_.command({.action = pipeline::OperatorAction::target_from_robot})) {
    emit told(Severity::error, tr("The station did not take the target: too many commands at once. Try again."));
  }
}

void TuningBridge::save() {
  QDir().mkpath(QFileInfo(profile_path_).absolutePath());
  if (const auto ok = station::saveProfile(session_.currentProfile(), profile_path_.toStdString()); !ok) {
    emit told(Severity::error, tr("Profile not saved. %1").arg(widgets::coreText(ok.error().message)));
    return;
  }
  model_.markSaved();
  emit told(Severity::information, tr("Profile saved to %1.").arg(QDir::toNativeSeparators(profile_path_)));
}

}  // namespace fyd::console
