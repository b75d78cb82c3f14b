#include "core/teleop/deadband.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

constexpr std::uint32_t kMostAhead = 100'000;  // changes: more have not been missed in any silence

}  // namespace

double DeadbandChannel::band(double sent) const { return std::max(floor, fraction * std::abs(sent)); }

std::optional<DeadbandPacket> DeadbandSender::step(double time_s, const DeadbandValues& values) {
  if (!std::isfinite(time_s)) return std::nullopt;
  DeadbandValues now = changes_[newest_ % changes_.size()].value;
  bool changed = newest_ == 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    changed = changed || !(std::abs(values[i] - now[i]) <= channels_[i].band(now[i]));
    now[i] = values[i];
  }
  if (changed) {
    ++newest_;
    changes_[newest_ % changes_.size()] = {.number = newest_, .date_s = time_s, .value = now};
    repeat_s_ = kFirstRepeat_s;
  } else if (time_s - sent_s_ < repeat_s_) {
    return std::nullopt;
  } else {
    repeat_s_ = std::min(2.0 * repeat_s_, refresh_s_);
  }
  sent_s_ = time_s;
  DeadbandPacket packet{.date_s = time_s, .changes = {}};
  const std::uint32_t count = std::min<std::uint32_t>(newest_, DeadbandPacket::kHistory);
  for (std::uint32_t n = newest_ - count + 1; n <= newest_; ++n)
    static_cast<void>(packet.changes.push(changes_[n % changes_.size()]));
  return packet;
}

void DeadbandReceiver::receive(const DeadbandPacket& packet) {
  if (!std::isfinite(packet.date_s)) return;
  std::uint32_t last = 0;
  for (const DeadbandChange& each : packet.changes) {
    const bool sound = each.number > last && std::isfinite(each.date_s) && each.date_s <= packet.date_s &&
                       std::ranges::all_of(each.value, [](double x) { return std::isfinite(x); });
    if (!sound) return;
    last = each.number;
  }
  if (newest_ > 0 && last > newest_ && last - newest_ > kMostAhead) return;
  for (const DeadbandChange& each : packet.changes) {
    if (newest_ >= kKept && each.number <= newest_ - kKept) continue;  // its place is taken
    changes_[each.number % kKept] = each;
    if (each.number <= newest_) continue;
    newest_ = each.number;
    unchanged_until_s_ = each.date_s;
  }
  if (last == newest_) unchanged_until_s_ = std::max(unchanged_until_s_, packet.date_s);
}

DeadbandReceiver::Answer DeadbandReceiver::at(double time_s) const {
  if (newest_ == 0 || !std::isfinite(time_s)) return {};
  bool whole = time_s <= unchanged_until_s_;
  const std::uint32_t oldest = newest_ >= kKept ? newest_ - kKept + 1 : 1;
  for (std::uint32_t n = newest_; n >= oldest; --n) {
    const DeadbandChange& each = kept(n);
    if (each.number != n) {
      whole = false;  // lost: what lies before it does not hold until the change after it
      continue;
    }
    if (each.date_s <= time_s) return {.value = each.value, .known = whole};
    whole = true;  // between two neighbours all is known
  }
  return {};
}

}  // namespace fyd::teleop
