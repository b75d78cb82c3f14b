// Predicts a hand's present position from messages of its past positions.
//
// A message carries a position and the date at which the hand was there; it arrives late, irregularly, perhaps twice,
// overtaken by others, or not at all. A predictor gets each message as it arrives and gives, at each tick of the
// receiver, the position at that tick. It allocates nothing after it was made, reads no clock, and gives the same
// bits for the same calls on every processor. Tele-gesture paper: order 0, order 1 and their mean ("hybrid").
#pragma once

#include <array>
#include <cstddef>

namespace fyd::teleop {

inline constexpr std::size_t kMostAxes = 3;

/// One to three coordinates in mm; those beyond the predictor's axes stay 0.
using Position = std::array<double, kMostAxes>;

class Predictor {
 public:
  virtual ~Predictor() = default;

  /// A message has arrived.
  /// @param date_s when the hand was there, on the clock of `predict`'s time; older than the newest: it was overtaken
  /// Ignored are positions that are not finite or too far away, and dates that are known already. A date more than
  /// kSilence_s ahead of the newest one begins a new motion.
  virtual void message(double date_s, const Position& position_mm) = 0;

  /// @return the position at `time_s`, always finite; all zeros before the first message
  [[nodiscard]] virtual Position predict(double time_s) = 0;

  /// Velocity of the prediction at `time_s`, from the messages so far: without the jumps at new ones.
  /// @return mm/s, always finite
  [[nodiscard]] virtual Position velocity(double time_s) const = 0;

  /// The hand was lifted: the motion ends, and the next message begins another. Learnt parameters stay.
  virtual void endMotion() = 0;

 protected:
  Predictor() = default;
  Predictor(const Predictor&) = default;
  Predictor& operator=(const Predictor&) = default;
};

/// A longer gap between dates ends a motion.
inline constexpr double kSilence_s = 2.0;

}  // namespace fyd::teleop
