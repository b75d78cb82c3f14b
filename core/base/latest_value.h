// Latest-value slot between one writer and one reader thread (triple buffer): wait-free on both sides,
// the reader always gets the newest complete value, values in between are skipped.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fyd {

template <class T>
class LatestValue {
 public:
  /// Writer's side.
  void write(const T& value) {
    slots_[back_] = value;
    back_ = shared_.exchange(static_cast<std::uint8_t>(back_ | kNew), std::memory_order_acq_rel) & kIndex;
  }

  /// Reader's side. The reference stays valid until the next call.
  [[nodiscard]] const T& read() {
    if ((shared_.load(std::memory_order_relaxed) & kNew) != 0) {
      front_ = shared_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    }
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kNew = 4;

  std::array<T, 3> slots_{};
  std::uint8_t back_ = 0;                // writer's own
  std::atomic<std::uint8_t> shared_{1};  // handed over, with the mark kNew
  std::uint8_t front_ = 2;               // reader's own
};

}  // namespace fyd
