// Options of `fyd bench` for the subjects that draw random runs, read recordings or take long.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace fyd::bench {

struct BenchOptions {
  int runs = 50;
  std::uint64_t seed = 1;
  bool quick = false;  ///< a small part of each subject: its figures only show that it works
  std::string out;     ///< folder for what a subject writes beside its table; empty: nothing
  std::string data;    ///< folder of recordings; empty: tests/data
  std::string mesh;    ///< of scene, in mm; empty: a bumpy plane of three sizes
  std::string path;    ///< of scene, over that mesh: CSV of t_s, x_mm, y_mm, z_mm
};

[[nodiscard]] inline BenchOptions& benchOptions() {
  static BenchOptions options;
  return options;
}

/// `whole`, and `short_one` with --quick.
template <class T>
[[nodiscard]] T wholeOrQuick(T whole, T short_one) {
  return benchOptions().quick ? short_one : whole;
}
/// The beginning of a list with --quick.
template <class List>
[[nodiscard]] List wholeOrFirst(List whole, std::size_t first) {
  if (benchOptions().quick && whole.size() > first) {
    whole.erase(whole.begin() + static_cast<std::ptrdiff_t>(first), whole.end());
  }
  return whole;
}

/// Creates the folder of --out: before anything is measured. @throws Failure when nothing can be written there
void makeOut();
/// Writes into that folder; does nothing without one. @throws Failure when it cannot be written
void writeBeside(const std::string& name, const std::string& text);

}  // namespace fyd::bench
