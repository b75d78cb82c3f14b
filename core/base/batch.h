// A small list without an allocation, trivially copyable when its items are: inputs of the step are made of these.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/state.h"

namespace fyd {

template <class T, std::size_t Capacity>
struct Batch {
  std::array<T, Capacity> items{};
  std::uint32_t count = 0;

  static constexpr std::size_t capacity() { return Capacity; }
  [[nodiscard]] bool empty() const { return count == 0; }
  [[nodiscard]] bool full() const { return count == Capacity; }
  [[nodiscard]] std::size_t size() const { return count; }

  /// @return false, and nothing stored, when the batch is full: the caller counts the loss.
  [[nodiscard]] bool push(const T& item) {
    if (full()) return false;
    items[count++] = item;
    return true;
  }
  void clear() { count = 0; }

  [[nodiscard]] std::span<const T> view() const { return {items.data(), count}; }
  [[nodiscard]] std::span<T> view() { return {items.data(), count}; }
  [[nodiscard]] const T* begin() const { return items.data(); }
  [[nodiscard]] const T* end() const { return items.data() + count; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return items[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return items[i]; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(items, within(count, Capacity));
  }
};

}  // namespace fyd
