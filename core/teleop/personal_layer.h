// What this hand does otherwise than other people's strokes: a last layer that is learnt while it moves.
//
// Its inputs are the perceptron's 64 units of the second layer; it says by how much the displacement over each horizon
// in use differs from the perceptron's, in the frame and scale of the motion. Recursive least squares with a weight of
// 1 / (0.1 + |error over the longest horizon|), so that it is the mean distance that gets smaller, not that of a few
// surprises. P begins at 1/200: it takes some hundred messages until it says much.
#pragma once

#include <array>
#include <cstddef>

#include "core/teleop/horizons.h"

namespace fyd::teleop {

class PersonalLayer {
 public:
  static constexpr std::size_t kInputs = 64;
  using Inputs = std::array<float, kInputs>;
  using InPlane = std::array<float, 2>;
  using Differences = std::array<InPlane, Horizons::kNodes>;

  PersonalLayer() { begin(); }
  void begin();
  /// A node that is new begins with the differences of the nearest one before.
  void setNodes(const Horizons::Steps& before, const Horizons::Steps& steps);
  /// What a motion that gave these inputs did otherwise over each node's horizon. What is not finite is passed over.
  void learn(const Inputs& inputs, const Differences& differences);
  [[nodiscard]] Differences operator()(const Inputs& inputs) const;

 private:
  void beginCovariance();

  std::array<float, kInputs * kInputs> covariance_{};  ///< P
  std::array<Differences, kInputs> weights_{};
};

}  // namespace fyd::teleop
