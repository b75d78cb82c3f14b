// Which notice of the station goes by itself, and when: one about something that is missing when it is back, one about
// an interruption when the operator has armed again or stopped, one about a tare with the next.
#pragma once

#include <QString>
#include <set>
#include <vector>

#include "core/pipeline/outputs.h"
#include "core/station/readiness.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class NoticeCauses {
 public:
  /// Withdraws what the event makes out of date. @return the cause of the event's own notice; empty: it stays until read
  [[nodiscard]] QString begin(const pipeline::Event& event, widgets::NoticeStack& notices);
  /// Withdraws the notices whose causes are gone.
  void look(const std::vector<station::ReadinessLine>& readiness, pipeline::SafetyState state,
            widgets::NoticeStack& notices);

 private:
  std::set<pipeline::Fault> told_;  ///< with a notice that may still be shown
};

}  // namespace fyd::console
