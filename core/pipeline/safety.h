// The safety states and the one table that moves between them. Part of the pure step, so a replay shows it too.
//
//   Disconnected → Connected (sensors live, motors off) → Ready (inputs fresh) → Active (rendering)
//   → Held (something needed went missing; vibration zero, references frozen; latched)
//   Stopped (the operator's stop, from anywhere; motors off; latched)
//
// Leaving Held or Stopped takes an operator's arm; nothing re-engages by itself.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/state.h"

namespace fyd::pipeline {

/// The numbers are what a file holds: they stay.
enum class SafetyState : std::uint8_t { disconnected = 0, connected = 1, ready = 2, active = 3, held = 4, stopped = 5 };
inline constexpr std::size_t kSafetyStateCount = 6;

enum class SafetyEvent : std::uint8_t {
  devices_gone,     ///< no sensor of the touchpad answers
  devices_live,     ///< the touchpad's sensors answer
  inputs_missing,   ///< something the present mode needs is stale, invalid or absent
  inputs_complete,  ///< everything the present mode needs is there
  fault,            ///< link lost, steps missed, limit, or a needed quantity unavailable, while rendering
  arm,              ///< the operator's deliberate start or re-start
  stop,             ///< the operator's stop
};
inline constexpr std::size_t kSafetyEventCount = 7;

/// The whole table: state after `event` in `state`. `arm` is given only while the inputs are complete.
[[nodiscard]] constexpr SafetyState nextState(SafetyState state, SafetyEvent event) {
  using enum SafetyState;
  constexpr std::array<std::array<SafetyState, kSafetyEventCount>, kSafetyStateCount> kTable = {{
      // gone        live          missing       complete      fault         arm     stop
      {disconnected, connected, disconnected, disconnected, disconnected, disconnected, stopped},  // disconnected
      {disconnected, connected, connected, ready, connected, connected, stopped},                  // connected
      {disconnected, ready, connected, ready, connected, active, stopped},                         // ready
      {held, active, held, active, held, active, stopped},                                         // active
      {held, held, held, held, held, active, stopped},                                             // held
      {stopped, stopped, stopped, stopped, stopped, active, stopped},                              // stopped
  }};
  return kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(event)];
}

/// What is missing or went wrong; several may hold at once. The number is what a file holds: it stays, and a new one
/// takes the next, whatever its place in the order in which they are shown (safety.cpp).
enum class Lack : std::uint8_t {
  none = 0,
  step_gap = 1,          ///< more than 20 ms without a step
  steps_missed = 2,      ///< more than 5 % of the cycles of one second missed
  motors_stale = 3,      ///< the motor board is silent
  ir_stale = 4,          ///< the distance sensors are silent
  ir_invalid = 5,        ///< too few distance sensors within their span
  bridge_stale = 6,      ///< the load cell is silent
  bridge_invalid = 7,    ///< the load cell's value is outside its span
  camera_stale = 8,      ///< no new picture
  camera_blind = 9,      ///< pictures arrive, but black, white, of one grey or empty
  robot_waiting = 10,    ///< a robot is wanted and has not connected
  robot_lost = 11,       ///< the robot went silent
  robot_closed = 12,     ///< the robot said goodbye
  robot_frozen = 13,     ///< the robot's link stands but its stiffness is not a number
  no_target = 14,        ///< no stiffness target: neither robot nor operator gives one
  operator_silent = 15,  ///< the operator's window does not answer
};
inline constexpr std::size_t kLackCount = 16;
/// All of them but none, the most urgent first: of several, the first is shown.
[[nodiscard]] std::span<const Lack> lacksByUrgency();

[[nodiscard]] std::string_view toString(SafetyState state);
/// What is wrong, as a phrase: "robot silent"; of a number that this program does not know, that.
[[nodiscard]] std::string_view toString(Lack lack);
/// What the operator does about it: "Check the robot's cable and program."
[[nodiscard]] std::string_view remedy(Lack lack);

/// Keeps the state; every change goes through the table.
class Safety {
 public:
  /// Applies `event` and remembers `why` when it leads into Held.
  void apply(SafetyEvent event, Lack why = Lack::none);
  [[nodiscard]] SafetyState state() const { return state_; }
  /// Why the state is Held; none otherwise.
  [[nodiscard]] Lack heldBecause() const { return held_because_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(within(state_, kSafetyStateCount - 1), within(held_because_, kLackCount - 1));
  }

 private:
  SafetyState state_ = SafetyState::disconnected;
  Lack held_because_ = Lack::none;
};

}  // namespace fyd::pipeline
