// A StepRecord without the empty places of its lists: about 0.8 KB instead of 4.6. The form in which a step travels from
// the haptic loop to the recorder's thread and waits there until it is wanted.
#pragma once

#include <cstddef>
#include <span>

#include "core/recording/step_record.h"

namespace fyd::recording {

/// References to the inputs and outputs of one step; making one copies nothing.
struct StepView {
  const pipeline::Inputs& inputs;
  const pipeline::Outputs& outputs;
};

/// Bytes of a packed step whose every list is full.
inline constexpr std::size_t kLargestPackedStep = sizeof(StepRecord) + 128;

/// @param out at least kLargestPackedStep bytes
/// @return bytes used
[[nodiscard]] std::size_t packStep(const StepView& step, std::span<std::byte> out) noexcept;

/// Bytes of the packed step that begins here; 0 when not even its head is complete.
[[nodiscard]] std::size_t packedSize(std::span<const std::byte> packed) noexcept;
/// Bytes of the head, which `packedSize` needs.
[[nodiscard]] std::size_t packedHeadSize() noexcept;

/// Items of `out`'s lists beyond their count stay as they were. @param packed one whole packed step
void unpackStep(std::span<const std::byte> packed, StepRecord& out) noexcept;

}  // namespace fyd::recording
