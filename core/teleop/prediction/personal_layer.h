// Correction of the perceptron's forecast for this hand: a last layer that is learnt while the hand moves.
//
// Its inputs are the activations of the perceptron's second hidden layer (64). Its outputs are the differences of the
// displacements over the horizons in use from the perceptron's, in the frame and scale of the motion. Recursive least
// squares with a weight of 1 / (0.1 + |difference over the longest horizon|), which limits the influence of outliers
// and approximates least mean distance instead of least mean square. P is initialised with 1/200 on its diagonal, so
// that the outputs stay small for some hundred messages.
#pragma once

#include <array>
#include <cstddef>

#include "core/teleop/prediction/horizons.h"

namespace fyd::teleop {

class PersonalLayer {
 public:
  static constexpr std::size_t kInputs = 64;
  using Inputs = std::array<float, kInputs>;
  using PlaneVector = std::array<float, 2>;
  using Differences = std::array<PlaneVector, Horizons::kNodes>;

  PersonalLayer() { begin(); }
  void begin();
  /// A new node starts with the weights of the nearest old one.
  void setNodes(const Horizons::Steps& before, const Horizons::Steps& steps);
  /// One RLS step: the differences that followed these inputs, over each node's horizon. Non-finite ones are ignored.
  void learn(const Inputs& inputs, const Differences& differences);
  [[nodiscard]] Differences operator()(const Inputs& inputs) const;

 private:
  void beginCovariance();

  std::array<float, kInputs * kInputs> covariance_{};  ///< P
  std::array<Differences, kInputs> weights_{};
};

}  // namespace fyd::teleop
