#include "core/sim/server/touchpad_fault.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fyd::sim {
namespace {

constexpr double kBrownOut_s = 0.5;

bool readSeconds(std::string_view text, double& out) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), out);
  return problem == std::errc() && end == text.data() + text.size() && std::isfinite(out) && out >= 0.0;
}

}  // namespace

Result<TimedFault> parseTimedFault(std::string_view text) {
  const std::size_t at = text.find('@');
  const auto name = std::ranges::find(kTouchpadFaultNames, text.substr(0, at));
  const std::string_view times = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
  const std::size_t plus = times.find('+');
  TimedFault out;
  const bool good = name != kTouchpadFaultNames.end() && readSeconds(times.substr(0, plus), out.at_s) &&
                    (plus == std::string_view::npos || readSeconds(times.substr(plus + 1), out.for_s));
  if (!good) {
    return fail("fault '{}': expected NAME@SECONDS or NAME@SECONDS+DURATION with one of {}", text,
                fmt::join(kTouchpadFaultNames, ", "));
  }
  out.fault = static_cast<TouchpadFault>(name - kTouchpadFaultNames.begin());
  if (plus == std::string_view::npos && out.fault == TouchpadFault::brown_out) out.for_s = kBrownOut_s;
  if (plus == std::string_view::npos && out.fault == TouchpadFault::late_reply) out.for_s = 0.0;
  return out;
}

void FaultPlan::add(TouchpadFault fault, Instant now, double for_s) const {
  const std::scoped_lock lock(shared_->mutex);
  shared_->faults.push_back({.fault = fault, .at_s = toSeconds(now - start_), .for_s = for_s});
}

bool FaultPlan::active(TouchpadFault fault, Instant now) const {
  const double t = toSeconds(now - start_);
  const std::scoped_lock lock(shared_->mutex);
  return std::ranges::any_of(
      shared_->faults, [&](const TimedFault& f) { return f.fault == fault && t >= f.at_s && t - f.at_s < f.for_s; });
}

int FaultPlan::begun(TouchpadFault fault, Instant now, Count count) const {
  const double t = toSeconds(now - start_);
  const std::scoped_lock lock(shared_->mutex);
  return static_cast<int>(std::ranges::count_if(shared_->faults, [&](const TimedFault& f) {
    return f.fault == fault && t >= f.at_s && (count == Count::all || f.for_s == 0.0);
  }));
}

}  // namespace fyd::sim
