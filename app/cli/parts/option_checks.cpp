#include <charconv>

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

CLI::Validator wholeNumberFrom(std::int64_t least, std::int64_t most) {
  return CLI::Validator(
      [least, most](std::string& text) {
        std::int64_t value = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (problem != std::errc() || end != text.data() + text.size() || value < least || value > most) {
          return fmt::format("{}: expected a whole number from {} to {}", text, least, most);
        }
        text = fmt::format("{}", value);  // without the zeros that would make it octal
        return std::string();
      },
      fmt::format("INT in [{} - {}]", least, most));
}

}  // namespace fyd::cli
