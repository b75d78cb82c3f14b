// A texture method of one's own: three axes of vibration become one signal by a mix of unequal weights. Compared with
// the program's own methods where the same vibration reaches the three axes at different times.
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "core/texture/method_bank.h"
#include "core/texture/spectral_match.h"
#include "core/texture/test_signals.h"

using namespace fyd;
using namespace fyd::texture;

// Equal weights let axes in antiphase cancel; unequal ones leave something of each. The squares of the weights add up to
// 1: three independent axes of equal energy keep it.
class UnequalMix final : public Method {
 public:
  double step(const Vec3& filtered_g) override {
    return 0.84 * filtered_g.x + 0.45 * filtered_g.y + 0.3 * filtered_g.z;
  }
  void reset() override {}                         // nothing is remembered
  int delaySamples() const override { return 0; }  // each sample leaves at once
};

int main() {
  constexpr double kRate_Hz = 1000.0;
  const auto source = bandNoise(8192, 40.0, 400.0, kRate_Hz, 1);
  const ThreeAxes axes = spread(source, {Path{0.0, 1.0}, Path{1.5, 0.8}, Path{4.0, 0.6}});

  const auto judge = [&](const char* name, Method& method) {
    std::vector<double> signal;
    signal.reserve(axes.x.size());
    for (std::size_t i = 0; i < axes.x.size(); ++i) signal.push_back(method.step({axes.x[i], axes.y[i], axes.z[i]}));
    const MatchFigures figures = compareSpectra(axes.x, axes.y, axes.z, signal, method.delaySamples(), kRate_Hz);
    fmt::print("{:<12} spectral match {:.2f}   energy {:.2f}   delay {} ms\n", name, figures.spectral_match,
               figures.energy_ratio, method.delaySamples());
  };
  UnequalMix mix;
  judge("unequal mix", mix);
  for (const auto choice : {MethodChoice::soc, MethodChoice::recolour, MethodChoice::dft321}) {
    const auto method = makeMethod(choice, kRate_Hz, 32, 16);
    if (!method) return fmt::print(stderr, "{}\n", method.error().text()), 1;
    judge(kMethodNames[static_cast<std::size_t>(choice)].data(), **method);
  }
}
