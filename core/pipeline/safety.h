// The safety states and the one table that moves between them. Part of the pure step, so a replay shows it too.
//
//   Disconnected → Connected (sensors live, motors off) → Ready (inputs fresh) → Active (rendering)
//   → Held (something needed went missing; vibration zero, references frozen; latched)
//   Stopped (the operator's stop, from anywhere; motors off; latched)
//
// Leaving Held or Stopped takes an operator's arm; nothing re-engages by itself.
#pragma once

#include <algorithm>
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

/// What is missing or went wrong; several may hold at once. They stand in lack_list.h, with all that is said of them
/// anywhere. The number is what a file holds.
enum class Lack : std::uint8_t {
  none = 0,
#define LACK(name, number, ...) name = number,
#include "core/pipeline/lack_list.h"
#undef LACK
};
/// One more than the largest number of a Lack.
inline constexpr std::size_t kLackCount = 1 + std::max({
#define LACK(name, number, ...) std::size_t{number},
#include "core/pipeline/lack_list.h"
#undef LACK
                                              });

/// When something is needed.
enum class Need : std::uint8_t {
  always,
  robot,      ///< while the target comes from the robot
  rendering,  ///< its lack ends rendering, and keeps nobody from arming
};
/// The lines of the readiness list.
enum class Part : std::uint8_t { none, motors, distances, load_cell, camera, robot, target };
/// Where a window helps with what is missing.
enum class Help : std::uint8_t { none, devices, signal, link, target };

struct LackInfo {
  Lack lack = Lack::none;
  Need need = Need::always;
  Part part = Part::none;
  Help help = Help::none;
  std::string_view what;    ///< what is wrong, as a phrase: "the robot is silent"
  std::string_view remedy;  ///< what the operator does about it: "Check the robot's cable and program."
};
/// Of a number that this program does not know, words that say so.
[[nodiscard]] const LackInfo& infoOf(Lack lack);
/// All of them but none, the most urgent first: of several, the first is shown.
[[nodiscard]] std::span<const LackInfo> lacksByUrgency();

[[nodiscard]] std::string_view toString(SafetyState state);
[[nodiscard]] inline std::string_view toString(Lack lack) { return infoOf(lack).what; }
[[nodiscard]] inline std::string_view remedy(Lack lack) { return infoOf(lack).remedy; }

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
