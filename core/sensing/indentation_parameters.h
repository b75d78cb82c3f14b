// Parameters of the distance sensors and of the indentation under the finger [thesis §4.1.2].
// Stability: may change
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "core/base/message.h"
#include "core/base/parameter.h"
#include "core/sensing/ir_distance.h"
#include "core/sensing/membrane.h"
#include "core/sensing/readings.h"

namespace fyd::sensing {

enum class IndentationMode : std::uint8_t { membrane, thesis, contact };
inline constexpr std::array<std::string_view, 3> kIndentationModeNames = {"membrane", "thesis", "contact"};

/// A list with these values.
template <class... Values>
[[nodiscard]] ParameterList listOf(Values... values) {
  return {.items = {static_cast<double>(values)...}, .count = sizeof...(values)};
}

struct IndentationParameters {
  IndentationMode mode = IndentationMode::contact;
  ParameterList ir_x_mm = listOf(-22, 0, 22);
  ParameterList ir_y_mm = listOf(-3, 27, -3);
  ParameterList ir_offset_mm = listOf(100, 100, 100);
  ParameterList ir_lowest_code = listOf(524, 524, 524);
  ParameterList ir_highest_code = listOf(3408, 3408, 3408);
  std::array<ParameterList, kMaximumIrSensors> ir_curve_mm{};  ///< c₀…cₙ; empty: the thesis polynomial
  std::array<IrCurveForm, kMaximumIrSensors> ir_curve_form{};  ///< what those coefficients are
  double ir_noise_mV = 10.0;
  double ir_condition_limit = 20.0;
  double frame_half_width_mm = 50.0;
  double frame_half_depth_mm = 35.0;
  double finger_radius_mm = 7.0;
  double contact_radius_share = 0.655;
  double contact_radius_share_sigma = 0.1;
  double cloth_share_sigma = 0.02;
  ClothEdges cloth_edges = ClothEdges::held;
  double cloth_tension_ratio = 1.0;
  double cloth_tension_ratio_sigma = 0.12;
  double camera_height_mm = 100.0;
  double holding_mm_per_sqrt_s = 0.5;
  double moving_mm_per_sqrt_s = 20.0;
  double sigma_limit_mm = 10.0;

  /// Distance sensors that are looked at: the lists may hold more.
  [[nodiscard]] std::size_t sensors() const { return std::min({ir_x_mm.size(), ir_y_mm.size(), kMaximumIrSensors}); }

  template <class Visitor>
  void describe(Visitor& v) {
    static constexpr std::array<std::string_view, kMaximumIrSensors> kCurveIds = {
        "sensing.ir1_curve_mm", "sensing.ir2_curve_mm", "sensing.ir3_curve_mm", "sensing.ir4_curve_mm",
        "sensing.ir5_curve_mm", "sensing.ir6_curve_mm", "sensing.ir7_curve_mm", "sensing.ir8_curve_mm"};
    static constexpr std::array<std::string_view, kMaximumIrSensors> kFormIds = {
        "sensing.ir1_curve_form", "sensing.ir2_curve_form", "sensing.ir3_curve_form", "sensing.ir4_curve_form",
        "sensing.ir5_curve_form", "sensing.ir6_curve_form", "sensing.ir7_curve_form", "sensing.ir8_curve_form"};
    v.choice("sensing.indentation_mode", mode, kIndentationModeNames,
             {.name = sentence("Indentation mode"),
              .help = sentence(
                  "contact and membrane use the shape of the pushed cloth and a Kalman filter, contact with the area "
                  "that the camera sees; thesis a plane, 0.8/0.2 and a 2 mm gate."),
              .live = true,
              .before_it_was = 0});
    v.list("sensing.ir_x_mm", ir_x_mm,
           {.unit = "mm",
            .minimum = -100,
            .maximum = 100,
            .help = sentence("Distance sensors: x of each; as many as there are.")});
    v.list("sensing.ir_y_mm", ir_y_mm,
           {.unit = "mm", .minimum = -100, .maximum = 100, .help = sentence("Distance sensors: y of each.")});
    v.list("sensing.ir_offset_mm", ir_offset_mm,
           {.name = sentence("Ir offset"),
            .unit = "mm",
            .minimum = 0,
            .maximum = 400,
            .help = sentence("Distance sensors: distance to the untouched cloth; the tare sets it."),
            .live = true});
    v.list("sensing.ir_lowest_code", ir_lowest_code,
           {.minimum = 0, .maximum = 4095, .help = sentence("Distance sensors: lowest valid ADC code of each.")});
    v.list("sensing.ir_highest_code", ir_highest_code,
           {.minimum = 0, .maximum = 4095, .help = sentence("Distance sensors: highest valid ADC code of each.")});
    for (std::size_t i = 0; i < kMaximumIrSensors; ++i) {
      v.list(kCurveIds[i], ir_curve_mm[i],
             {.unit = "mm",
              .minimum = -1e6,
              .maximum = 1e6,
              .help = sentence("Distance sensor's curve of volts, as its form says; empty: the thesis polynomial.")});
      v.choice(kFormIds[i], ir_curve_form[i], kIrCurveFormNames,
               {.help = sentence("polynomial: c0 + c1 v + ..., constant first; inverse: c0/(v + c1) + c2.")});
    }
    v.real("sensing.ir_noise_mV", ir_noise_mV,
           {.name = sentence("Ir noise"),
            .unit = "mV",
            .minimum = 0.1,
            .maximum = 200,
            .help = sentence("Distance sensors: noise of one reading."),
            .live = true});
    v.real("sensing.ir_condition_limit", ir_condition_limit,
           {.minimum = 2,
            .maximum = 1e6,
            .help = sentence("Sensors nearer to one line than this condition number make no plane.")});
    v.real("sensing.frame_half_width_mm", frame_half_width_mm,
           {.unit = "mm", .minimum = 10, .maximum = 200, .help = sentence("Half the usable cloth's width.")});
    v.real("sensing.frame_half_depth_mm", frame_half_depth_mm,
           {.unit = "mm", .minimum = 10, .maximum = 200, .help = sentence("Half the usable cloth's depth.")});
    v.real("sensing.finger_radius_mm", finger_radius_mm,
           {.unit = "mm",
            .minimum = 1,
            .maximum = 20,
            .help = sentence("Radius of the finger's contact with the cloth where no area tells it.")});
    v.real("sensing.contact_radius_share", contact_radius_share,
           {.name = sentence("Contact radius share"),
            .minimum = 0.3,
            .maximum = 1.3,
            .help = sentence("Contact mode: radius of the disc that the finger looks like from afar, as a share of the "
                             "contact's: 0.6 for a sphere, 1 for a flat disc."),
            .live = true});
    v.real("sensing.contact_radius_share_sigma", contact_radius_share_sigma,
           {.name = sentence("Uncertainty of the contact radius share"),
            .minimum = 0,
            .maximum = 1,
            .help = sentence("Contact mode: how uncertain that share is."),
            .live = true});
    v.real("sensing.cloth_share_sigma", cloth_share_sigma,
           {.name = sentence("Uncertainty of the cloth's formula"),
            .minimum = 0,
            .maximum = 0.5,
            .help = sentence("Contact mode: what the cloth's formula leaves of each sensor's share, as a part of the "
                             "indentation."),
            .live = true});
    v.choice("sensing.cloth_edges", cloth_edges, kClothEdgesNames,
             {.name = sentence("Cloth edges"),
              .help = sentence("Contact mode: held on all four sides, or held by two rollers left and right with front "
                               "and back free."),
              .live = true});
    v.real("sensing.cloth_tension_ratio", cloth_tension_ratio,
           {.name = sentence("Cloth tension ratio"),
            .minimum = 0.05,
            .maximum = 20,
            .help = sentence("Contact mode: the cloth's tension from left to right over that from front to back."),
            .live = true});
    v.real("sensing.cloth_tension_ratio_sigma", cloth_tension_ratio_sigma,
           {.name = sentence("Uncertainty of the tension ratio"),
            .minimum = 0,
            .maximum = 2,
            .help = sentence("Contact mode: how uncertain that ratio is, as a part of it."),
            .live = true});
    v.real("sensing.camera_height_mm", camera_height_mm,
           {.name = sentence("Camera height"),
            .unit = "mm",
            .minimum = 30,
            .maximum = 10000,
            .help = sentence("Contact mode: from the camera's lens to the untouched cloth."),
            .live = true});
    v.real("sensing.indentation_holding_mm_per_sqrt_s", holding_mm_per_sqrt_s,
           {.name = sentence("Indentation holding"),
            .unit = "mm/√s",
            .minimum = 0.01,
            .maximum = 100,
            .help = sentence("Kalman filter: how much the indentation wanders while the finger holds still."),
            .live = true});
    v.real("sensing.indentation_moving_mm_per_sqrt_s", moving_mm_per_sqrt_s,
           {.name = sentence("Indentation moving"),
            .unit = "mm/√s",
            .minimum = 0.1,
            .maximum = 1000,
            .help = sentence("Kalman filter: how much it wanders while the finger presses or lifts."),
            .live = true});
    v.real("sensing.indentation_sigma_limit_mm", sigma_limit_mm,
           {.name = sentence("Indentation sigma limit"),
            .unit = "mm",
            .minimum = 0.1,
            .maximum = 100,
            .help = sentence("An indentation less certain than this is unavailable."),
            .live = true});
  }
};

}  // namespace fyd::sensing
