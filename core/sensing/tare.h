// Takes the present readings as "not touched": mean distance of each sensor and mean force over N readings.
// Pure: the caller feeds each step's readings and stores the result in the profile when it is done.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/api.h"
#include "core/base/timed.h"
#include "core/sensing/readings.h"

namespace fyd::sensing {

enum class TareState : std::uint8_t {
  idle,
  running,
  done,            ///< the result holds
  touched,         ///< failed: a finger came
  invalid_sensor,  ///< failed: a distance or the force is outside its span
  unsteady,        ///< failed: readings spread more than the sensors' noise explains
  too_slow,        ///< failed: too few readings came in time
};

[[nodiscard]] FYD_API std::string_view toString(TareState state);

struct TareResult {
  std::uint32_t sensors = 0;
  std::array<double, kMaximumIrSensors> offset_mm{};
  std::array<double, kMaximumIrSensors> spread_mm{};  ///< standard deviation of one reading
  double force_N = 0.0;                               ///< mean force before taring, to hand to LoadCell::tare
  double force_spread_N = 0.0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(within(sensors, kMaximumIrSensors), offset_mm, spread_mm, force_N, force_spread_N);
  }
};

struct IndentationEstimate;

class FYD_API Tare {
 public:
  /// @param samples readings of the distance sensors to average, 1…10 000; as many seconds are allowed as 20 Hz needs
  void start(Instant now, std::uint32_t samples = 60);
  void cancel() { state_ = TareState::idle; }

  /// @param estimate this step's, for distances, validity and touch
  /// @param force_N this step's force, NaN when invalid or stale; a new one has a new count
  TareState step(Instant now, const IndentationEstimate& estimate, const Timed<double>& force_N);

  [[nodiscard]] TareState state() const { return state_; }
  /// Meaningful once done.
  [[nodiscard]] const TareResult& result() const { return result_; }

  static constexpr double kLargestSpread_mm = 8.0;  ///< four times the noise of 25 mV at 100 mm
  static constexpr double kLargestSpread_N = 0.2;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(within(state_, TareState::too_slow), deadline_, wanted_, within(sensors_, kMaximumIrSensors), last_ir_,
            last_force_, distances_, force_, result_);
  }

 private:
  struct Sum {
    double mean = 0.0;
    double squares = 0.0;  // of deviations (Welford)
    std::uint32_t count = 0;
    void add(double value);
    [[nodiscard]] double spread() const;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(mean, squares, count);
    }
  };

  void finish();

  TareState state_ = TareState::idle;
  Instant deadline_{};
  std::uint32_t wanted_ = 0;
  std::uint32_t sensors_ = 0;
  std::uint64_t last_ir_ = 0;
  std::uint64_t last_force_ = 0;
  std::array<Sum, kMaximumIrSensors> distances_{};
  Sum force_{};
  TareResult result_;
};

}  // namespace fyd::sensing
