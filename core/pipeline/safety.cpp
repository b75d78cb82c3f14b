#include "core/pipeline/safety.h"

#include <utility>

#include "core/base/message.h"

namespace fyd::pipeline {
namespace {

constexpr auto kLacks = std::to_array<LackInfo>({
#define LACK(name, number, need, of, help, what, remedy, missing) \
  {Lack::name, Need::need, Part::of, Help::help, what, remedy},
#include "core/pipeline/lack_list.h"
#undef LACK
});
constexpr LackInfo kNothingMissing{.what = sentence("nothing missing"), .remedy = ""};
constexpr LackInfo kUnknown{.what = sentence("a reason that this program does not know"), .remedy = ""};

constexpr bool numbersDiffer() {
  std::array<bool, kLackCount> taken{true};
  for (const LackInfo& info : kLacks) {
    if (std::exchange(taken[static_cast<std::size_t>(info.lack)], true)) return false;
  }
  return true;
}
static_assert(numbersDiffer(), "lack_list.h: a number stands twice, or is 0");

constexpr std::array<std::string_view, kSafetyStateCount> kStateNames = {
    sentence("Disconnected"), sentence("Connected"), sentence("Ready"),
    sentence("Active"),       sentence("Held"),      sentence("Stopped")};

}  // namespace

std::string_view toString(SafetyState state) {
  const auto number = static_cast<std::size_t>(state);
  return number < kStateNames.size() ? kStateNames[number] : sentence("an unknown state");
}

std::span<const LackInfo> lacksByUrgency() { return kLacks; }

const LackInfo& infoOf(Lack lack) {
  if (lack == Lack::none) return kNothingMissing;
  const auto* found = std::ranges::find(kLacks, lack, &LackInfo::lack);
  return found == kLacks.end() ? kUnknown : *found;
}

void Safety::apply(SafetyEvent event, Lack why) {
  const SafetyState next = nextState(state_, event);
  if (next == SafetyState::held && state_ != SafetyState::held) held_because_ = why;
  if (next != SafetyState::held) held_because_ = Lack::none;
  state_ = next;
}

}  // namespace fyd::pipeline
