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

CLI::Option* addWords(CLI::App& command, const std::string& name, std::vector<std::string>& into,
                      const std::string& help) {
  // Not by CLI11's delimiter, which leaves empty words out in silence.
  const auto split = [&into](const std::vector<std::string>& values) {
    into.clear();
    for (const std::string& value : values) {
      for (const std::string& word : CLI::detail::split(value, ',')) into.push_back(word);
    }
  };
  return command.add_option_function<std::vector<std::string>>(name, split, help)->check([](const std::string& value) {
    const bool gap = value.starts_with(',') || value.ends_with(',') || value.find(",,") != std::string::npos;
    return gap ? fmt::format("{}: expected a word before and after each comma", value) : std::string();
  });
}

}  // namespace fyd::cli
