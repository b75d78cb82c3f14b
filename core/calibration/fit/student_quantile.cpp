// Student's t, in a file of its own because Boost's distributions take long to compile.
#include "core/calibration/fit/student_quantile.h"

#include <limits>

#include <boost/math/distributions/students_t.hpp>

namespace fyd::calibration {
namespace {

/// Computed in double throughout: sixteen digits are enough, and the long double code is not compiled.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace

double studentQuantile(double probability, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) return std::numeric_limits<double>::infinity();
  const boost::math::students_t_distribution<double, InDouble> t(static_cast<double>(degrees_of_freedom));
  return boost::math::quantile(boost::math::complement(t, 0.5 * (1 - probability)));
}

}  // namespace fyd::calibration
