// What a sensor chain shows of a quantity: dead time T, then a first-order low-pass with time constant τ.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/state.h"

namespace fyd::control {

class LagModel {
 public:
  /// Live: what is in the line stays in it. Negative or not finite counts as 0.
  void configure(double delay_s, double lag_s);
  /// As if `value` had stood for ever.
  void reset(double value);
  /// @param value NaN holds the last
  double step(double value, double dt_s);
  [[nodiscard]] double value() const { return value_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(line_, within(next_, kCells - 1), since_s_, value_);
  }

 private:
  static constexpr std::size_t kCells = 64;  // the dead time in this many pieces
  std::array<double, kCells> line_{};
  std::size_t next_ = 0;
  double cell_s_ = 0.0;
  double since_s_ = 0.0;  // time since the last cell was filled
  double lag_s_ = 0.0;
  double value_ = 0.0;
};

}  // namespace fyd::control
