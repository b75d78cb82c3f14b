#include "core/texture/texture_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/archive.h"
#include "core/texture/felt/felt_mapping.h"
#include "core/texture/method_bank.h"
#include "core/texture/pwm.h"
#include "core/texture/uniform_stream.h"

namespace fyd::texture {
namespace {

// A new filter needs a few periods of its corner, a new method its delay, before it may be felt.
constexpr int kSettlingSamples = 32;
// The mapping felt finds the gain of a surface before it takes over from another one.
constexpr int kFeltLearns = 150;

double glide(double from, double to, double share_of_way, double span) {
  const double step = span * share_of_way;
  return std::clamp(to, from - step, from + step);
}

ChainChoice chainOf(const TextureParameters& p) {
  return {.method = p.method, .filter = p.filter, .corner_Hz = p.corner_Hz, .frame = p.frame, .hop = p.hop};
}

PwmSettings settingsOf(const TextureParameters& p) {
  return {.k_vib = p.k_vib,
          .full_scale_g = p.full_scale_g,
          .maximum_percent = p.maximum_percent,
          .dead_zone_percent = p.dead_zone_percent};
}

FeltSettings feltSettingsOf(const TextureParameters& p) {
  return {.plant = p.plant,
          .gain = p.k_vib,
          .maximum_percent = p.maximum_percent,
          .rms_limit_percent = p.felt_rms_limit_percent,
          .gate_g = p.felt_gate_g,
          .surface_level_g = p.felt_surface_level_g};
}

}  // namespace

struct TextureRenderer::State {
  explicit State(const TextureParameters& p)
      : parameters(p),
        sample_rate_Hz(p.sample_rate_Hz),
        stream(p.sample_rate_Hz),
        banks{MethodBank(p.sample_rate_Hz), MethodBank(p.sample_rate_Hz)},
        playing(chainOf(p)),
        pwm(settingsOf(p)),
        felt(feltSettingsOf(p), p.sample_rate_Hz) {
    startMapping();
    stream.configure(p.input_delay_ms, p.maximum_gap_ms);
    banks[active].select(playing);
  }

  [[nodiscard]] Chain& current() { return banks[active].chain(); }
  [[nodiscard]] Chain& incoming() { return banks[1 - active].chain(); }
  [[nodiscard]] bool wantsFelt() const { return parameters.pwm == PwmChoice::felt; }
  [[nodiscard]] double fadeShare() const { return std::min(1.0, 1e3 / (parameters.crossfade_ms * sample_rate_Hz)); }

  void startSwitch() {
    coming = chainOf(parameters);
    banks[1 - active].select(coming);
    incoming_resumes = true;
    until_audible = incoming().delaySamples() + kSettlingSamples;
    fade = 0.0;
    switching = true;
  }

  double stepChain(const UniformStream::Step& sample) {
    if (!switching && !(chainOf(parameters) == playing)) startSwitch();
    const double now_playing = sample.gap ? current().stepGap() : current().step(sample.acceleration_g, sample.resumed);
    if (!switching) return now_playing;

    double next = 0.0;
    if (sample.gap) {
      next = incoming().stepGap();
    } else {
      next = incoming().step(sample.acceleration_g, sample.resumed || incoming_resumes);
      incoming_resumes = false;
    }
    if (until_audible > 0) {
      --until_audible;
      return now_playing;
    }
    fade = std::min(1.0, fade + fadeShare());
    const double mixed = (1.0 - fade) * now_playing + fade * next;
    if (fade >= 1.0) {
      active = 1 - active;
      playing = coming;
      switching = false;
    }
    return mixed;
  }

  void glidePwm() {
    const double share = fadeShare();
    const PwmSettings to = settingsOf(parameters);
    pwm.k_vib = glide(pwm.k_vib, to.k_vib, share, std::max(k_vib_span, 0.1));
    pwm.full_scale_g = glide(pwm.full_scale_g, to.full_scale_g, share, std::max(full_scale_span_g, 1e-3));
    pwm.maximum_percent = glide(pwm.maximum_percent, to.maximum_percent, share, 100.0);
    pwm.dead_zone_percent = glide(pwm.dead_zone_percent, to.dead_zone_percent, share, 100.0);
  }

  void startMapping() {
    felt_share = wantsFelt() ? 1.0 : 0.0;
    felt_unheard = wantsFelt() ? 0 : kFeltLearns;
    felt.reset();
  }

  /// Replaces the duties in `out` by those of the mapping felt, or crossfades to or from it.
  void blendFelt(double signal_g, double position_share_percent, TextureOutput& out) {
    const double goal = wantsFelt() ? 1.0 : 0.0;
    if (felt_share == 0.0 && goal == 0.0) {
      felt_unheard = kFeltLearns;
      return;
    }
    if (felt_unheard == kFeltLearns) felt.reset();
    felt_unheard = std::max(felt_unheard - 1, 0);
    if (goal == 0.0 || felt_unheard == 0) felt_share = glide(felt_share, goal, fadeShare(), 1.0);
    FeltSettings settings = feltSettingsOf(parameters);
    settings.gain = pwm.k_vib;  // the gliding values
    settings.maximum_percent = pwm.maximum_percent;
    felt.configure(settings);
    felt.setStretch(stretch_deg);
    const FeltDuty duty = felt.step(signal_g, position_share_percent);
    for (std::size_t i = 0; i < kFeltMotors; ++i) {
      out.duty_percent[i] += felt_share * (duty.percent[i] - out.duty_percent[i]);
    }
    out.wanted_g += felt_share * (duty.wanted_g - out.wanted_g);
    out.limited = felt_share >= 1.0 ? duty.clipped : out.limited || duty.clipped;
  }

  TextureOutput finish(double signal_g, bool silent_input, double position_share_percent) {
    glidePwm();
    if (!std::isfinite(signal_g)) signal_g = 0.0;
    const bool thesis = parameters.pwm == PwmChoice::thesis;
    Duty wanted = thesis ? thesisDuty(signal_g, pwm) : symmetricDuty(signal_g, pwm);
    if (thesis && silent_input) wanted = {};
    const Duty sent = limitDuty(wanted, pwm.maximum_percent, position_share_percent);
    TextureOutput out;
    out.signal_g = out.wanted_g = signal_g;
    out.duty_percent.fill(sent.percent);
    out.limited = sent.clipped;
    blendFelt(signal_g, position_share_percent, out);
    if (out.limited) ++clipped;
    out.filtered_g = current().filtered_g();
    out.delay_ms = parameters.input_delay_ms + 1e3 * current().delaySamples() / sample_rate_Hz;
    out.position_share_known = std::isfinite(position_share_percent);
    out.clipped = clipped;
    out.gaps = stream.gaps();
    out.refused_samples = stream.refused();
    return out;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    serializeFirst(archive);
    archive(felt_share, within(felt_unheard, kFeltLearns), stretch_deg, felt);
  }

  /// What version 1 held.
  template <class Archive>
  void serializeFirst(Archive& archive) {
    archive(stream, playing, coming, within(active, 1), switching, incoming_resumes, counter(until_audible), fade,
            virtual_share, pwm, k_vib_span, full_scale_span_g, clipped);
    banks[active].exchange(archive, playing);
    if (switching) banks[1 - active].exchange(archive, coming);
  }

  TextureParameters parameters;
  double sample_rate_Hz;
  UniformStream stream;
  std::array<MethodBank, 2> banks;
  std::size_t active = 0;
  ChainChoice playing;
  ChainChoice coming;
  bool switching = false;
  bool incoming_resumes = false;
  int until_audible = 0;
  double fade = 0.0;
  double virtual_share = 0.0;  // 0: the robot's accelerations, 1: the virtual texture
  PwmSettings pwm;
  double k_vib_span = 0.0;  // of the change being glided
  double full_scale_span_g = 0.0;
  std::uint64_t clipped = 0;
  double felt_share = 0.0;  // 0: pwm.h, 1: felt
  int felt_unheard = 0;     // samples for which it still learns the surface before it is felt
  double stretch_deg = std::numeric_limits<double>::quiet_NaN();
  FeltMapping felt;
};

TextureRenderer::TextureRenderer(const TextureParameters& parameters) : state_(std::make_unique<State>(parameters)) {}
TextureRenderer::~TextureRenderer() = default;
TextureRenderer::TextureRenderer(TextureRenderer&&) noexcept = default;
TextureRenderer& TextureRenderer::operator=(TextureRenderer&&) noexcept = default;

void TextureRenderer::configure(const TextureParameters& parameters) {
  State& s = *state_;
  s.parameters = parameters;
  s.stream.configure(parameters.input_delay_ms, parameters.maximum_gap_ms);
  s.k_vib_span = std::abs(parameters.k_vib - s.pwm.k_vib);
  s.full_scale_span_g = std::abs(parameters.full_scale_g - s.pwm.full_scale_g);
}

TextureOutput TextureRenderer::step(Instant now, std::span<const AccelerationSample> new_samples,
                                    double position_share_percent) {
  State& s = *state_;
  s.stream.push(now, new_samples);
  const UniformStream::Step sample = s.stream.step(now);
  s.virtual_share = 0.0;
  TextureOutput out =
      s.finish(s.stepChain(sample), sample.gap || sample.acceleration_g == Vec3{}, position_share_percent);
  out.gap = sample.gap;
  return out;
}

TextureOutput TextureRenderer::stepVirtual(double signal_g, double position_share_percent) {
  State& s = *state_;
  const double rest = s.stepChain({});
  s.virtual_share = std::min(1.0, s.virtual_share + s.fadeShare());
  const double signal = std::isfinite(signal_g) ? signal_g : 0.0;
  return s.finish((1.0 - s.virtual_share) * rest + s.virtual_share * signal, false, position_share_percent);
}

void TextureRenderer::reset() {
  State& s = *state_;
  s.stream.reset();
  s.switching = false;
  s.playing = chainOf(s.parameters);
  s.banks[s.active].select(s.playing);
  s.virtual_share = 0.0;
  s.pwm = settingsOf(s.parameters);
  s.startMapping();
}

void TextureRenderer::setStretch(double stretch_deg) { state_->stretch_deg = stretch_deg; }

template <class Archive>
void TextureRenderer::serialize(Archive& archive) {
  archive(*state_);
}

template <class Archive>
void TextureRenderer::restore(Archive& archive, std::uint16_t) {
  State& s = *state_;
  s.serializeFirst(archive);
  s.startMapping();
}
template void TextureRenderer::restore(StateReader& archive, std::uint16_t version);

template void TextureRenderer::serialize(StateWriter& archive);
template void TextureRenderer::serialize(StateReader& archive);

}  // namespace fyd::texture
