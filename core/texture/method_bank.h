// Every method at every frame, made at construction, so that switching allocates nothing: one bank plays while another
// fades in.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <memory>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/texture/chain.h"
#include "core/texture/dft321.h"
#include "core/texture/mixing_methods.h"

namespace fyd::texture {

/// What decides which signal is made; a change of it means a crossfade.
struct ChainChoice {
  MethodChoice method = MethodChoice::dft321;
  FilterChoice filter = FilterChoice::standard;
  double corner_Hz = 78.0;
  FrameChoice frame = FrameChoice::of_32;
  HopChoice hop = HopChoice::half;

  friend bool operator==(const ChainChoice&, const ChainChoice&) = default;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(within(method, kMethodNames.size() - 1), within(filter, kFilterNames.size() - 1), corner_Hz,
            within(frame, kFrameNames.size() - 1), within(hop, kHopNames.size() - 1));
  }
};

class FYD_API MethodBank {
 public:
  explicit MethodBank(double sample_rate_Hz);
  MethodBank(const MethodBank&) = delete;  // the chain points to the methods
  MethodBank& operator=(const MethodBank&) = delete;

  /// Starts in silence with another choice; allocation-free.
  void select(const ChainChoice& choice);
  [[nodiscard]] Chain& chain() { return chain_; }
  [[nodiscard]] const Chain& chain() const { return chain_; }

  /// Saves or restores chain and method while `choice` is selected; the other methods have no state that matters.
  template <class Archive>
  void exchange(Archive& archive, const ChainChoice& choice) {
    if constexpr (Archive::is_loading::value) select(choice);
    archive(chain_);
    withMethod(choice, [&archive](auto& method) { archive(method); });
  }

 private:
  template <class Visitor>
  void withMethod(const ChainChoice& choice, Visitor&& visit) {
    const auto frame = static_cast<std::size_t>(choice.frame);
    switch (choice.method) {
      case MethodChoice::single: return visit(single_);
      case MethodChoice::soc: return visit(sum_);
      case MethodChoice::magnitude: return visit(magnitude_);
      case MethodChoice::principal: return visit(principal_);
      case MethodChoice::recolour: return visit(recolour_);
      case MethodChoice::dft321: return visit(*framed_[frame][static_cast<std::size_t>(choice.hop)]);
      case MethodChoice::dft321_thesis: return visit(*thesis_[frame]);
    }
  }

  double sample_rate_Hz_;
  SingleAxis single_;
  SumOfComponents sum_;
  Magnitude magnitude_;
  PrincipalAxis principal_;
  Recolour recolour_;
  std::array<std::unique_ptr<ThesisDft321>, kFrameNames.size()> thesis_;
  std::array<std::array<std::unique_ptr<Dft321>, kHopNames.size()>, kFrameNames.size()> framed_;
  Chain chain_;
};

/// @return the error of makeMethod
[[nodiscard]] FYD_API Result<void> checkFrame(MethodChoice choice, int frame, int hop);

/// Makes any method with any frame, for programs and tests; the renderer makes its own set.
/// @param frame  of dft321 and dft321_thesis: 2…4096 samples
/// @param hop    of dft321: the frame (blocks) or a smaller divisor of it (overlapped)
/// @return an error that says what of frame and hop was refused, or that the rate is none
[[nodiscard]] FYD_API Result<std::unique_ptr<Method>> makeMethod(MethodChoice choice, double sample_rate_Hz, int frame,
                                                                 int hop);

}  // namespace fyd::texture
