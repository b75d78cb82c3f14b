#include "core/sim/touchpad/cloth_presses.h"

#include "core/sim/cloth/cloth.h"

namespace fyd::sim {

std::vector<ClothPress> pressesOverSensors(const SimParameters& parameters, double stretch_deg,
                                           std::span<const double> depths_mm) {
  Cloth cloth(parameters);
  std::vector<ClothPress> out;
  for (const SensorPlace& place : kIrPlaces) {
    for (const double depth_mm : depths_mm) {
      const FingerState finger{.x_mm = place.x_mm, .y_mm = place.y_mm, .indentation_mm = depth_mm, .lifted = false};
      const Pressing press = cloth.press(stretch_deg, finger, 0.0);
      ClothPress& now = out.emplace_back();
      now.depth_mm = depth_mm;
      now.contact = {finger.x_mm + press.centre_x_mm, finger.y_mm + press.centre_y_mm, press.area_mm2};
      // The picture of an ideal cloth has no perspective, as if from far away.
      now.seen = cloth.kind() == ClothKind::ideal ? now.contact
                                                  : seenFromBelow(now.contact, depth_mm, parameters.cloth_height_mm);
      for (std::size_t i = 0; i < kIrPlaces.size(); ++i) {
        now.deflection_mm[i] = cloth.deflection_mm(kIrPlaces[i].x_mm, kIrPlaces[i].y_mm, finger);
      }
    }
  }
  return out;
}

}  // namespace fyd::sim
