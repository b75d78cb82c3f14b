// Figures of the time between the marks A and B of a review.
#pragma once

#include <vector>

#include "app/console/review/review_source.h"
#include "core/recording/progress.h"

namespace fyd::console {

struct StretchFigures {
  double at_a = pipeline::kNone;
  double at_b = pipeline::kNone;
  double difference = pipeline::kNone;   ///< B − A
  double slope_per_s = pipeline::kNone;  ///< of the least-squares line through every sample between
  double mean = pipeline::kNone;
  double rms = pipeline::kNone;
};

/// One for each of kReviewQuantities, from every committed sample between A and B, both included and either first;
/// samples without a value are left out. Reads in blocks; returns an error when `progress` cancels it.
[[nodiscard]] Result<std::vector<StretchFigures>> figuresBetween(const recording::Recording& recording, double a_s,
                                                                 double b_s, const recording::Progress& progress);

}  // namespace fyd::console
