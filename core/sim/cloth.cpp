#include "core/sim/cloth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/sim/cloth_tables.h"
#include "core/sim/ideal_shape.h"

namespace fyd::sim {
namespace {

constexpr double kReferenceDepth_mm = 3.0;

/// Read when the first membrane is made, for all of them.
const ClothTable& membraneTable() {
  static const ClothTable kTable = [] {
    auto parsed = ClothTable::parse(clothTableText("frame_sphere8"));
    if (!parsed) throw std::runtime_error(parsed.error().text());
    return std::move(*parsed);
  }();
  return kTable;
}

}  // namespace

Cloth::Cloth(const SimParameters& parameters)
    : kind_(parameters.cloth),
      fabric_(parameters.fabric_stiffness_scale, parameters.fabric_hysteresis),
      scale_(parameters.fabric_stiffness_scale),
      viscosity_s_(1e-3 * parameters.fabric_viscosity_ms) {
  if (kind_ == ClothKind::ideal) {
    ideal_ = std::make_shared<const IdealShape>();
  } else {
    table_ = &membraneTable();
  }
}

Pressing Cloth::atRest(double angle_deg, double x_mm, double y_mm, double depth_mm) const {
  Pressing out = table_->press(x_mm, y_mm, depth_mm, fabricStiffness(angle_deg));
  out.force_N *= scale_;
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
  return depth_mm * table_->shape(x_mm, y_mm, finger.x_mm, finger.y_mm, depth_mm);
}

}  // namespace fyd::sim
