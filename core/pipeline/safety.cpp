#include "core/pipeline/safety.h"

namespace fyd::pipeline {
namespace {

struct LackText {
  Lack lack;
  std::string_view what;
  std::string_view remedy;
};

// The most urgent first.
constexpr auto kLackTexts = std::to_array<LackText>({
    {Lack::step_gap, "the haptic loop stood still for more than 20 ms", "Close other programs on this machine."},
    {Lack::steps_missed, "more than 5 % of the haptic cycles of one second were missed",
     "Close other programs on this machine."},
    {Lack::motors_stale, "the motor board is silent", "Check the touchpad's power and its serial cable."},
    {Lack::ir_stale, "the distance sensors are silent", "Check the touchpad's power and cables."},
    {Lack::ir_invalid, "too few distance sensors read within their span",
     "Look for dirt or an object under the cloth; calibrate."},
    {Lack::bridge_stale, "the load cell is silent", "Check the load cell's bridge and its cable."},
    {Lack::bridge_invalid, "the load cell's value is outside its span",
     "Take the load off the cover; check the bridge's wiring."},
    {Lack::camera_stale, "the camera sends no pictures", "Check the camera's cable or choose another source."},
    {Lack::camera_blind, "the camera sees nothing: picture black, white, of one grey or empty",
     "Check light and lens cap."},
    {Lack::robot_waiting, "no robot has connected", "Start the robot's program, or set the target by hand."},
    {Lack::robot_lost, "the robot is silent", "Check the network and the robot's program."},
    {Lack::robot_closed, "the robot has said goodbye", "Start the robot's program again."},
    {Lack::robot_frozen, "the robot's stiffness is not a number", "Check the robot's force sensor and probe again."},
    {Lack::no_target, "no stiffness target", "Choose the robot's stiffness or set one by hand."},
    {Lack::operator_silent, "the window did not answer for half a second",
     "Wait until it answers; close other programs on this machine."},
});
constexpr LackText kNothingMissing{Lack::none, "nothing missing", ""};
constexpr LackText kUnknown{Lack::none, "a reason that this program does not know", ""};

constexpr auto kByUrgency = [] {
  std::array<Lack, kLackTexts.size()> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = kLackTexts[i].lack;
  return order;
}();

constexpr bool eachOnce() {
  std::array<int, kLackCount> seen{1};
  for (const LackText& text : kLackTexts) ++seen[static_cast<std::size_t>(text.lack)];
  for (const int times : seen) {
    if (times != 1) return false;
  }
  return true;
}
static_assert(eachOnce(), "each lack has one line here");

const LackText& textOf(Lack lack) {
  if (lack == Lack::none) return kNothingMissing;
  for (const LackText& text : kLackTexts) {
    if (text.lack == lack) return text;
  }
  return kUnknown;
}

constexpr std::array<std::string_view, kSafetyStateCount> kStateNames = {"Disconnected", "Connected", "Ready",
                                                                         "Active",       "Held",      "Stopped"};

}  // namespace

std::string_view toString(SafetyState state) {
  const auto number = static_cast<std::size_t>(state);
  return number < kStateNames.size() ? kStateNames[number] : "an unknown state";
}
std::string_view toString(Lack lack) { return textOf(lack).what; }
std::string_view remedy(Lack lack) { return textOf(lack).remedy; }
std::span<const Lack> lacksByUrgency() { return kByUrgency; }

void Safety::apply(SafetyEvent event, Lack why) {
  const SafetyState next = nextState(state_, event);
  if (next == SafetyState::held && state_ != SafetyState::held) held_because_ = why;
  if (next != SafetyState::held) held_because_ = Lack::none;
  state_ = next;
}

}  // namespace fyd::pipeline
