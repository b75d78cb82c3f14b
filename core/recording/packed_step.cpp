#include "core/recording/packed_step.h"

#include <cstring>
#include <type_traits>

namespace fyd::recording {
namespace {

using Size = std::uint32_t;  // of the whole packed step, before everything else

/// Calls visit for each part of a step, a list or a plain value, always in the same order.
template <class Inputs, class Motors, class Telemetry, class Events, class Visit>
void eachPart(Inputs& inputs, Motors& motors, Telemetry& telemetry, Events& events, Visit&& visit) {
  forEachField<pipeline::Inputs>([&](auto, const auto& field) { visit(field.of(inputs)); });
  forEachOf(pipeline::Inputs::tables(), [&](auto, const auto& table) { visit(table.of(inputs)); });
  visit(motors);
  visit(telemetry);
  visit(events);
}

struct Packer {
  std::byte* to;
  template <class T>
  void operator()(const T& value) {
    copy(&value, 1);
  }
  template <class T, std::size_t Capacity>
  void operator()(const Batch<T, Capacity>& list) {
    copy(&list.count, 1);
    copy(list.items.data(), list.size());
  }
  template <class T>
  void copy(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(to, values, count * sizeof(T));
    to += count * sizeof(T);
  }
};

struct Unpacker {
  const std::byte* from;
  template <class T>
  void operator()(T& value) {
    copy(&value, 1);
  }
  template <class T, std::size_t Capacity>
  void operator()(Batch<T, Capacity>& list) {
    copy(&list.count, 1);
    copy(list.items.data(), list.size());
  }
  template <class T>
  void copy(T* values, std::size_t count) {
    std::memcpy(values, from, count * sizeof(T));
    from += count * sizeof(T);
  }
};

}  // namespace

std::size_t packStep(const StepView& step, std::span<std::byte> out) noexcept {
  Packer packer{out.data() + sizeof(Size)};
  eachPart(step.inputs, step.outputs.motors, step.outputs.telemetry, step.outputs.events, packer);
  const auto bytes = static_cast<Size>(packer.to - out.data());
  std::memcpy(out.data(), &bytes, sizeof bytes);
  return bytes;
}

std::size_t packedHeadSize() noexcept { return sizeof(Size); }

std::size_t packedSize(std::span<const std::byte> packed) noexcept {
  if (packed.size() < sizeof(Size)) return 0;
  Size bytes = 0;
  std::memcpy(&bytes, packed.data(), sizeof bytes);
  return bytes;
}

void unpackStep(std::span<const std::byte> packed, StepRecord& out) noexcept {
  eachPart(out.inputs, out.motors, out.telemetry, out.events, Unpacker{packed.data() + sizeof(Size)});
}

}  // namespace fyd::recording
