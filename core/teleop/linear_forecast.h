// One linear forecast that learns while the hand moves: recursive least squares on the hand's own past.
//
// With the newest message at t, step Δ and d_k = x(t − kΔ) − x(t − (k+1)Δ), k = 0 … order − 1:
//
//   x(t + h) − x(t) ≈ Σ_k w_h,k d_k
//
// for each horizon h = jΔ of interest ("node") with its own weights; they share the inverse covariance P of the
// features, because they see the same ones. A date is learnt from once the longest horizon after it is known. Features
// and targets are divided by the running RMS of d_0, so that a large and a small hand learn alike; the RMS is that of
// the time of learning, for a hand that begins to move is not yet known by its first hundredth of a millimetre. The
// last feature is the distance from the centre of the motion instead of a lag: what goes back and forth returns there.
// P begins as if smooth motion had been seen already, w_h with a velocity that decays in 60 ms, sooner beyond 100 ms.
#pragma once

#include <array>
#include <cstddef>

namespace fyd::teleop {

struct ForecastSettings {
  std::size_t order = 20;
  double forgetting = 0.999;   ///< per message, 0.99 … 1
  double trust = 5.0;          ///< how many messages the smooth motion imagined at the beginning is worth
  double smooth_s = 0.030;     ///< over which its velocity is alike
  double noise = 0.03;         ///< share of its variance that is not alike at all
  double far_lag_cost = 0.05;  ///< more of that per lag: what lies further back counts less until it has proven itself
};

class LinearForecast {
 public:
  static constexpr std::size_t kMostOrder = 32;
  static constexpr std::size_t kNodes = 3;

  /// d_0 … in mm; the last of all kMostOrder is the share kCentre of the distance from the centre of the motion.
  using Features = std::array<double, kMostOrder>;
  static constexpr double kCentre = 0.03;

  LinearForecast() = default;
  /// @param step_s Δ
  void begin(const ForecastSettings& settings, double step_s);

  using Steps = std::array<int, kNodes>;  ///< horizons, in Δ; 0: none at this place
  /// The place of the one nearest to `step` among those that there are, the first of equals; kNodes: there is none.
  [[nodiscard]] static std::size_t nearest(const Steps& steps, int step);

  /// Which horizons are of interest. A new one begins with the weights of the nearest, stretched, or with the initial
  /// ones.
  void setNodes(const Steps& steps);

  /// The running RMS of the newest motion, for the learning that follows.
  void watch(double newest_d_mm);
  /// The displacements that followed a date with these features are known now, over each node's horizon.
  void learn(const Features& d_mm, const std::array<double, kNodes>& displacement_mm);

  /// @return the displacement over the node's horizon, mm
  [[nodiscard]] double forecast(std::size_t node, const Features& d_mm) const;

 private:
  void beginCovariance();

  ForecastSettings settings_;
  double step_s_ = 0.01;
  double power_ = 0.0;  ///< running mean of d_0²
  double weight_ = 0.0;
  std::array<double, kMostOrder * kMostOrder> covariance_{};  ///< P, rows of `order`
  std::array<Features, kNodes> weights_{};
  Steps steps_{};
};

}  // namespace fyd::teleop
