#include "core/pipeline/safety.h"

namespace fyd::pipeline {
namespace {

struct LackText {
  std::string_view what;
  std::string_view remedy;
};

constexpr std::array<LackText, kLackCount> kLackTexts = {{
    {"nothing missing", ""},
    {"the haptic loop stood still for more than 20 ms", "Close other programs on this machine."},
    {"more than 5 % of the haptic cycles of one second were missed", "Close other programs on this machine."},
    {"the motor board is silent", "Check the touchpad's power and its serial cable."},
    {"the distance sensors are silent", "Check the touchpad's power and cables."},
    {"too few distance sensors read within their span", "Look for dirt or an object under the cloth; calibrate."},
    {"the load cell is silent", "Check the load cell's bridge and its cable."},
    {"the load cell's value is outside its span", "Take the load off the cover; check the bridge's wiring."},
    {"the camera sends no pictures", "Check the camera's cable or choose another source."},
    {"the camera sees nothing: picture black, white, of one grey or empty", "Check light and lens cap."},
    {"no robot has connected", "Start the robot's program, or set the target by hand."},
    {"the robot is silent", "Check the network and the robot's program."},
    {"the robot has said goodbye", "Start the robot's program again."},
    {"the robot's stiffness is not a number", "Check the robot's force sensor and probe again."},
    {"no stiffness target", "Choose the robot's stiffness or set one by hand."},
    {"the window did not answer for half a second", "Wait until it answers; close other programs on this machine."},
}};

constexpr std::array<std::string_view, kSafetyStateCount> kStateNames = {"Disconnected", "Connected", "Ready",
                                                                         "Active",       "Held",      "Stopped"};

}  // namespace

std::string_view toString(SafetyState state) { return kStateNames[static_cast<std::size_t>(state)]; }
std::string_view toString(Lack lack) { return kLackTexts[static_cast<std::size_t>(lack)].what; }
std::string_view remedy(Lack lack) { return kLackTexts[static_cast<std::size_t>(lack)].remedy; }

void Safety::apply(SafetyEvent event, Lack why) {
  const SafetyState next = nextState(state_, event);
  if (next == SafetyState::held && state_ != SafetyState::held) held_because_ = why;
  if (next != SafetyState::held) held_because_ = Lack::none;
  state_ = next;
}

}  // namespace fyd::pipeline
