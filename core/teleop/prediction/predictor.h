// Predicts a hand's present position from messages of its past positions.
//
// A message carries a position and the date at which the hand was there; it arrives late, irregularly, perhaps twice,
// out of order, or not at all. A predictor gets each message as it arrives and gives, at each tick of the
// receiver, the position at that tick. It allocates nothing after it was made, reads no clock, and gives the same
// bits for the same calls on every processor. Tele-gesture paper: order 0, order 1 and their mean ("hybrid").
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstddef>

namespace fyd::teleop {

inline constexpr std::size_t kMostAxes = 3;

/// One to three coordinates in mm; of those beyond the predictor's axes nothing is said.
using Position = std::array<double, kMostAxes>;

class Predictor {
 public:
  virtual ~Predictor() = default;

  /// A message has arrived.
  /// @param date_s when the hand was there, on the clock of `predict`'s time; older than the newest: out of order
  /// Ignored: positions that are not finite or too far away, and dates received before. A date more than kSilence_s
  /// after the newest one begins a new motion.
  virtual void message(double date_s, const Position& position_mm) = 0;

  /// @return the position at `time_s`, always finite; all zeros before the first message
  [[nodiscard]] virtual Position predict(double time_s) = 0;

  /// Time derivative of the prediction at `time_s` for the messages so far: its jumps at new messages are left out.
  /// @return mm/s, always finite
  [[nodiscard]] virtual Position velocity(double time_s) const = 0;

  /// The motion ends (the hand was lifted); the next message begins another. Learnt parameters are kept.
  virtual void endMotion() = 0;

 protected:
  Predictor() = default;
  Predictor(const Predictor&) = default;
  Predictor& operator=(const Predictor&) = default;
};

/// A longer gap between dates ends a motion.
inline constexpr double kSilence_s = 2.0;

}  // namespace fyd::teleop
