// Why a datagram of FYD Link was not taken; one list for codec, secure channel and session.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/message.h"

namespace fyd::protocol {

enum class LinkRefusal : std::uint8_t {
  none,          ///< it was taken
  magic,         ///< not a datagram of FYD Link
  version,       ///< of another version
  kind,          ///< a kind of datagram that is never sent to this end
  size,          ///< too short or too long for its kind
  key,           ///< its authentication fails: another key, forged, or damaged
  cookie,        ///< the call's cookie is too old or another address's
  repeated,      ///< already taken once: a replay or a duplicate of the network
  behind,        ///< so far behind the newest that whether it was taken is no longer known
  session,       ///< of a session that is not this one
  stale,         ///< sent longer ago than the freshness limit
  future,        ///< stamped later than now
  message,       ///< unknown type of message, or one this end does not take
  field,         ///< a field out of its range
  late,          ///< a newer one of its type was taken before
  peer,          ///< not from the session's address
  second_robot,  ///< a good call, while another robot is served
  phase,         ///< out of turn in this phase
};
inline constexpr std::size_t kLinkRefusalCount = 18;

using LinkRefusalCounters = std::array<std::uint64_t, kLinkRefusalCount>;

[[nodiscard]] constexpr std::string_view toString(LinkRefusal refusal) {
  constexpr std::array<std::string_view, kLinkRefusalCount> kNames = {
      sentence("taken"),           sentence("not FYD Link"),   sentence("other version"),
      sentence("unexpected kind"), sentence("wrong size"),     sentence("wrong key or damaged"),
      sentence("cookie"),          sentence("repeated"),       sentence("too far behind"),
      sentence("other session"),   sentence("stale"),          sentence("from the future"),
      sentence("message"),         sentence("field"),          sentence("late"),
      sentence("other address"),   sentence("a second robot"), sentence("out of turn")};
  return kNames[static_cast<std::size_t>(refusal)];
}

/// A message as it was read, or why it was not.
template <class T>
struct LinkDecoded {
  T value{};
  LinkRefusal refusal = LinkRefusal::none;
  [[nodiscard]] bool ok() const { return refusal == LinkRefusal::none; }
};

}  // namespace fyd::protocol
