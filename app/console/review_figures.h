// What lies between the cursors A and B of a review, in figures.
#pragma once

#include <stop_token>
#include <vector>

#include "app/console/review_source.h"

namespace fyd::console {

struct StretchFigures {
  double at_a = pipeline::kNone;
  double at_b = pipeline::kNone;
  double difference = pipeline::kNone;   ///< B − A
  double slope_per_s = pipeline::kNone;  ///< of the least-squares line through every sample between
  double mean = pipeline::kNone;
  double rms = pipeline::kNone;
};

/// One for each of kReviewQuantities, from every committed sample from A to B, both included; samples without a value
/// are left out. Reads in blocks; a stop ends it early with an error.
[[nodiscard]] Result<std::vector<StretchFigures>> figuresBetween(const session::Recording& recording, double a_s,
                                                                 double b_s, const std::stop_token& stop);

}  // namespace fyd::console
