#include "core/sim/cloth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/sim/cloth_tables.h"
#include "core/sim/ideal_shape.h"

namespace fyd::sim {
namespace {

constexpr double kReferenceDepth_mm = 3.0;

struct Tabulated {
  ClothKind cloth;
  FingerShape finger;
  double radius_mm;
  std::string_view name;
};

// By cloth and finger, radius rising.
constexpr Tabulated kTabulated[] = {
    {ClothKind::membrane, FingerShape::sphere, 6.0, "frame_sphere6"},
    {ClothKind::membrane, FingerShape::sphere, 8.0, "frame_sphere8"},
    {ClothKind::membrane, FingerShape::sphere, 12.0, "frame_sphere12"},
    {ClothKind::membrane, FingerShape::capsule, 8.0, "frame_capsule8"},
    {ClothKind::membrane, FingerShape::disc, 7.0, "frame_disc7"},
    {ClothKind::rollers, FingerShape::sphere, 8.0, "rollers_sphere8"},
    {ClothKind::rollers, FingerShape::capsule, 8.0, "rollers_capsule8"},
    {ClothKind::rollers, FingerShape::disc, 7.0, "rollers_disc7"},
};

std::shared_ptr<const ClothTable> tableOf(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string_view, std::shared_ptr<const ClothTable>> read;
  const std::scoped_lock lock(mutex);
  std::shared_ptr<const ClothTable>& table = read[name];
  if (!table) {
    if (clothTableText(name).empty())
      throw std::runtime_error(fmt::format("cloth {}: no such table is built in", name));
    auto parsed = ClothTable::parse(clothTableText(name));
    if (!parsed) throw std::runtime_error(fmt::format("cloth {}: {}", name, parsed.error().text()));
    table = std::make_shared<const ClothTable>(std::move(*parsed));
  }
  return table;
}

}  // namespace

Cloth::Cloth(const SimParameters& parameters)
    : kind_(parameters.cloth),
      fabric_(parameters.fabric_stiffness_scale, parameters.fabric_hysteresis),
      scale_(parameters.fabric_stiffness_scale),
      viscosity_s_(1e-3 * parameters.fabric_viscosity_ms) {
  if (kind_ == ClothKind::ideal) {
    ideal_ = std::make_shared<const IdealShape>();
    return;
  }
  const Tabulated* below = nullptr;
  const Tabulated* above = nullptr;
  for (const Tabulated& each : kTabulated) {
    if (each.cloth != kind_ || each.finger != parameters.finger) continue;
    if (below == nullptr || each.radius_mm <= parameters.finger_radius_mm) below = &each;
    if (above == nullptr || above->radius_mm < parameters.finger_radius_mm) above = &each;
  }
  const double apart = above->radius_mm - below->radius_mm;
  const double share =
      apart > 0.0 ? std::clamp((parameters.finger_radius_mm - below->radius_mm) / apart, 0.0, 1.0) : 0.0;
  if (share < 1.0) parts_.push_back({tableOf(below->name), 1.0 - share});
  if (share > 0.0) parts_.push_back({tableOf(above->name), share});
}

Pressing Cloth::atRest(double angle_deg, double x_mm, double y_mm, double depth_mm) const {
  Pressing out;
  const double reference = fabricStiffness(angle_deg);
  for (const Part& part : parts_) {
    const Pressing one = part.table->press(x_mm, y_mm, depth_mm, reference);
    out.force_N += part.weight * scale_ * one.force_N;
    out.area_mm2 += part.weight * one.area_mm2;
    out.centre_x_mm += part.weight * one.centre_x_mm;
    out.centre_y_mm += part.weight * one.centre_y_mm;
  }
  return out;
}

Pressing Cloth::press(double angle_deg, const FingerState& finger, double elapsed_s) {
  const double depth_mm = finger.indentation_mm;
  const double speed_mm_s = elapsed_s > 0.0 ? (depth_mm - last_mm_) / elapsed_s : 0.0;
  last_mm_ = depth_mm > 0.0 ? depth_mm : 0.0;
  Pressing out;
  if (kind_ == ClothKind::ideal) {
    out.force_N = fabric_.press(angle_deg, depth_mm);
  } else {
    const double loop = fabric_.loop(depth_mm);
    out = atRest(angle_deg, finger.x_mm, finger.y_mm, depth_mm);
    out.force_N *= loop;
  }
  if (viscosity_s_ > 0.0 && depth_mm > 0.0) {
    out.force_N = std::max(0.0, out.force_N * (1.0 + viscosity_s_ * speed_mm_s / depth_mm));
  }
  if (kind_ == ClothKind::ideal) out.area_mm2 = std::numbers::pi * std::pow(spotRadius_mm(out.force_N), 2);
  return out;
}

double Cloth::stiffness(double angle_deg, const FingerState& finger) const {
  if (kind_ == ClothKind::ideal) return fabric_.stiffness(angle_deg);
  if (!(finger.indentation_mm > 0.0))
    return atRest(angle_deg, 0.0, 0.0, kReferenceDepth_mm).force_N / kReferenceDepth_mm;
  return atRest(angle_deg, finger.x_mm, finger.y_mm, finger.indentation_mm).force_N / finger.indentation_mm;
}

double Cloth::deflection_mm(double x_mm, double y_mm, const FingerState& finger) const {
  if (finger.lifted) return 0.0;
  const double depth_mm = finger.indentation_mm;
  if (kind_ == ClothKind::ideal) return depth_mm * ideal_->at(x_mm, y_mm, finger.x_mm, finger.y_mm);
  double share = 0.0;
  for (const Part& part : parts_) {
    share += part.weight * part.table->shape(x_mm, y_mm, finger.x_mm, finger.y_mm, depth_mm);
  }
  return depth_mm * share;
}

}  // namespace fyd::sim
