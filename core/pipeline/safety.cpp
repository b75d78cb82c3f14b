#include "core/pipeline/safety.h"

#include <utility>

#include "core/base/message.h"

namespace fyd::pipeline {
namespace {

constexpr auto kFaults = std::to_array<FaultInfo>({
#define FAULT(name, number, need, of, help, what, remedy, missing) \
  {Fault::name, Need::need, Part::of, Help::help, what, remedy},
#include "core/pipeline/fault_list.h"
#undef FAULT
});
constexpr FaultInfo kNothingMissing{.what = sentence("nothing missing"), .remedy = ""};
constexpr FaultInfo kUnknown{.what = sentence("a reason that this program does not know"), .remedy = ""};

constexpr bool numbersDiffer() {
  std::array<bool, kFaultCount> taken{true};
  for (const FaultInfo& info : kFaults) {
    if (std::exchange(taken[static_cast<std::size_t>(info.fault)], true)) return false;
  }
  return true;
}
static_assert(numbersDiffer(), "fault_list.h: a number stands twice, or is 0");

constexpr std::array<std::string_view, kSafetyStateCount> kStateNames = {
    sentence("Disconnected"), sentence("Connected"), sentence("Ready"),
    sentence("Active"),       sentence("Held"),      sentence("Stopped")};

}  // namespace

std::string_view toString(SafetyState state) {
  const auto number = static_cast<std::size_t>(state);
  return number < kStateNames.size() ? kStateNames[number] : sentence("an unknown state");
}

std::span<const FaultInfo> faultsByUrgency() { return kFaults; }

const FaultInfo& infoOf(Fault fault) {
  if (fault == Fault::none) return kNothingMissing;
  const auto* found = std::ranges::find(kFaults, fault, &FaultInfo::fault);
  return found == kFaults.end() ? kUnknown : *found;
}

void Safety::apply(SafetyEvent event, Fault why) {
  const SafetyState next = nextState(state_, event);
  if (next == SafetyState::held && state_ != SafetyState::held) held_because_ = why;
  if (next != SafetyState::held) held_because_ = Fault::none;
  state_ = next;
}

}  // namespace fyd::pipeline
