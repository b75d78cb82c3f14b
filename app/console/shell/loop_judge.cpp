#include "app/console/shell/loop_judge.h"

#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

constexpr double kMean_samples = 2000.0;  // two seconds of a step's telemetry

using widgets::tr;

}  // namespace

void LoopJudge::listen(std::span<const pipeline::TelemetrySample> samples) {
  for (const pipeline::TelemetrySample& sample : samples) {
    if (!std::isfinite(sample.motors_age_ms)) continue;
    if (!motors_age_ms_) motors_age_ms_ = sample.motors_age_ms;
    *motors_age_ms_ += (sample.motors_age_ms - *motors_age_ms_) / kMean_samples;
  }
}

std::optional<control::LoopTiming> LoopJudge::timing() const {
  if (!motors_age_ms_) return std::nullopt;
  return control::LoopTiming{.motors_age_s = *motors_age_ms_ / 1000.0};
}

QString LoopJudge::doubt(control::ControlParameters present, std::span<const widgets::Setting> next) const {
  bool of_the_loop = false;
  const auto bound = bindParameters(present);
  for (const widgets::Setting& setting : next) {
    const Parameter* parameter = findParameter(bound, setting.id);
    if (parameter == nullptr) continue;
    parameter->set(setting.value);
    of_the_loop = true;
  }
  if (!of_the_loop) return {};
  const control::LoopTiming at_best{.motors_age_s = 0.0};
  const control::LoopPrediction loop =
      control::predictLoop(cloth_ ? *cloth_ : control::assumedCloth(present), present, timing().value_or(at_best));
  if (loop.verdict != control::LoopVerdict::unstable) return {};
  const QString margins = tr("gain margin %1, phase margin %2")
                              .arg(widgets::quantityText(loop.margins.gain_margin, 2, QStringLiteral("×")),
                                   widgets::quantityText(loop.margins.phase_margin_deg, 0, QStringLiteral("°")));
  if (!motors_age_ms_)
    return tr("The model calls this unstable on any touchpad: the stretch would swing on (%1).").arg(margins);
  return tr("The model calls this unstable: the stretch would swing on (%1; the motors' angle is %2 old).")
      .arg(margins, widgets::quantityText(*motors_age_ms_, 1, QStringLiteral("ms")));
}

}  // namespace fyd::console
