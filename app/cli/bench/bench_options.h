// What `fyd bench` hands to the subjects that draw runs of their own or read recordings.
#pragma once

#include <cstdint>
#include <string>

namespace fyd::bench {

struct BenchOptions {
  int runs = 50;
  std::uint64_t seed = 1;
  std::string out;   ///< folder for what a subject writes beside its table; empty: nothing
  std::string data;  ///< folder of recordings; empty: tests/data
};

[[nodiscard]] inline BenchOptions& benchOptions() {
  static BenchOptions options;
  return options;
}

}  // namespace fyd::bench
