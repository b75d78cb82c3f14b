#include <fmt/format.h>

#include "app/cli/parts/command.h"

namespace fyd::cli {

CLI::Validator numberFrom(double least, double most) {
  return CLI::Validator(
      [least, most](const std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return std::string();
        return fmt::format("{}: expected a number from {:g} to {:g}", text, least, most);
      },
      fmt::format("FLOAT in [{:g} - {:g}]", least, most));
}

}  // namespace fyd::cli
