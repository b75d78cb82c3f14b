// The safety states and their single transition table. Part of the pure step, so a replay reproduces them.
//
//   Disconnected → Connected (sensors live, motors off) → Ready (inputs fresh) → Active (rendering)
//   → Held (something needed went missing; vibration zero, references frozen; latched)
//   Stopped (the operator's stop, from anywhere; motors off; latched)
//
// Leaving Held or Stopped takes an operator's arm; nothing re-engages by itself.
// Stability: stable since 0.1
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/api.h"
#include "core/base/state.h"

namespace fyd::pipeline {

/// Stored in files by number: numbers never change.
enum class SafetyState : std::uint8_t { disconnected = 0, connected = 1, ready = 2, active = 3, held = 4, stopped = 5 };
inline constexpr std::size_t kSafetyStateCount = 6;

enum class SafetyEvent : std::uint8_t {
  devices_gone,     ///< no sensor of the touchpad answers
  devices_live,     ///< the touchpad's sensors answer
  inputs_missing,   ///< something the present mode needs is stale, invalid or absent
  inputs_complete,  ///< everything the present mode needs is there
  fault,            ///< link lost, steps missed or a needed quantity unavailable: ends rendering
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

/// What is missing or went wrong; several may hold at once. Listed in fault_list.h with all their texts. Files
/// store the number.
enum class Fault : std::uint8_t {
  none = 0,
#define FAULT(name, number, ...) name = number,
#include "core/pipeline/fault_list.h"
#undef FAULT
};
/// One more than the largest number of a Fault.
inline constexpr std::size_t kFaultCount = 1 + std::max({
#define FAULT(name, number, ...) std::size_t{number},
#include "core/pipeline/fault_list.h"
#undef FAULT
                                               });

/// When something is needed.
enum class Need : std::uint8_t {
  always,
  robot,      ///< while the target comes from the robot
  rendering,  ///< its fault ends rendering but does not prevent arming
};
/// The lines of the readiness list.
enum class Part : std::uint8_t { none, motors, distances, load_cell, camera, robot, target };
/// The window's page that helps to remove a fault.
enum class Help : std::uint8_t { none, devices, signal, link, target };

struct FaultInfo {
  Fault fault = Fault::none;
  Need need = Need::always;
  Part part = Part::none;
  Help help = Help::none;
  std::string_view what;    ///< what is wrong, as a phrase: "the robot is silent"
  std::string_view remedy;  ///< what the operator does about it: "Check the network and the robot's program."
};
/// For a number that this program does not know: a text that says so.
[[nodiscard]] FYD_API const FaultInfo& infoOf(Fault fault);
/// All of them but none, the most urgent first: of several, the first is shown.
[[nodiscard]] FYD_API std::span<const FaultInfo> faultsByUrgency();

[[nodiscard]] FYD_API std::string_view toString(SafetyState state);
[[nodiscard]] inline std::string_view toString(Fault fault) { return infoOf(fault).what; }
[[nodiscard]] inline std::string_view remedy(Fault fault) { return infoOf(fault).remedy; }

/// Keeps the state; every change goes through the table.
class FYD_API Safety {
 public:
  /// Applies `event` and remembers `why` when it leads into Held.
  void apply(SafetyEvent event, Fault why = Fault::none);
  [[nodiscard]] SafetyState state() const { return state_; }
  /// Why the state is Held; none otherwise.
  [[nodiscard]] Fault heldBecause() const { return held_because_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(within(state_, kSafetyStateCount - 1), within(held_because_, kFaultCount - 1));
  }

 private:
  SafetyState state_ = SafetyState::disconnected;
  Fault held_because_ = Fault::none;
};

}  // namespace fyd::pipeline
