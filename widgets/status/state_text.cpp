#include "widgets/status/state_text.h"

#include <QCoreApplication>

#include "widgets/basics/core_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

using pipeline::Fault;
using pipeline::SafetyState;

QString tr(const char* text) { return QCoreApplication::translate("StateText", text); }

}  // namespace

QString asSentence(std::string_view phrase) {
  QString text = coreText(phrase);
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
  return text;
}

StateWords describeState(SafetyState state, Fault fault) {
  const QString reason = fault == Fault::none ? QString() : asSentence(toString(fault));
  const QString remedy = fault == Fault::none ? QString() : coreText(pipeline::remedy(fault));
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
      return {
          word, reason.isEmpty() ? tr("Something needed went missing.") : reason,
          remedy.isEmpty() ? tr("Hold Re-arm to start again.") : remedy + QLatin1Char(' ') + tr("Then hold Re-arm."),
          QStringLiteral("state-held")};
    case SafetyState::stopped:
      return {word, tr("Stopped by the operator; motors off."), tr("Hold Re-arm to start again."),
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
