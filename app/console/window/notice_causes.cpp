#include "app/console/window/notice_causes.h"

#include <algorithm>

namespace fyd::console {
namespace {

using pipeline::EventKind;
using pipeline::Fault;
using pipeline::SafetyState;

const QString kTare = QStringLiteral("tare");

QString causeOf(Fault fault) { return QStringLiteral("fault %1").arg(static_cast<int>(fault)); }

}  // namespace

QString NoticeCauses::begin(const pipeline::Event& event, widgets::NoticeStack& notices) {
  switch (event.kind) {
    case EventKind::tare_done:
    case EventKind::tare_failed: notices.withdraw(kTare); return kTare;
    case EventKind::state_changed:
    case EventKind::arm_refused:
      if (event.fault == Fault::none) return {};
      told_.insert(event.fault);
      return causeOf(event.fault);
    default: return {};
  }
}

void NoticeCauses::look(const std::vector<station::ReadinessLine>& readiness, SafetyState state,
                        widgets::NoticeStack& notices) {
  std::erase_if(told_, [&](Fault fault) {
    const bool interruption = pipeline::infoOf(fault).need == pipeline::Need::rendering;
    const bool lasts = interruption
                           ? state == SafetyState::held
                           : std::ranges::find(readiness, fault, &station::ReadinessLine::fault) != readiness.end();
    if (!lasts) notices.withdraw(causeOf(fault));
    return !lasts;
  });
}

}  // namespace fyd::console
