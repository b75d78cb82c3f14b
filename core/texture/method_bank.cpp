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
    const auto frame = static_cast<FrameChoice>(f);
    thesis_[f] = std::make_unique<ThesisDft321>(frameLength(frame));
    for (std::size_t h = 0; h < kHopNames.size(); ++h) {
      const int hop = hopLength(frame, static_cast<HopChoice>(h));
      framed_[f][h] = std::make_unique<Dft321>(frameLength(frame), hop, sample_rate_Hz);
    }
  }
  select({});
}

Method& MethodBank::find(const ChainChoice& choice) const {
  switch (choice.method) {
    case MethodChoice::dft321: return *framed_[index(choice.frame)][index(choice.hop)];
    case MethodChoice::dft321_thesis: return *thesis_[index(choice.frame)];
    default: return *simple_[index(choice.method)];
  }
}

void MethodBank::select(const ChainChoice& choice) {
  chain_.select(choice.filter, choice.corner_Hz, sample_rate_Hz_, find(choice));
}

}  // namespace fyd::texture
