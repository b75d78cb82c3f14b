// How large a message may be on a line, and what of a touch fits [tele-gesture Eq. 1 and 2]:
//   largest message = flow · sampling period           (ISDN: 64 kbit/s · 10 ms = 640 bit)
//
// A touch of FYD Link always carries position, contact, sequence and times; orientation, then indentation, then force
// are left out until it fits. Counted are the sealed message and the 28 bytes of IPv4 and UDP around it, because the
// line carries both; what a link layer adds is not.
#pragma once

#include "core/base/error.h"
#include "core/protocol/link/link_messages.h"

namespace fyd::protocol {

struct MessageBudget {
  std::uint32_t points_per_axis = 0;  ///< of the longest axis
  unsigned bits_per_axis = 0;
  double max_message_bits = 0.0;  ///< flow · period
  unsigned message_bits = 0;      ///< one sealed touch
  unsigned datagram_bits = 0;     ///< with IPv4 and UDP headers
  TouchFields fields;             ///< what is carried
  bool fits = false;              ///< false: even the smallest touch is too long for this flow and period
};

/// @param wanted fields to carry if they fit
[[nodiscard]] MessageBudget fitTouch(const PositionCode& code, double flow_bit_per_s, double period_s,
                                     const TouchFields& wanted);

/// The same from a workspace's size. @return an error naming the value and its range
[[nodiscard]] Result<MessageBudget> messageBudget(const Vec3& extent_mm, double precision_mm, double flow_bit_per_s,
                                                  double period_ms, const TouchFields& wanted);

}  // namespace fyd::protocol
