// Counts calls of operator new: linked into the benchmarks and into the test that no step allocates.
#pragma once

#include <cstdint>

namespace fyd::bench {

/// Counts from construction to `count()`. One at a time; allocations of every thread are counted.
class AllocationCount {
 public:
  AllocationCount();
  [[nodiscard]] std::uint64_t count() const;

 private:
  std::uint64_t start_;
};

}  // namespace fyd::bench
