// Linear prediction (autoregressive) that learns while the hand moves: recursive least squares on the hand's own past.
//
// With the newest message at t, step Δ and d_k = x(t − kΔ) − x(t − (k+1)Δ), k = 0 … order − 1:
//
//   x(t + h) − x(t) ≈ Σ_k w_h,k d_k
//
// for each horizon h = jΔ of interest ("node") with its own weights; they share the inverse covariance P of the
// features, because the features are the same. A date is used for learning once the displacement over the longest
// horizon is known. Features and targets are divided by the running RMS of d_0, so that learning does not depend on the
// size of the motion. The RMS is that at the time of learning, because it is not yet known when a motion begins. The
// last of all kMostOrder features is the distance from the centre of the motion instead of a lag, because an
// oscillating motion returns there.
// Prior: P is initialised as if smooth motion had been learnt already, w_h with a velocity that decays with a time
// constant of 60 ms, shorter for horizons beyond 100 ms.
#pragma once

#include <array>
#include <cstddef>

namespace fyd::teleop {

struct ForecastSettings {
  std::size_t order = 20;
  double forgetting = 0.999;           ///< per message, 0.99 … 1
  double prior_weight = 5.0;           ///< weight, in messages, of the smooth motion assumed at the beginning
  double prior_correlation_s = 0.030;  ///< correlation time of its velocity (Gaussian)
  double prior_noise = 0.03;           ///< uncorrelated share of its variance
  double prior_noise_per_lag = 0.05;   ///< increase of that share per lag, so that older lags count less until learnt
};

class LinearForecast {
 public:
  static constexpr std::size_t kMostOrder = 32;
  static constexpr std::size_t kNodes = 3;

  /// d_0 … in mm; the last of all kMostOrder is kCentreScale times the distance from the centre of the motion.
  using Features = std::array<double, kMostOrder>;
  static constexpr double kCentreScale = 0.03;

  LinearForecast() = default;
  /// @param step_s Δ
  void begin(const ForecastSettings& settings, double step_s);

  using Steps = std::array<int, kNodes>;  ///< horizons, in Δ; 0: none at this place
  /// Index of the node nearest to `step`, the first of equals; kNodes: there is none.
  [[nodiscard]] static std::size_t nearest(const Steps& steps, int step);

  /// Sets the horizons in use. A new one begins with the weights of the nearest, scaled, or with the initial ones.
  void setNodes(const Steps& steps);

  /// Updates the running RMS of d_0, for the learning that follows.
  void updatePower(double newest_d_mm);
  /// One RLS step for a past date: its features, and the displacements over each node's horizon after it.
  void learn(const Features& d_mm, const std::array<double, kNodes>& displacement_mm);

  /// @return the displacement over the node's horizon, mm
  [[nodiscard]] double forecast(std::size_t node, const Features& d_mm) const;

 private:
  void beginCovariance();

  ForecastSettings settings_;
  double step_s_ = 0.01;
  double power_mm2_ = 0.0;                                    ///< running mean of d_0²
  double power_count_ = 0.0;                                  ///< messages in power_mm2_, limited
  std::array<double, kMostOrder * kMostOrder> covariance_{};  ///< P, rows of `order`
  std::array<Features, kNodes> weights_{};
  Steps steps_{};
};

}  // namespace fyd::teleop
