// On what and by what a run was made, for the page of numbers.
#pragma once

#include <string>
#include <vector>

namespace fyd::bench {

struct Fact {
  std::string name;
  std::string value;
};

/// Date, processor, cores, memory, load, system; version, revision, compiler, build type, flags. What the system does
/// not tell is "unknown".
[[nodiscard]] std::vector<Fact> factsOfThisRun();

}  // namespace fyd::bench
