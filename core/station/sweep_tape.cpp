#include "core/station/sweep_tape.h"

#include <algorithm>
#include <cmath>

#include "core/pipeline/telemetry.h"

namespace fyd::station {
namespace {

constexpr Duration kFarthest =
    std::chrono::milliseconds(25);  // of two samples with a straight line between them: a lost packet or two

struct Axis {
  double (*of)(const Vec3&);
};
constexpr std::array kAxes = {Axis{[](const Vec3& v) { return v.x; }}, Axis{[](const Vec3& v) { return v.y; }},
                              Axis{[](const Vec3& v) { return v.z; }}};

/// Linear interpolation between the neighbours in time; NaN when they are more than kFarthest apart.
double valueAt(const std::vector<texture::AccelerationSample>& samples, const Axis& axis, Instant when) {
  const auto after = std::ranges::lower_bound(samples, when, {}, &texture::AccelerationSample::taken);
  if (after == samples.end() || after == samples.begin()) return pipeline::kNone;
  const auto before = std::prev(after);
  if (after->taken - before->taken > kFarthest) return pipeline::kNone;
  const double share = toSeconds(when - before->taken) / toSeconds(after->taken - before->taken);
  return axis.of(before->acceleration_g) + share * (axis.of(after->acceleration_g) - axis.of(before->acceleration_g));
}

double varianceOf(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    squares += value * value;
    ++count;
  }
  return count > 0.0 ? squares / count - (sum / count) * (sum / count) : 0.0;
}

}  // namespace

void SweepTape::add(const pipeline::Inputs& inputs, const control::MotorCommand& command, int experiment,
                    Duration since_start, double stretch_deg) {
  for (const texture::AccelerationSample& sample : inputs.robot.accelerations) (void)samples_.push(sample);
  if (experiment == 0) return;
  Moment moment{.row = {.t_s = toSeconds(since_start), .part = experiment, .stretch_deg = stretch_deg},
                .at = inputs.now};
  moment.row.duty_percent = command.vibration_duty_percent;
  const auto& counts = inputs.motors.value.encoder_counts;
  for (std::size_t i = 0; i < moment.row.encoder_counts.size(); ++i) {
    moment.row.encoder_counts[i] = counts[i] % texture::kSweepCountsPerTurn;
  }
  (void)moments_.push(moment);
}

void SweepTape::restart() {
  gather();
  gathered_.clear();
  measured_.clear();
}

void SweepTape::gather() {
  moments_.consume_all([this](const Moment& moment) { gathered_.push_back(moment); });
  samples_.consume_all([this](const texture::AccelerationSample& sample) {
    if (measured_.empty() || sample.taken > measured_.back().taken) measured_.push_back(sample);
  });
}

std::vector<texture::SweepRow> SweepTape::rows() const {
  std::vector<texture::SweepRow> out;
  for (auto begin = gathered_.begin(); begin != gathered_.end();) {
    const auto end =
        std::find_if(begin, gathered_.end(), [&](const Moment& m) { return m.row.part != begin->row.part; });
    std::vector<Moment> grid;
    for (auto m = begin; m != end; ++m) {
      const auto number = std::llround((m->row.t_s - begin->row.t_s) * texture::kSweepRate_Hz);
      while (std::ssize(grid) < number) {
        grid.push_back(grid.back());
        grid.back().at += std::chrono::milliseconds(1);
      }
      if (std::ssize(grid) == number) grid.push_back(*m);
    }
    std::array<std::vector<double>, kAxes.size()> along;
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      for (const Moment& m : grid) along[axis].push_back(valueAt(measured_, kAxes[axis], m.at));
    }
    const auto& most = *std::ranges::max_element(along, {}, varianceOf);
    for (std::size_t n = 0; n < grid.size(); ++n) {
      grid[n].row.t_s = begin->row.t_s + static_cast<double>(n) / texture::kSweepRate_Hz;
      grid[n].row.acceleration_g = most[n];
      out.push_back(grid[n].row);
    }
    begin = end;
  }
  return out;
}

}  // namespace fyd::station
