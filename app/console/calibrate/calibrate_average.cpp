#include "app/console/calibrate/calibrate_average.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"

namespace fyd::console {

void CalibrationAverage::restart(int readings) {
  wanted_ = std::max(1, readings);
  kept_.clear();
}

void CalibrationAverage::add(std::vector<double> reading, const std::vector<CalibrationSignal>& wanted) {
  if (!kept_.empty() && kept_.front().size() != reading.size()) kept_.clear();  // another touchpad
  turns_.assign(reading.size(), 0.0);
  for (std::size_t c = 0; c < std::min(wanted.size(), reading.size()); ++c) {
    turns_[c] = wanted[c].turn;
    if (turns_[c] <= 0.0 || kept_.empty()) continue;
    const double last = kept_.back()[c];
    reading[c] = last + std::remainder(reading[c] - last, turns_[c]);
  }
  kept_.push_back(std::move(reading));
  while (static_cast<int>(kept_.size()) > wanted_) kept_.pop_front();
}

std::vector<double> CalibrationAverage::meanOf(std::size_t from, std::size_t to) const {
  if (from >= to) return {};
  std::vector<double> out(kept_.front().size(), 0.0);
  for (std::size_t i = from; i < to; ++i) {
    for (std::size_t c = 0; c < out.size(); ++c) out[c] += kept_[i][c] / static_cast<double>(to - from);
  }
  return out;
}

std::vector<double> CalibrationAverage::mean() const {
  std::vector<double> out = meanOf(0, kept_.size());
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (turns_[c] > 0.0) out[c] -= turns_[c] * std::floor(out[c] / turns_[c]);
  }
  return out;
}

std::vector<double> CalibrationAverage::spread() const {
  const std::vector<double> middle = meanOf(0, kept_.size());
  std::vector<double> out(middle.size(), 0.0);
  if (kept_.size() < 2) return out;
  for (std::size_t c = 0; c < out.size(); ++c) {
    for (const auto& reading : kept_) out[c] += (reading[c] - middle[c]) * (reading[c] - middle[c]);
    out[c] = std::sqrt(out[c] / static_cast<double>(kept_.size() - 1));
  }
  return out;
}

QString CalibrationAverage::moving(const std::vector<CalibrationSignal>& wanted) const {
  const std::vector<double> spreads = spread();
  const std::size_t half = kept_.size() / 2;
  const std::vector<double> first = meanOf(0, half), last = meanOf(half, kept_.size());
  for (std::size_t c = 0; c < std::min(wanted.size(), spreads.size()); ++c) {
    // A slow drift adds little to the spread, so the means of both halves are compared as well.
    const double drift = half > 0 ? std::abs(last[c] - first[c]) : 0.0;
    const double moves = std::max(spreads[c], drift);
    if (moves <= wanted[c].largest_spread) continue;
    return QCoreApplication::translate("CalibrationAverage", "%1 moves by %2; at rest it stays within %3")
        .arg(wanted[c].name, widgets::quantityText(moves, wanted[c].decimals, wanted[c].unit),
             widgets::quantityText(wanted[c].largest_spread, wanted[c].decimals, wanted[c].unit));
  }
  return {};
}

}  // namespace fyd::console
