#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>

#include "app/cli/command.h"

namespace fyd::cli {

nlohmann::ordered_json jsonNumber(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value;
}

void printJson(const nlohmann::ordered_json& json) { std::cout << json.dump(2) << '\n'; }

std::string readTextFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Failure(fmt::format("{}: cannot be opened for reading", path));
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace fyd::cli
