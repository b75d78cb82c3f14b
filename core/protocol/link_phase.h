// The phases of a session as one table, for the touchpad's side of every protocol.
//
//   waiting → running ⇄ paused,   goodbye → closed,   silence → lost (not while paused),   handshake → waiting
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/pipeline/messages.h"

namespace fyd::protocol {

enum class LinkEvent : std::uint8_t {
  handshake,  ///< a robot shook hands: a new session
  state,      ///< a state of the session's robot
  pause,      ///< negotiated
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

}  // namespace fyd::protocol
