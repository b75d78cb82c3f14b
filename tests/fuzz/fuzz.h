// What the fuzz targets share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fyd::fuzz {

/// What must hold whatever comes in; a violation ends the program, which every fuzzer understands.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Cuts one input into the parts of a sequence: numbers and datagrams.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  /// As many bytes as the next one says.
  std::span<const std::uint8_t> bytes() {
    std::size_t size = byte();
    size = std::min(size, rest_.size());
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace fyd::fuzz
