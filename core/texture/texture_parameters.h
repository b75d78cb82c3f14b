// Everything an operator may set about texture rendering.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/message.h"
#include "core/texture/felt/felt_settings.h"

namespace fyd::texture {

enum class MethodChoice : std::uint8_t { single, soc, magnitude, principal, dft321, recolour, dft321_thesis };
inline constexpr std::array<std::string_view, 7> kMethodNames = {"single", "soc",      "magnitude",    "principal",
                                                                 "dft321", "recolour", "dft321_thesis"};

enum class FilterChoice : std::uint8_t {
  standard,  ///< second-order Butterworth high-pass with its zero exactly at DC; named "default"
  thesis,    ///< the thesis' printed coefficients: gravity leaks at −48 dB, the passband is inverted
  none,      ///< the accelerations as they come
};
inline constexpr std::array<std::string_view, 3> kFilterNames = {"default", "thesis", "none"};

/// Frame of the short-time methods. A choice, so that every one of them exists before the first step.
enum class FrameChoice : std::uint8_t { of_8, of_16, of_32, of_64, of_128, of_256, of_512 };
inline constexpr std::array<std::string_view, 7> kFrameNames = {"8", "16", "32", "64", "128", "256", "512"};
[[nodiscard]] constexpr int frameLength(FrameChoice choice) { return 8 << static_cast<int>(choice); }

/// How far a frame advances: by all of itself (blocks), by a half or by a quarter (overlapped).
enum class HopChoice : std::uint8_t { frame, half, quarter };
inline constexpr std::array<std::string_view, 3> kHopNames = {"frame", "half", "quarter"};
[[nodiscard]] constexpr int hopLength(FrameChoice frame, HopChoice hop) {
  return frameLength(frame) >> static_cast<int>(hop);
}

enum class PwmChoice : std::uint8_t {
  symmetric,  ///< rounds alike on both sides of zero, gain before the limit
  thesis,     ///< floor, gain after the limit, exactly zero accelerations switch the duty off at once
  felt,       ///< compensates motors and cloth, so that the finger feels the signal
};
inline constexpr std::array<std::string_view, 3> kPwmNames = {"symmetric", "thesis", "felt"};

// Signals from the least that a finger feels to the sum of an accelerometer's three axes of 5 g, with a third to spare.
inline constexpr double kFeltLeast_g = 0.02;
inline constexpr double kMostSignal_g = 20.0;

struct TextureParameters {
  MethodChoice method = MethodChoice::dft321;
  FilterChoice filter = FilterChoice::standard;
  double corner_Hz = 78.0;
  double sample_rate_Hz = 1000.0;
  FrameChoice frame = FrameChoice::of_32;
  HopChoice hop = HopChoice::half;
  double k_vib = 1.0;
  double dead_zone_percent = 25.0;
  double maximum_percent = 100.0;
  double full_scale_g = 2.0;
  PwmChoice pwm = PwmChoice::felt;
  double felt_rms_limit_percent = FeltSettings{}.rms_limit_percent;
  double felt_gate_g = FeltSettings{}.gate_g;
  double felt_surface_level_g = FeltSettings{}.surface_level_g;
  double input_delay_ms = 0.5;
  double maximum_gap_ms = 2.5;
  double crossfade_ms = 20.0;
  FeltPlant plant;

  template <class Visitor>
  void describe(Visitor& v) {
    v.choice(
        "texture.method", method, kMethodNames,
        {.name = sentence("Method"), .help = sentence("How three axes of vibration become one signal."), .live = true});
    v.choice(
        "texture.filter", filter, kFilterNames,
        {.name = sentence("Filter"),
         .help = sentence("High-pass in front of the method; thesis is the printed one, with its leak of gravity."),
         .live = true});
    v.real("texture.corner_Hz", corner_Hz,
           {.name = sentence("Corner"),
            .unit = "Hz",
            .minimum = 1,
            .maximum = 400,
            .help = sentence("Corner (-3 dB) of the default high-pass."),
            .live = true});
    v.real("texture.sample_rate_Hz", sample_rate_Hz,
           {.unit = "Hz",
            .minimum = 50,
            .maximum = 10000,
            .help = sentence("Rate at which the texture step is called and its filters are designed.")});
    v.choice("texture.frame", frame, kFrameNames,
             {.name = sentence("Frame"),
              .help = sentence("Samples in a frame of dft321: more resolution for more delay."),
              .live = true});
    v.choice("texture.hop", hop, kHopNames,
             {.name = sentence("Hop"),
              .help = sentence("Advance from a frame to the next: whole frames are blocks, less overlaps them."),
              .live = true});
    v.real("texture.k_vib", k_vib,
           {.name = sentence("Gain k_vib"),
            .minimum = 0,
            .maximum = 10,
            .help = sentence("Gain of the vibration; the robot's operator moves it by 0.1."),
            .live = true});
    v.real("texture.dead_zone_percent", dead_zone_percent,
           {.name = sentence("Dead zone"),
            .unit = "%",
            .minimum = 0,
            .maximum = 100,
            .help =
                sentence("Mappings symmetric and thesis: duties smaller than this become zero, as the motors would not "
                         "turn."),
            .live = true});
    v.real("texture.maximum_percent", maximum_percent,
           {.name = sentence("Maximum"),
            .unit = "%",
            .minimum = 0,
            .maximum = 100,
            .help = sentence("Largest duty that vibration may use."),
            .live = true});
    v.real("texture.full_scale_g", full_scale_g,
           {.name = sentence("Full scale"),
            .unit = "g",
            .minimum = kFeltLeast_g,
            .maximum = kMostSignal_g,
            .help = sentence("Signal that asks for the largest duty (s_max of the thesis)."),
            .live = true});
    v.choice("texture.pwm", pwm, kPwmNames,
             {.name = sentence("Mapping"),
              .help = sentence(
                  "Mapping from signal to duty: so that the finger feels it, rounded alike on both sides, or as the "
                  "thesis prints it."),
              .live = true});
    v.real("texture.felt_rms_limit_percent", felt_rms_limit_percent,
           {.name = sentence("Heat limit"),
            .unit = "%",
            .minimum = 1,
            .maximum = 100,
            .help = sentence("Mapping felt: largest RMS duty over a second, for the motors' heat."),
            .live = true});
    v.real("texture.felt_gate_g", felt_gate_g,
           {.name = sentence("Noise gate"),
            .unit = "g",
            .minimum = 0,
            .maximum = 1,
            .help = sentence("Mapping felt: a steady signal of less RMS than this is noise and stays silent."),
            .live = true});
    v.real("texture.felt_surface_level_g", felt_surface_level_g,
           {.name = sentence("Surface level"),
            .unit = "g",
            .minimum = 0,
            .maximum = kMostSignal_g,
            .help = sentence("Mapping felt: stored RMS of the surface, to which the gain is fitted; 0 learns it from "
                             "the touch."),
            .live = true});
    v.real("texture.input_delay_ms", input_delay_ms,
           {.name = sentence("Input delay"),
            .unit = "ms",
            .minimum = 0,
            .maximum = 200,
            .help = sentence(
                "How long accelerations wait (plus up to one period), so that jittery packets still arrive in time; "
                "FYD Link raises it to what its batches need."),
            .live = true});
    v.real("texture.maximum_gap_ms", maximum_gap_ms,
           {.name = sentence("Maximum gap"),
            .unit = "ms",
            .minimum = 0.1,
            .maximum = 25,
            .help = sentence("Accelerations further apart than this are a gap, during which the texture is silent."),
            .live = true});
    v.real("texture.crossfade_ms", crossfade_ms,
           {.name = sentence("Crossfade"),
            .unit = "ms",
            .minimum = 1,
            .maximum = 500,
            .help = sentence("Time over which a new method, filter or gain takes over."),
            .live = true});
    plant.describe(v);
  }
};

}  // namespace fyd::texture
