#include "widgets/status/state_text.h"

#include "widgets/basics/core_text.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

using pipeline::Fault;
using pipeline::SafetyState;

QString sentenceOf(QString text) {
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
  return text;
}

/// What starts again after Held or Stopped. @param remedy of the reason that is shown; empty: none
QString howToRearm(Fault fault, const QString& reason, const QString& remedy, const std::optional<MissingNow>& now) {
  const QString then = QLatin1Char(' ') + tr("Then hold Re-arm.");
  const QString missing = now ? sentenceOf(now->why) : QString();
  if (!missing.isEmpty() && missing != reason) {
    return tr("Missing now: %1").arg(missing + QLatin1Char(' ') + now->remedy + then);
  }
  const bool lasts = fault != Fault::none && pipeline::infoOf(fault).need != pipeline::Need::rendering;
  if (now && missing.isEmpty() && lasts) return tr("Since then it is back. Hold Re-arm to start again.");
  return remedy.isEmpty() ? tr("Hold Re-arm to start again.") : remedy + then;
}

QString heldReason(const QString& reason, const QString& lateness) {
  const QString what = reason.isEmpty() ? tr("Something needed went missing.") : reason;
  return lateness.isEmpty() ? what : what + QLatin1Char(' ') + sentenceOf(lateness);
}

}  // namespace

QString asSentence(std::string_view phrase) { return sentenceOf(coreText(phrase)); }

StateWords describeState(SafetyState state, Fault fault, const std::optional<MissingNow>& now,
                         const QString& lateness) {
  QString reason = fault == Fault::none ? QString() : asSentence(toString(fault));
  QString remedy = fault == Fault::none || !lateness.isEmpty() ? QString() : coreText(pipeline::remedy(fault));
  // The readiness list knows the very cable, and who has the device.
  if (now && fault != Fault::none && now->fault == fault && !now->remedy.isEmpty()) {
    reason = sentenceOf(now->why);
    remedy = now->remedy;
  }
  const QString word = coreText(toString(state));
  switch (state) {
    case SafetyState::disconnected:
      return {word, reason.isEmpty() ? tr("No sensor of the touchpad answers.") : reason,
              remedy.isEmpty() ? tr("Check the touchpad's power and cables.") : remedy,
              QStringLiteral("state-disconnected")};
    case SafetyState::connected:
      return {word, reason.isEmpty() ? tr("Sensors live, motors off.") : reason, remedy,
              QStringLiteral("state-connected")};
    case SafetyState::ready:
      return {word, tr("Everything needed is there; motors off."), tr("Hold Arm to start."),
              QStringLiteral("state-ready")};
    case SafetyState::active:
      return {word, tr("Rendering; motors on."), tr("Esc stops."), QStringLiteral("state-active")};
    case SafetyState::held:
      return {word, heldReason(reason, lateness), howToRearm(fault, reason, remedy, now), QStringLiteral("state-held")};
    case SafetyState::stopped:
      return {word, tr("Stopped by the operator; motors off."), howToRearm(Fault::none, {}, {}, now),
              QStringLiteral("state-stopped")};
  }
  return {word, {}, {}, {}};
}

QColor stateColour(SafetyState state) {
  switch (state) {
    case SafetyState::disconnected: return theme().muted;
    case SafetyState::connected:
    case SafetyState::ready: return theme().text;
    case SafetyState::active: return theme().live;
    case SafetyState::held: return theme().warning;
    case SafetyState::stopped: return theme().danger;
  }
  return theme().muted;
}

QString armText(SafetyState state) {
  const bool again = state == SafetyState::held || state == SafetyState::stopped;
  return again ? tr("Hold to re-arm") : tr("Hold to arm");
}

}  // namespace fyd::widgets
