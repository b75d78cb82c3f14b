#include "core/texture/method.h"

#include "core/texture/dft321.h"
#include "core/texture/mixing_methods.h"

namespace fyd::texture {
namespace {

Result<void> checkFrame(MethodChoice choice, int frame, int hop) {
  if (choice != MethodChoice::dft321 && choice != MethodChoice::dft321_thesis) return {};
  if (frame < 2 || frame > kMaximumFrame) return fail("frame = {}: expected 2 … {} samples", frame, kMaximumFrame);
  if (choice == MethodChoice::dft321_thesis) return {};
  if (hop >= 1 && hop <= frame && frame % hop == 0) return {};
  return fail("hop = {}: expected a divisor of the frame, {} (blocks) or less (overlapped)", hop, frame);
}

}  // namespace

Result<std::unique_ptr<Method>> makeMethod(MethodChoice choice, double sample_rate_Hz, int frame, int hop) {
  if (auto checked = checkFrame(choice, frame, hop); !checked) return tl::unexpected(checked.error());
  switch (choice) {
    case MethodChoice::single: return std::make_unique<SingleAxis>();
    case MethodChoice::soc: return std::make_unique<SumOfComponents>();
    case MethodChoice::magnitude: return std::make_unique<Magnitude>(sample_rate_Hz);
    case MethodChoice::principal: return std::make_unique<PrincipalAxis>(sample_rate_Hz);
    case MethodChoice::dft321: return std::make_unique<Dft321>(frame, hop, sample_rate_Hz);
    case MethodChoice::dft321_thesis: return std::make_unique<ThesisDft321>(frame);
    case MethodChoice::recolour: return std::make_unique<Recolour>(sample_rate_Hz);
  }
  return fail("method number {}: unknown", static_cast<int>(choice));
}

}  // namespace fyd::texture
