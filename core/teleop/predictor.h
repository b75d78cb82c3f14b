// Where the hand is now, from messages that say where it was.
//
// A message carries a position and the date at which the hand was there; it arrives late, irregularly, perhaps twice,
// overtaken by others, or not at all. A predictor is told each message as it arrives and asked, at each tick of the
// receiver, for the position at that tick. It allocates nothing after it was made, reads no clock, and gives the same
// bits for the same calls on every processor. Tele-gesture paper: order 0, order 1 and their mean ("hybrid").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/base/error.h"

namespace fyd::teleop {

inline constexpr std::size_t kMostAxes = 3;

/// One to three coordinates in mm; those beyond the predictor's axes stay 0.
using Position = std::array<double, kMostAxes>;

enum class PredictorChoice : std::uint8_t { order0, order1, hybrid, kalman, ar, experts };
/// "default" stands for the experts.
inline constexpr std::array<std::string_view, 6> kPredictorNames = {"order0", "order1", "hybrid",
                                                                    "kalman", "ar",     "default"};

class Predictor {
 public:
  virtual ~Predictor() = default;

  /// A message has arrived.
  /// @param date_s when the hand was there, on the clock of `predict`'s time; older than the newest: it was overtaken
  /// What is not finite, or further away than any hand, and a date that is known already, is passed over. A date more
  /// than kSilence_s ahead of the newest one begins a new motion.
  virtual void message(double date_s, const Position& position_mm) = 0;

  /// @return the position at `time_s`, always finite; all zeros before the first message
  [[nodiscard]] virtual Position predict(double time_s) = 0;

  /// How fast the prediction moves at `time_s`, with the messages as they are: without the jumps that new ones make.
  /// @return mm/s, always finite
  [[nodiscard]] virtual Position velocity(double time_s) const = 0;

  /// The hand was lifted: the motion ends, and the next message begins another. What was learnt of the hand stays.
  virtual void endMotion() = 0;

 protected:
  Predictor() = default;
  Predictor(const Predictor&) = default;
  Predictor& operator=(const Predictor&) = default;
};

/// A longer silence of the dates ends a motion.
inline constexpr double kSilence_s = 2.0;

class StrokeWeights;

struct PredictorSetup {
  std::size_t axes = 1;                                    ///< 1 … kMostAxes
  double period_s = 0.0;                                   ///< of the sender's messages; 0: not known
  std::shared_ptr<const StrokeWeights> weights = nullptr;  ///< of the default's perceptron; null: the resources' own
};
[[nodiscard]] std::unique_ptr<Predictor> makePredictor(PredictorChoice choice, PredictorSetup setup);
/// By its name on the command line. @return an error with the names when there is none of that name
[[nodiscard]] Result<PredictorChoice> predictorNamed(std::string_view name);

}  // namespace fyd::teleop
