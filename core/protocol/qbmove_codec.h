// Serial protocol of the original motor board (qbrobotics qbmove), frame by frame. Pure, no allocation.
//
//   3A 3A | id | length | command | payload … | check      length counts command, payload and check;
//                                                          check is the XOR of command and payload
// 16-bit integers have the high byte first; id 0 is broadcast, 1 the board's default. 8N1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/batch.h"

namespace fyd::protocol {

namespace qbmove {
inline constexpr std::uint8_t kPing = 0;
inline constexpr std::uint8_t kActivate = 128;     ///< one byte: 3 on, 0 off
inline constexpr std::uint8_t kGetActivate = 129;  ///< answered with one byte, as above
inline constexpr std::uint8_t kSetInputs = 130;
inline constexpr std::uint8_t kGetMeasurements = 132;  ///< not 134, which newer firmware packs wrongly
inline constexpr std::uint8_t kGetCurrents = 133;
inline constexpr std::uint8_t kSetWatchdog = 143;  ///< one byte: time in units of 20 ms, 0 off
inline constexpr std::uint8_t kMotorsOn = 3;
inline constexpr std::uint8_t kMotorsOff = 0;
inline constexpr double kWatchdogUnit_ms = 20.0;
inline constexpr std::uint8_t kBroadcast = 0;
inline constexpr std::uint8_t kDefaultId = 1;
}  // namespace qbmove

inline constexpr std::size_t kQbmoveMaximumPayload = 64;
using QbmovePayload = Batch<std::uint8_t, kQbmoveMaximumPayload>;
using QbmoveBytes = Batch<std::uint8_t, kQbmoveMaximumPayload + 6>;

struct QbmoveFrame {
  std::uint8_t id = qbmove::kDefaultId;
  std::uint8_t command = 0;
  QbmovePayload payload;

  /// Appends the high byte first. @return false when the payload is full
  bool add(std::int16_t value);
  /// @return nothing when the payload ends before
  [[nodiscard]] std::optional<std::int16_t> at(std::size_t index) const;
};

[[nodiscard]] QbmoveFrame qbmoveFrame(std::uint8_t command, std::span<const std::int16_t> values = {});
[[nodiscard]] QbmoveFrame qbmoveByteFrame(std::uint8_t command, std::uint8_t value);
[[nodiscard]] QbmoveBytes encode(const QbmoveFrame& frame);

/// Finds frames in a stream of bytes; what is no frame is skipped and counted.
class QbmoveParser {
 public:
  /// @return a frame when this byte completed one
  [[nodiscard]] std::optional<QbmoveFrame> push(std::uint8_t byte);
  void reset() { held_.clear(); }
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

 private:
  void drop(std::size_t bytes);
  [[nodiscard]] std::optional<QbmoveFrame> parse();

  QbmoveBytes held_;
  std::uint64_t skipped_ = 0;
};

}  // namespace fyd::protocol
