// Model of a sensor chain: dead time T, then a first-order low-pass with time constant τ.
// Stability: may change
#pragma once

#include <array>
#include <cstddef>

#include "core/base/api.h"
#include "core/base/state.h"

namespace fyd::control {

class FYD_API LagModel {
 public:
  /// May be called while running: the delay line keeps its content. Negative or not finite counts as 0.
  void configure(double delay_s, double lag_s);
  /// Steady state at `value`.
  void reset(double value);
  /// @param value not finite: the output holds
  /// @param dt_s not positive: the output holds
  double step(double value, double dt_s);
  [[nodiscard]] double value() const { return value_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(line_, within(next_, kCells - 1), since_s_, value_);
  }

 private:
  static constexpr std::size_t kCells = 64;  // resolution of the dead time
  std::array<double, kCells> line_{};
  std::size_t next_ = 0;
  double cell_s_ = 0.0;
  double since_s_ = 0.0;  // time since the last cell was filled
  double lag_s_ = 0.0;
  double value_ = 0.0;
};

}  // namespace fyd::control
