#include "core/protocol/qbmove_codec.h"

#include <algorithm>

namespace fyd::protocol {
namespace {

constexpr std::uint8_t kStart = 0x3A;
constexpr std::size_t kHead = 4;  // two start bytes, id, length

std::uint8_t check(std::span<const std::uint8_t> bytes) {
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : bytes) sum ^= byte;
  return sum;
}

}  // namespace

bool QbmoveFrame::add(std::int16_t value) {
  if (payload.size() + 2 > QbmovePayload::capacity()) return false;
  const auto bits = static_cast<std::uint16_t>(value);
  return payload.push(static_cast<std::uint8_t>(bits >> 8U)) && payload.push(static_cast<std::uint8_t>(bits & 0xFFU));
}

std::optional<std::int16_t> QbmoveFrame::at(std::size_t index) const {
  if (2 * index + 2 > payload.size()) return std::nullopt;
  return static_cast<std::int16_t>((payload[2 * index] << 8U) | payload[2 * index + 1]);
}

QbmoveFrame qbmoveFrame(std::uint8_t command, std::span<const std::int16_t> values) {
  QbmoveFrame frame{.command = command};
  for (const std::int16_t value : values) static_cast<void>(frame.add(value));
  return frame;
}

QbmoveFrame qbmoveByteFrame(std::uint8_t command, std::uint8_t value) {
  QbmoveFrame frame{.command = command};
  static_cast<void>(frame.payload.push(value));
  return frame;
}

QbmoveBytes encode(const QbmoveFrame& frame) {
  QbmoveBytes out;
  const auto push = [&](std::uint8_t byte) { static_cast<void>(out.push(byte)); };
  push(kStart);
  push(kStart);
  push(frame.id);
  push(static_cast<std::uint8_t>(frame.payload.size() + 2));
  push(frame.command);
  for (const std::uint8_t byte : frame.payload) push(byte);
  push(check(std::span<const std::uint8_t>(out.view()).subspan(kHead)));
  return out;
}

void QbmoveParser::drop(std::size_t bytes) {
  std::copy(held_.items.begin() + static_cast<std::ptrdiff_t>(bytes),
            held_.items.begin() + static_cast<std::ptrdiff_t>(held_.size()), held_.items.begin());
  held_.count -= static_cast<std::uint32_t>(bytes);
}

std::optional<QbmoveFrame> QbmoveParser::push(std::uint8_t byte) {
  static_cast<void>(held_.push(byte));  // never full: parse leaves at most one incomplete frame
  return parse();
}

std::optional<QbmoveFrame> QbmoveParser::parse() {
  const auto skip = [this] {
    drop(1);
    ++skipped_;
  };
  while (!held_.empty()) {
    if (held_[0] != kStart || (held_.size() > 1 && held_[1] != kStart)) {
      skip();
      continue;
    }
    if (held_.size() < kHead) return std::nullopt;
    const std::size_t length = held_[3];
    if (length < 2 || length > kQbmoveMaximumPayload + 2) {
      skip();
      continue;
    }
    if (held_.size() < kHead + length) return std::nullopt;
    const auto body = std::span<const std::uint8_t>(held_.view()).subspan(kHead, length);
    if (check(body.first(length - 1)) != body.back()) {
      skip();
      continue;
    }
    QbmoveFrame frame{.id = held_[2], .command = body.front()};
    for (const std::uint8_t byte : body.subspan(1, length - 2)) static_cast<void>(frame.payload.push(byte));
    drop(kHead + length);
    return frame;
  }
  return std::nullopt;
}

}  // namespace fyd::protocol
