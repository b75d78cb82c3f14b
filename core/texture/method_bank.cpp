#include "core/texture/method_bank.h"

#include "core/texture/dft321.h"
#include "core/texture/mixing_methods.h"

namespace fyd::texture {
namespace {

template <class Enum>
std::size_t index(Enum value) {
  return static_cast<std::size_t>(value);
}

}  // namespace

MethodBank::MethodBank(double sample_rate_Hz) : sample_rate_Hz_(sample_rate_Hz) {
  simple_[index(MethodChoice::single)] = std::make_unique<SingleAxis>();
  simple_[index(MethodChoice::soc)] = std::make_unique<SumOfComponents>();
  simple_[index(MethodChoice::magnitude)] = std::make_unique<Magnitude>(sample_rate_Hz);
  simple_[index(MethodChoice::principal)] = std::make_unique<PrincipalAxis>(sample_rate_Hz);
  simple_[index(MethodChoice::recolour)] = std::make_unique<Recolour>(sample_rate_Hz);
  for (std::size_t f = 0; f < kFrameNames.size(); ++f) {
    const int frame = frameLength(static_cast<FrameChoice>(f));
    thesis_[f] = std::make_unique<ThesisDft321>(frame);
    for (std::size_t h = 0; h < kHopNames.size(); ++h) {
      framed_[f][h] = std::make_unique<Dft321>(frame, frame >> h, sample_rate_Hz);
    }
  }
  select({});
}

void MethodBank::select(const ChainChoice& choice) {
  filtering_ = choice.filter != FilterChoice::none;
  filter_.setCoefficients(choice.filter == FilterChoice::thesis ? signal::thesisHighPass()
                                                                : signal::highPass(choice.corner_Hz, sample_rate_Hz_));
  switch (choice.method) {
    case MethodChoice::dft321: method_ = framed_[index(choice.frame)][index(choice.hop)].get(); break;
    case MethodChoice::dft321_thesis: method_ = thesis_[index(choice.frame)].get(); break;
    default: method_ = simple_[index(choice.method)].get(); break;
  }
  reset();
}

void MethodBank::reset() {
  method_->reset();
  filter_.reset();
  filtered_g_ = {};
}

double MethodBank::step(const Vec3& acceleration_g, bool resumed) {
  if (resumed) filter_.settleAt(acceleration_g);
  filtered_g_ = filtering_ ? filter_.step(acceleration_g) : acceleration_g;
  return method_->step(filtered_g_);
}

double MethodBank::stepGap() {
  filtered_g_ = {};
  return method_->step(filtered_g_);
}

}  // namespace fyd::texture
