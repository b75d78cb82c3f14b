// Three components of one quantity; the unit is in the name of the variable that holds it.
// Stability: stable since 0.1
#pragma once

#include <cmath>

namespace fyd {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  [[nodiscard]] bool finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
  [[nodiscard]] double norm() const { return std::hypot(x, y, z); }
  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(x, y, z);
  }
};

}  // namespace fyd
