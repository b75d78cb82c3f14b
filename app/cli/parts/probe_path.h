// Paths of a haptic point as CSV: t_s, x_mm, y_mm, z_mm.
#pragma once

#include <string>
#include <vector>

#include "core/base/vec3.h"

namespace fyd::cli {

struct ProbePath {
  std::vector<double> time_s;
  std::vector<Vec3> probe_mm;
};

/// @throws Failure that names the file and the line: a time that does not increase, a position that is not a number
[[nodiscard]] ProbePath readProbePath(const std::string& file);

}  // namespace fyd::cli
