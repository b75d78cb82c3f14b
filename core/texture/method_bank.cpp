#include "core/texture/method_bank.h"

namespace fyd::texture {

MethodBank::MethodBank(double sample_rate_Hz)
    : sample_rate_Hz_(sample_rate_Hz),
      magnitude_(sample_rate_Hz),
      principal_(sample_rate_Hz),
      recolour_(sample_rate_Hz) {
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

void MethodBank::select(const ChainChoice& choice) {
  withMethod(choice, [&](Method& method) { chain_.select(choice.filter, choice.corner_Hz, sample_rate_Hz_, method); });
}

}  // namespace fyd::texture
