#include "app/console/tune/loop_study.h"

#include <cmath>
#include <memory>

#include "core/pipeline/tune_sample.h"
#include "core/sim/trial/stiffness_trial.h"
#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

constexpr double kKept_s = 60.0;
constexpr double kThin_s = 0.01;  // sampling interval of the identification

widgets::ResponseView toView(const control::LoopPrediction& loop, const std::vector<control::LoopPoint>& course) {
  widgets::ResponseView view{.rise_s = loop.rise_s,
                             .settling_s = loop.settling_s,
                             .overshoot_percent = loop.overshoot_percent,
                             .steady_error_percent = loop.steady_error_percent,
                             .gain_margin = loop.margins.gain_margin,
                             .phase_margin_deg = loop.margins.phase_margin_deg,
                             .verdict = loop.verdict};
  view.course.reserve(course.size());
  for (const control::LoopPoint& point : course) view.course.emplace_back(point.time_s, 100.0 * point.relative);
  return view;
}

widgets::ResponseView respondTo(const control::IdentifiedCloth& cloth, const control::ControlParameters& parameters,
                                const control::LoopTiming& timing) {
  std::vector<control::LoopPoint> course;
  const control::LoopPrediction loop = control::predictLoop(cloth, parameters, timing, &course);
  return toView(loop, course);
}

/// Rounded to the accuracy of the identification, so that the applied value equals the shown one.
double rounded(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double digit = std::pow(10.0, 2 - std::floor(std::log10(std::abs(value))));
  return std::round(value * digit) / digit;
}

void roundTuned(control::ControlParameters& p) {
  for (double* value :
       {&p.kp, &p.ki_per_s, &p.kd_s, &p.measurement_lag_s, &p.measurement_delay_s, &p.noise_correlation_s}) {
    *value = rounded(*value);
  }
}

}  // namespace

LoopStudy::LoopStudy(QObject* parent) : QObject(parent), responding_(this), tuning_(this) {
  constexpr int kSoon_ms = 120;  // computes once a dragged slider stops moving
  soon_.setSingleShot(true);
  soon_.setInterval(kSoon_ms);
  connect(&soon_, &QTimer::timeout, this, &LoopStudy::respond);
  connect(&responding_, &Background::runningChanged, this, &LoopStudy::respondingChanged);
  connect(&tuning_, &Background::runningChanged, this, &LoopStudy::tuningChanged);
  connect(&tuning_, &Background::failed, this, &LoopStudy::failed);
}

void LoopStudy::listen(std::span<const pipeline::TelemetrySample> samples) {
  for (const pipeline::TelemetrySample& sample : samples) {
    const double now_s = toSeconds(sample.now.time_since_epoch());
    if (!heard_.empty() && now_s < heard_.back().time_s) heard_.clear();  // the time of another session
    if (!heard_.empty() && now_s < heard_.back().time_s + kThin_s) continue;
    if (!std::isfinite(sample.stretch_measured_deg)) continue;
    heard_.push_back(pipeline::tuneSampleOf(sample, now_s));
    while (heard_.back().time_s - heard_.front().time_s > kKept_s) heard_.pop_front();
  }
}

void LoopStudy::setValues(const control::ControlParameters& current, const control::ControlParameters& saved,
                          const control::LoopTiming& timing) {
  timing_ = timing;
  current_ = current;
  saved_ = saved;
  soon_.start();
}

void LoopStudy::respond() {
  const std::optional<control::IdentifiedCloth> identified = proposal_ ? std::optional(proposal_->cloth) : std::nullopt;
  responding_.run([this, identified, current = current_, saved = saved_,
                   timing = timing_](const std::stop_token& stop) -> Background::Finish {
    const auto study = [&](const control::ControlParameters& p) {
      return respondTo(identified ? *identified : control::assumedCloth(p), p, timing);
    };
    const widgets::ResponseView first = study(current);
    if (stop.stop_requested()) return {};
    const widgets::ResponseView second = study(saved);
    return [this, first, second] { emit responses(first, second); };
  });
}

void LoopStudy::autoTune(TuneSource source, const station::Profile& present) {
  discard();
  std::vector<control::TuneSample> recording;
  if (source == TuneSource::session) recording.assign(heard_.begin(), heard_.end());
  tuning_.run([this, source, present, timing = timing_,
               recording = std::move(recording)](const std::stop_token& stop) mutable -> Background::Finish {
    // The excitation takes the first part of the time where there is one, the fit and the search the rest.
    const double excited = source == TuneSource::simulation ? 0.5 : 0.0;
    const auto tell = [&](double done) {
      QMetaObject::invokeMethod(
          this, [this, done] { emit progressed(done); }, Qt::QueuedConnection);
      return !stop.stop_requested();
    };
    if (source == TuneSource::simulation) {
      recording = sim::recordExcitation({.parameters = present.step, .sim = present.sim},
                                        [&](double done) { return tell(excited * done); });
    }
    if (stop.stop_requested()) return {};
    auto found = control::proposeGains(recording, present.step.control,
                                       [&](double done) { return tell(excited + (1.0 - excited) * done); });
    if (!found) return [this, why = widgets::coreText(found.error().message)] { emit failed(why); };
    roundTuned(found->proposed);
    const widgets::ResponseView response = respondTo(found->cloth, found->proposed, timing);
    return [this, proposal = *found, response] {
      proposal_ = proposal;
      soon_.start();  // the other responses with the same model of the cloth
      emit proposed(response);
    };
  });
}

void LoopStudy::cancel() { tuning_.cancel(); }

void LoopStudy::discard() {
  if (!proposal_) return;
  proposal_.reset();
  soon_.start();
}

}  // namespace fyd::console
