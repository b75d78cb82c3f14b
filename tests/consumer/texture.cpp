// DFT321 makes one signal of three axes. Truth: the energy of a block is that of the three axes in it, summed over the
// samples; nothing here knows a Fourier transform.
#include <core/texture/method_bank.h>

#include <numbers>
#include <vector>

#include "expect.h"

int main() {
  constexpr int kFrame = 64, kFrames = 50;
  constexpr double kRate_Hz = 1000.0;
  auto method = fyd::texture::makeMethod(fyd::texture::MethodChoice::dft321, kRate_Hz, kFrame, kFrame);
  expect("a method", method.has_value());

  std::vector<double> in(kFrame * kFrames), out;
  for (int i = 0; i < kFrame * kFrames + (*method)->delaySamples(); ++i) {
    const double t_s = i / kRate_Hz;
    const fyd::Vec3 g{std::sin(2 * std::numbers::pi * 81 * t_s), 0.5 * std::sin(2 * std::numbers::pi * 203 * t_s + 1),
                      0.25 * std::sin(2 * std::numbers::pi * 317 * t_s * t_s)};
    if (i < kFrame * kFrames) in[static_cast<std::size_t>(i)] = g.x * g.x + g.y * g.y + g.z * g.z;
    const double signal_g = (*method)->step(g);
    if (i >= (*method)->delaySamples()) out.push_back(signal_g * signal_g);
  }
  for (std::size_t block = 0; block < kFrames; ++block) {
    double axes = 0.0, one = 0.0;
    for (std::size_t i = block * kFrame; i < (block + 1) * kFrame; ++i) axes += in[i], one += out[i];
    expectNear("energy of a block, g²", one, axes, 1e-9 * axes);
  }

  const auto refused = fyd::texture::makeMethod(fyd::texture::MethodChoice::dft321, kRate_Hz, 64, 48);
  expect("an error that names the hop", !refused && refused.error().text().find("48") != std::string::npos);
}
