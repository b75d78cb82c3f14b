// Options of `fyd bench` for the subjects that draw random runs or read recordings.
#pragma once

#include <cstdint>
#include <string>

namespace fyd::bench {

struct BenchOptions {
  int runs = 50;
  std::uint64_t seed = 1;
  std::string out;   ///< folder for what a subject writes beside its table; empty: nothing
  std::string data;  ///< folder of recordings; empty: tests/data
  std::string mesh;  ///< of scene, in mm; empty: a bumpy plane of three sizes
  std::string path;  ///< of scene, over that mesh: CSV of t_s, x_mm, y_mm, z_mm
};

[[nodiscard]] inline BenchOptions& benchOptions() {
  static BenchOptions options;
  return options;
}

/// Writes into the folder of --out, which is created; does nothing without one. @throws Failure when it cannot be
/// written
void writeBeside(const std::string& name, const std::string& text);

}  // namespace fyd::bench
