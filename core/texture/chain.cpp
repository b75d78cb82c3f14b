#include "core/texture/chain.h"

namespace fyd::texture {

void Chain::select(FilterChoice filter, double corner_Hz, double sample_rate_Hz, Method& method) {
  filtering_ = filter != FilterChoice::none;
  filter_.setCoefficients(filter == FilterChoice::thesis ? signal::thesisHighPass()
                                                         : signal::highPass(corner_Hz, sample_rate_Hz));
  method_ = &method;
  reset();
}

void Chain::reset() {
  method_->reset();
  filter_.reset();
  filtered_g_ = {};
}

double Chain::step(const Vec3& acceleration_g, bool resumed) {
  if (resumed) filter_.settleAt(acceleration_g);
  filtered_g_ = filtering_ ? filter_.step(acceleration_g) : acceleration_g;
  return method_->step(filtered_g_);
}

double Chain::stepGap() {
  filtered_g_ = {};
  return method_->step(filtered_g_);
}

}  // namespace fyd::texture
