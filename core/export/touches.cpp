#include "core/export/touches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/median.h"
#include "core/export/export_selection.h"
#include "core/texture/felt/felt_level.h"

namespace fyd::exports {
namespace {

constexpr Duration kLongestBreak = std::chrono::milliseconds(100);
constexpr double kSettledBand = 0.05;

void takeLarger(double& peak, double value) {
  if (std::isfinite(value) && !(peak >= value)) peak = value;
}

/// A measured stiffness, in the touch's time.
struct Measured {
  double time_s = 0.0;
  double stiffness_N_per_mm = 0.0;
};

/// One touch while its rows go by. Memory: 16 bytes for each step of this touch.
class OpenTouch {
 public:
  explicit OpenTouch(double start_s) { touch_.start_s = touch_.end_s = start_s; }

  /// A row in contact.
  void add(const pipeline::TelemetrySample& row, double time_s) {
    touch_.end_s = std::max(touch_.end_s, time_s);
    takeLarger(touch_.peak_force_N, row.force_N);
    takeLarger(touch_.peak_indentation_mm, row.indentation_mm);
    if (std::isfinite(row.reachable_target_N_per_mm)) touch_.target_N_per_mm = row.reachable_target_N_per_mm;
    if (row.stiffness_observable && std::isfinite(row.stiffness_N_per_mm)) {
      measured_.push_back({time_s, row.stiffness_N_per_mm});
    }
    if (std::isfinite(row.vibration_duty_percent)) {
      duty_squares_ += row.vibration_duty_percent * row.vibration_duty_percent;
      ++duty_rows_;
    }
    felt_squares_ += row.felt_acceleration_g * row.felt_acceleration_g;
  }

  [[nodiscard]] Touch finish() {
    if (duty_rows_ > 0) touch_.vibration_rms_percent = std::sqrt(duty_squares_ / static_cast<double>(duty_rows_));
    const double felt_g = std::sqrt(felt_squares_ / static_cast<double>(duty_rows_));
    if (felt_g > 0.0) touch_.felt_level_dB = texture::feltLevel_dB(felt_g);
    const double band = kSettledBand * std::abs(touch_.target_N_per_mm);
    // Backward from the last while within the band: the settled part.
    auto settled = measured_.end();
    while (settled != measured_.begin() &&
           std::abs(std::prev(settled)->stiffness_N_per_mm - touch_.target_N_per_mm) <= band) {
      --settled;
    }
    if (settled != measured_.end()) {
      touch_.settling_s = settled->time_s - touch_.start_s;
    } else {  // never settled: the second half gives the stiffness
      const double half_s = (touch_.start_s + touch_.end_s) / 2.0;
      settled = std::ranges::find_if(measured_, [&](const Measured& m) { return m.time_s >= half_s; });
    }
    std::vector<double> values;
    for (auto m = settled; m != measured_.end(); ++m) values.push_back(m->stiffness_N_per_mm);
    touch_.stiffness_N_per_mm = median(std::move(values));
    return touch_;
  }

 private:
  Touch touch_;
  std::vector<Measured> measured_;
  double duty_squares_ = 0.0;
  double felt_squares_ = 0.0;
  std::uint64_t duty_rows_ = 0;
};

}  // namespace

Result<std::vector<Touch>> findTouches(const recording::Recording& recording, const recording::Progress& progress) {
  std::vector<Touch> touches;
  std::optional<OpenTouch> open;
  Instant last_contact{};
  const ExportSelection all{.end = recording.info().committed_samples, .progress = progress};
  const auto read = forEachBlock(recording, all, [&](std::span<const pipeline::TelemetrySample> rows) -> Result<void> {
    for (const pipeline::TelemetrySample& row : rows) {
      if (!row.contact) continue;
      const double time_s = secondsInto(recording.info(), row.now);
      // Lost rows count as a break in contact.
      if (open && row.now - last_contact >= kLongestBreak) {
        touches.push_back(open->finish());
        open.reset();
      }
      if (!open) {
        open.emplace(time_s);
        last_contact = row.now;
      }
      open->add(row, time_s);
      last_contact = std::max(last_contact, row.now);
    }
    return {};
  });
  if (!read) return tl::unexpected(read.error());
  if (open) touches.push_back(open->finish());
  return touches;
}

}  // namespace fyd::exports
