// Every method at every frame, made at once, so that switching needs no memory: one bank plays while another fades in.
#pragma once

#include <array>
#include <memory>

#include "core/texture/chain.h"

namespace fyd::texture {

/// What decides which signal is made; a change of it means a crossfade.
struct ChainChoice {
  MethodChoice method = MethodChoice::dft321;
  FilterChoice filter = FilterChoice::standard;
  double corner_Hz = 78.0;
  FrameChoice frame = FrameChoice::of_32;
  HopChoice hop = HopChoice::half;

  friend bool operator==(const ChainChoice&, const ChainChoice&) = default;
};

class MethodBank {
 public:
  explicit MethodBank(double sample_rate_Hz);

  /// Starts in silence with another choice; allocation-free.
  void select(const ChainChoice& choice);
  [[nodiscard]] Chain& chain() { return chain_; }
  [[nodiscard]] const Chain& chain() const { return chain_; }

 private:
  using MethodPointer = std::unique_ptr<Method>;

  [[nodiscard]] Method& find(const ChainChoice& choice) const;

  double sample_rate_Hz_;
  std::array<MethodPointer, kMethodNames.size()> simple_;
  std::array<MethodPointer, kFrameNames.size()> thesis_;
  std::array<std::array<MethodPointer, kHopNames.size()>, kFrameNames.size()> framed_;
  Chain chain_;
};

}  // namespace fyd::texture
