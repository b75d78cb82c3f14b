// One linear forecast that learns while the hand moves: recursive least squares on the hand's own past.
//
// With the newest message at t, step Δ and d_k = x(t − kΔ) − x(t − (k+1)Δ), k = 0 … order − 1:
//
//   x(t + h) − x(t) ≈ Σ_k w_h,k d_k
//
// for each horizon h = jΔ of interest ("node") with its own weights; they share the inverse covariance P of the
// features, because the features are the same. A date is used for learning once the displacement over the longest
// horizon is known. Features and targets are divided by the running RMS of d_0, so that learning does not depend on the
// size of the motion. The RMS is that at the time of learning, because it is not yet known when a motion begins. The
// last feature is the distance from the centre of the motion instead of a lag, because an oscillating motion returns
// there. P is initialised as if smooth motion had been seen already, w_h with a velocity that decays in 60 ms, sooner
// beyond 100 ms.
#pragma once

#include <array>
#include <cstddef>

namespace fyd::teleop {

struct ForecastSettings {
  std::size_t order = 20;
  double forgetting = 0.999;   ///< per message, 0.99 … 1
  double trust = 5.0;          ///< weight, in messages, of the smooth motion that is assumed at the beginning
  double smooth_s = 0.030;     ///< correlation time of its velocity
  double noise = 0.03;         ///< uncorrelated share of its variance
  double far_lag_cost = 0.05;  ///< increase of that share per lag, so that older lags count less until learnt
};

class LinearForecast {
 public:
  static constexpr std::size_t kMostOrder = 32;
  static constexpr std::size_t kNodes = 3;

  /// d_0 … in mm; the last of all kMostOrder is kCentre times the distance from the centre of the motion.
  using Features = std::array<double, kMostOrder>;
  static constexpr double kCentre = 0.03;

  LinearForecast() = default;
  /// @param step_s Δ
  void begin(const ForecastSettings& settings, double step_s);

  using Steps = std::array<int, kNodes>;  ///< horizons, in Δ; 0: none at this place
  /// Index of the node nearest to `step`, the first of equals; kNodes: there is none.
  [[nodiscard]] static std::size_t nearest(const Steps& steps, int step);

  /// Sets the horizons in use. A new one begins with the weights of the nearest, scaled, or with the initial ones.
  void setNodes(const Steps& steps);

  /// Updates the running RMS of d_0, for the learning that follows.
  void watch(double newest_d_mm);
  /// Learns from a date with these features, once the displacements over each node's horizon after it are known.
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
