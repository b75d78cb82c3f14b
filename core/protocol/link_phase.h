// The phases of the link as transition tables, one for each side.
//
// Touchpad (every protocol):
//   waiting → running ⇄ paused,   goodbye → closed,   silence → lost (not while paused),   handshake → waiting
// Robot:
//   handshake → running ⇄ paused,   silence → lost (not while paused),   longer silence or goodbye → handshake,
//   own goodbye → closing → closed
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/message.h"
#include "core/pipeline/messages.h"

namespace fyd::protocol {

enum class LinkEvent : std::uint8_t {
  handshake,  ///< a robot completed the handshake: a new link
  state,      ///< a state of the linked robot
  pause,      ///< by agreement of both ends
  resume,
  goodbye,
  silence,  ///< longer than allowed
};
inline constexpr std::size_t kLinkEventCount = 6;
inline constexpr std::size_t kLinkPhaseCount = 6;

/// The whole table: phase after `event` in `phase`.
[[nodiscard]] constexpr pipeline::LinkPhase nextPhase(pipeline::LinkPhase phase, LinkEvent event) {
  using enum pipeline::LinkPhase;
  constexpr std::array<std::array<pipeline::LinkPhase, kLinkEventCount>, kLinkPhaseCount> kTable = {{
      // handshake state  pause   resume   goodbye silence
      {none, none, none, none, none, none},                  // none
      {waiting, running, paused, running, closed, waiting},  // waiting
      {waiting, running, paused, running, closed, lost},     // running
      {waiting, paused, paused, running, closed, paused},    // paused
      {waiting, closed, closed, closed, closed, closed},     // closed
      {waiting, running, paused, running, closed, lost},     // lost
  }};
  return kTable[static_cast<std::size_t>(phase)][static_cast<std::size_t>(event)];
}

enum class RobotPhase : std::uint8_t {
  handshake,  ///< the touchpad has not answered yet (or went away)
  running,
  paused,   ///< by agreement of both ends; states and touches go on
  closing,  ///< the robot's own goodbye is still being sent
  closed,   ///< nothing more is sent
  lost,     ///< silence longer than allowed; the robot holds still
};
inline constexpr std::size_t kRobotPhaseCount = 6;
[[nodiscard]] constexpr std::string_view toString(RobotPhase phase) {
  constexpr std::array<std::string_view, kRobotPhaseCount> kNames = {sentence("handshake"), sentence("running"),
                                                                     sentence("paused"),    sentence("closing"),
                                                                     sentence("closed"),    sentence("lost")};
  return kNames[static_cast<std::size_t>(phase)];
}

enum class RobotEvent : std::uint8_t {
  answered,  ///< the handshake is complete
  heard,     ///< any valid datagram of the touchpad
  pause,     ///< by agreement of both ends
  resume,
  leave,    ///< the robot's operator ends the link
  said,     ///< the robot's own goodbye is sent
  goodbye,  ///< the touchpad's
  silence,  ///< longer than allowed
  give_up,  ///< so long that only a new handshake helps
};
inline constexpr std::size_t kRobotEventCount = 9;

[[nodiscard]] constexpr RobotPhase nextPhase(RobotPhase phase, RobotEvent event) {
  using enum RobotPhase;
  constexpr std::array<std::array<RobotPhase, kRobotEventCount>, kRobotPhaseCount> kTable = {{
      // answered  heard      pause      resume     leave    said       goodbye    silence    give_up
      {running, handshake, handshake, handshake, closed, handshake, handshake, handshake, handshake},  // handshake
      {running, running, paused, running, closing, running, handshake, lost, handshake},               // running
      {running, paused, paused, running, closing, paused, handshake, paused, handshake},               // paused
      {closing, closing, closing, closing, closing, closed, closed, closing, closed},                  // closing
      {closed, closed, closed, closed, closed, closed, closed, closed, closed},                        // closed
      {running, running, paused, running, closing, lost, handshake, lost, handshake},                  // lost
  }};
  return kTable[static_cast<std::size_t>(phase)][static_cast<std::size_t>(event)];
}

}  // namespace fyd::protocol
