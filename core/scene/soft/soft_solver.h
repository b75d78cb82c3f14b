// Conjugate gradients for the points of a soft body that are awake: four right sides at once, as the displacement's
// three components and the response to a press share one matrix.
// Stability: may change
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/api.h"

namespace fyd::scene {

/// Symmetric sparse matrix of the whole body: the diagonal, and the other entries row by row.
struct SoftMatrix {
  std::vector<double> diagonal;
  std::vector<std::uint32_t> first;  ///< of each row, and the end
  std::vector<std::uint32_t> column;
  std::vector<double> value;
};

/// Its alignment must not depend on how a caller is compiled: scenes are copied there, and -march=native would otherwise
/// make it more than the library's.
using Four = Eigen::Array<double, 4, 1, Eigen::DontAlign>;
static_assert(alignof(Four) == alignof(double));

class FYD_API SoftSolver {
 public:
  explicit SoftSolver(std::size_t points);

  /// Solves (diag(d) + scale·K)·x = b on the rows `awake`; x is 0 elsewhere and must be so when passed in. x holds the
  /// initial guess. Ends where a residual is `tolerance` of b, or of `least` where that is more (both in the norm of
  /// the inverse diagonal; `least` squared), or after 400 iterations. @return iterations
  int solve(const SoftMatrix& stiffness, double scale, std::span<const double> d, std::span<const std::uint32_t> awake,
            std::span<const Four> b, std::span<Four> x, double tolerance, const Four& least);

 private:
  std::vector<Four> r_, p_, q_;  // of the whole body; p_ is 0 at points that sleep
};

}  // namespace fyd::scene
