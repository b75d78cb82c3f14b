#include "core/protocol/link/message_budget.h"

#include <cmath>

#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/secure_channel.h"

namespace fyd::protocol {
namespace {

constexpr unsigned kIpv4AndUdpBits = 28 * 8;

unsigned sealedBits(const PositionCode& code, const TouchFields& fields) {
  return static_cast<unsigned>(8 * (touchMessageSize(code.bitsPerAxis(), fields) + kSealOverhead));
}

}  // namespace

MessageBudget fitTouch(const PositionCode& code, double flow_bit_per_s, double period_s, const TouchFields& wanted) {
  MessageBudget out{.points_per_axis = code.pointsOfLongestAxis(),
                    .bits_per_axis = code.bitsPerAxis(),
                    .max_message_bits = flow_bit_per_s * period_s,
                    .fields = wanted};
  const auto fits = [&] {
    out.message_bits = sealedBits(code, out.fields);
    out.datagram_bits = out.message_bits + kIpv4AndUdpBits;
    return out.datagram_bits <= out.max_message_bits;
  };
  out.fits = fits();
  for (bool* field : {&out.fields.orientation, &out.fields.indentation, &out.fields.force}) {
    if (out.fits) break;
    *field = false;
    out.fits = fits();
  }
  return out;
}

Result<MessageBudget> messageBudget(const Vec3& extent_mm, double precision_mm, double flow_bit_per_s, double period_ms,
                                    const TouchFields& wanted) {
  if (!(extent_mm.finite() && extent_mm.x > 0.0 && extent_mm.y > 0.0 && extent_mm.z > 0.0)) {
    return fail("workspace {} x {} x {} mm: every side must be longer than 0", extent_mm.x, extent_mm.y, extent_mm.z);
  }
  if (!(precision_mm > 0.0 && std::isfinite(precision_mm))) {
    return fail("precision {} mm: expected more than 0", precision_mm);
  }
  if (!(flow_bit_per_s > 0.0 && std::isfinite(flow_bit_per_s))) {
    return fail("flow {} bit/s: expected more than 0", flow_bit_per_s);
  }
  if (!(period_ms > 0.0 && std::isfinite(period_ms))) return fail("period {} ms: expected more than 0", period_ms);
  const auto code = PositionCode::make({.maximum_mm = extent_mm, .precision_mm = precision_mm});
  if (!code) {
    return fail("workspace {} x {} x {} mm at {} mm: more than {} points on an axis", extent_mm.x, extent_mm.y,
                extent_mm.z, precision_mm, 1U << kMaximumBitsPerAxis);
  }
  return fitTouch(*code, flow_bit_per_s, 1e-3 * period_ms, wanted);
}

}  // namespace fyd::protocol
