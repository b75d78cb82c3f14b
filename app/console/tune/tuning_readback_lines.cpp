#include "app/console/tune/tuning_readback_lines.h"

#include <algorithm>
#include <cmath>

#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::ReadbackLine;

constexpr double kFollows_deg = 2.0;   // tolerance of the motors' angles
constexpr double kSame_percent = 1.0;  // tolerance of camera controls, which drivers round

using widgets::tr;

/// @return `asked` and `said` compared; NaN on one side is no answer
ReadbackLine compare(const QString& what, double asked, double said, double tolerance, const QString& unit) {
  ReadbackLine line{
      .what = what, .asked = widgets::quantityText(asked, 1, unit), .said = widgets::quantityText(said, 1, unit)};
  if (std::isnan(asked) || std::isnan(said)) return line;
  line.state = std::abs(asked - said) <= tolerance ? ReadbackLine::State::confirmed : ReadbackLine::State::differs;
  return line;
}

/// Vibration at the finger, estimated with the identified plant; no sensor measures it.
ReadbackLine vibrationAtTheFinger(const widgets::TuningModel& model, const pipeline::TelemetrySample& newest) {
  const widgets::TunedParameter* plant = model.find("texture.plant_identified");
  const bool identified = plant != nullptr && plant->value != 0.0;
  ReadbackLine line{.what = tr("Vibration at the finger, reckoned (%1)")
                                .arg(identified ? tr("motors and cloth identified") : tr("not identified")),
                    .asked = widgets::quantityText(newest.texture_signal_g, 2, QStringLiteral("g")),
                    .said = widgets::kNoValue};
  constexpr double kSilent_dB = -60.0;
  if (newest.felt_level_dB > kSilent_dB) {
    line.said = tr("%1 over what is felt; motors %2; too small to turn %3, clipped %4")
                    .arg(widgets::quantityText(newest.felt_level_dB, 0, QStringLiteral("dB")),
                         widgets::quantityText(newest.vibration_rms_percent, 0, QStringLiteral("%")),
                         widgets::quantityText(100.0 * newest.vibration_dead_share, 0, QStringLiteral("%")),
                         widgets::quantityText(100.0 * newest.vibration_clipped_share, 0, QStringLiteral("%")));
    line.state = newest.felt_level_dB >= 0.0 ? ReadbackLine::State::confirmed : ReadbackLine::State::unknown;
  }
  if (newest.felt_out_of_reach == 1.0) {
    line.said = tr("out of reach: less than is felt arrives");
    line.state = ReadbackLine::State::differs;
  }
  return line;
}

}  // namespace

std::vector<ReadbackLine> readbackLines(const widgets::TuningModel& model, const pipeline::TelemetrySample& newest,
                                        const std::vector<device::DeviceReport>& reports) {
  const auto all = model.parameters();
  const auto live = std::ranges::count_if(all, [](const auto& p) { return p.info.info.live; });
  const auto open = std::ranges::count_if(
      all, [](const auto& p) { return p.info.info.live && p.delivery != widgets::Delivery::confirmed; });
  std::vector<ReadbackLine> out;
  out.push_back({.what = tr("Live parameters, held by the step"),
                 .asked = QString::number(live),
                 .said = QString::number(live - open),
                 .state = open == 0 ? ReadbackLine::State::confirmed : ReadbackLine::State::differs});
  out.push_back(compare(tr("Stretch, read by the encoders"), newest.stretch_reference_deg, newest.stretch_measured_deg,
                        kFollows_deg, QStringLiteral("°")));
  for (const device::DeviceReport& report : reports) {
    for (const device::CameraControl& control : report.controls) {
      if (std::isnan(control.wanted)) continue;  // not set by the profile
      const QString what = tr("%1: %2").arg(widgets::coreText(toString(report.part)), widgets::coreText(control.name));
      out.push_back(compare(what, control.wanted, control.supported ? control.actual : std::nan(""), kSame_percent,
                            QStringLiteral("%")));
    }
  }
  out.push_back({.what = tr("Vibration duty, held by the motor board"),
                 .asked = widgets::quantityText(newest.vibration_duty_percent, 0, QStringLiteral("%")),
                 .said = widgets::kNoValue});
  out.push_back(vibrationAtTheFinger(model, newest));
  return out;
}

}  // namespace fyd::console
