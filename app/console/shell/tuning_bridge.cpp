#include "app/console/shell/tuning_bridge.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/console/shell/views.h"
#include "core/calibration/calibration_part.h"
#include "core/station/profile/calibrated_values.h"
#include "widgets/basics/core_text.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::console {

using widgets::Severity;

TuningBridge::TuningBridge(Session& session, QString profile_path, QObject* parent)
    : QObject(parent),
      session_(session),
      profile_path_(std::move(profile_path)),
      claim_(profile_path_),
      presets_(session_, model_, station::presetFolder(profile_path_.toStdString())) {
  station::Profile current = session_.currentProfile();
  station::Profile standard;
  const auto bound = bindParameters(current);
  model_.load(bound, bindParameters(standard));
  for (const Parameter& parameter : bound) names_.push_back(QString::fromStdString(std::string(parameter.id)));
  connect(&model_, &widgets::TuningModel::asked, this, &TuningBridge::apply);
  model_.setDoubt([this](std::span<const widgets::Setting> next) {
    return judge_.doubt(session_.currentProfile().step.control, next);
  });
  connect(&presets_, &TuningPresets::told, this, &TuningBridge::told);
  constexpr int kLook_ms = 500;
  silence_.setInterval(kLook_ms);
  connect(&silence_, &QTimer::timeout, this, &TuningBridge::lookForSilence);
}

void TuningBridge::apply(const QString& id, double value) {
  const std::string name = id.toStdString();
  if (const auto ok = session_.setParameter(name, value); !ok) {
    const QString why = widgets::coreText(ok.error().message);
    emit refused(why, id);
    model_.refuse(name, why);
    return;
  }
  UnderWay& own = under_way_[id];
  own.values.push_back(value);
  own.since.start();
  model_.setDelivery(name, widgets::Delivery::pending);
  silence_.start();
}

bool TuningBridge::settle(const QString& id, double value) {
  const auto own = under_way_.find(id);
  if (own == under_way_.end()) return false;
  const auto answered = std::ranges::find(own->values, value);
  if (answered == own->values.end()) return false;
  own->values.erase(own->values.begin(), answered + 1);
  return true;
}

void TuningBridge::hear(const pipeline::Event& event) {
  if (!event.namesParameter() || event.index >= names_.size()) return;
  const QString& id = names_[event.index];
  const std::string name = id.toStdString();
  const bool own = settle(id, event.value);
  // While changes made here are pending, an answer concerns an older one: the slider must not jump back.
  const bool more = under_way_.contains(id) && !under_way_[id].values.empty();
  if (!more) under_way_.remove(id);
  if (event.kind == pipeline::EventKind::parameter_refused) {
    if (own && !more) model_.refuse(name, tr("The step refused %1: it cannot be used now.").arg(event.value));
  } else if (more) {
    return;
  } else if (own) {
    model_.confirm(name, event.value);
  } else if (name == station::kInputDelay) {  // the network's need has raised it: it is not to be saved
    model_.hold(name, event.value);
  } else {
    model_.accept(name, event.value);
  }
}

void TuningBridge::lookForSilence() {
  for (auto each = under_way_.begin(); each != under_way_.end();) {
    if (each->since.elapsed() < kAnswer_ms) {
      ++each;
      continue;
    }
    model_.setDelivery(each.key().toStdString(), widgets::Delivery::silent);
    each = under_way_.erase(each);
  }
  if (under_way_.isEmpty()) silence_.stop();
}

void TuningBridge::restart(std::string_view former) {
  under_way_.clear();
  model_.returnToCurrent();  // the new session gets the current values, not the saved ones
  station::Profile current = session_.currentProfile();
  const bool other_touchpad = current.calibrated_on != former;
  for (const Parameter& parameter : bindParameters(current)) {
    if (!parameter.isNumber()) continue;
    model_.accept(parameter.id, parameter.value());
    if (!other_touchpad || calibration::calibratedBy(parameter.id).empty()) continue;
    model_.markSaved(parameter.id);
    model_.forgetChanges(parameter.id);
  }
}

QString TuningBridge::unsaved() const {
  constexpr int kNamed = 4;  // so that the rest of the question stays in sight
  QStringList names;
  for (const widgets::TunedParameter& each : model_.parameters()) {
    if (each.changed()) names << widgets::tunedName(each.info);
  }
  if (names.isEmpty()) return {};
  const QString named = names.mid(0, kNamed).join(QStringLiteral(", "));
  if (names.size() <= kNamed) return tr("changed and not saved: %1").arg(named);
  return tr("changed and not saved: %1 and %2 more").arg(named).arg(names.size() - kNamed);
}

void TuningBridge::startWithTarget(bool by_hand) {
  by_hand_ = by_hand;
  emit targetShown(by_hand);
}

void TuningBridge::targetByHand() {
  by_hand_ = true;
  const widgets::TunedParameter* target = std::as_const(model_).find(kHandTarget);
  const double value = target != nullptr ? model_.felt(*target) : 0.0;
  ask({.action = pipeline::OperatorAction::target_by_hand, .value = value});
}

void TuningBridge::targetFromRobot() {
  by_hand_ = false;
  ask({.action = pipeline::OperatorAction::target_from_robot});
}

void TuningBridge::ask(const pipeline::OperatorCommand& command) {
  if (session_.command(command)) return;
  emit told(Severity::error, session_.isOpen()
                                 ? tr("The station did not take the target: too many commands at once. Try again.")
                                 : closedText(connecting_));
}

void TuningBridge::save() {
  model_.feelSaved(false);
  if (model_.feelingSaved()) return;
  QDir().mkpath(QFileInfo(profile_path_).absolutePath());
  if (const QString why = claim_.whyNot(); !why.isEmpty()) {
    emit told(Severity::error, tr("Profile not saved. %1").arg(why + QLatin1Char('.')));
    return;
  }
  if (const auto ok = station::saveProfileFor(session_.currentProfile(), profile_path_.toStdString()); !ok) {
    emit told(Severity::error, tr("Profile not saved. %1").arg(widgets::coreText(ok.error().message)));
    return;
  }
  claim_.written();
  model_.markSaved();
  emit told(Severity::information, tr("Profile saved to %1.").arg(QDir::toNativeSeparators(profile_path_)));
}

}  // namespace fyd::console
