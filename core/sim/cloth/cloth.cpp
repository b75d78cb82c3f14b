#include "core/sim/cloth/cloth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/sim/cloth/cloth_tables.h"
#include "core/sim/cloth/ideal_shape.h"

namespace fyd::sim {
namespace {

constexpr double kReferenceDepth_mm = 3.0;

constexpr double kSlackest = 1.0 / 3.0;

/// Read when the first cloth that needs it is made, for all of them.
const ClothTable& tableOf(ClothKind cloth, FingerKind finger) {
  constexpr std::array<std::string_view, 3> kEdges{"", "frame", "rollers"};
  constexpr std::array<std::string_view, kFingerNames.size()> kFingers{"sphere8", "capsule8", "disc7"};
  struct Entry {
    std::once_flag once;
    std::optional<ClothTable> table;
  };
  static std::array<Entry, kEdges.size() * kFingers.size()> tables;
  const auto edges = static_cast<std::size_t>(cloth), shape = static_cast<std::size_t>(finger);
  Entry& entry = tables.at(edges * kFingers.size() + shape);
  std::call_once(entry.once, [&] {
    auto parsed = ClothTable::parse(clothTableText(fmt::format("{}_{}", kEdges.at(edges), kFingers.at(shape))));
    if (!parsed) throw std::runtime_error(parsed.error().text());
    entry.table = std::move(*parsed);
  });
  return *entry.table;
}

}  // namespace

Cloth::Cloth(const SimParameters& parameters)
    : kind_(parameters.cloth),
      law_(parameters.cloth_stiffness_scale, parameters.cloth_hysteresis),
      scale_(parameters.cloth_stiffness_scale),
      slackens_per_s_(parameters.cloth_slackens_percent_per_min / 100.0 / 60.0),
      viscosity_s_(1e-3 * parameters.cloth_viscosity_ms) {
  if (kind_ == ClothKind::ideal) {
    ideal_ = std::make_shared<const IdealShape>();
  } else {
    table_ = &tableOf(parameters.cloth, parameters.finger);
  }
}

Pressing Cloth::atRest(double angle_deg, double x_mm, double y_mm, double depth_mm) const {
  Pressing out = table_->press(x_mm, y_mm, depth_mm, nominalStiffness(angle_deg));
  out.force_N *= scale_ * left_;
  return out;
}

Pressing Cloth::press(double angle_deg, const FingerState& finger, double elapsed_s) {
  const double depth_mm = finger.indentation_mm;
  const double speed_mm_s = elapsed_s > 0.0 ? (depth_mm - last_mm_) / elapsed_s : 0.0;
  last_mm_ = depth_mm > 0.0 ? depth_mm : 0.0;
  if (elapsed_s > 0.0) left_ = std::max(kSlackest, left_ - slackens_per_s_ * elapsed_s);
  Pressing out;
  if (kind_ == ClothKind::ideal) {
    out.force_N = left_ * law_.press(angle_deg, depth_mm);
  } else {
    const double loop = law_.loop(depth_mm);
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
  if (kind_ == ClothKind::ideal) return left_ * law_.stiffness(angle_deg);
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
