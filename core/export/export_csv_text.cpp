#include "core/export/export_csv_text.h"

#include <csv.h>

#include <array>
#include <charconv>
#include <cmath>

namespace fyd::exports {

void appendNumber(std::string& line, double value) {
  if (std::isnan(value)) {  // to_chars would write the sign of a NaN
    line += "nan";
    return;
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  line.append(digits.data(), end);
}

void appendText(std::string& line, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    line += text;
    return;
  }
  std::string quoted(2 * text.size() + 2, '\0');
  quoted.resize(csv_write(quoted.data(), quoted.size(), text.data(), text.size()));
  line += quoted;
}

std::string columnTitle(const pipeline::TelemetryField& field) {
  return fmt::format("{} [{}]", field.name, field.unit);
}

void appendRow(std::string& line, const pipeline::TelemetrySample& sample,
               std::span<const pipeline::TelemetryField* const> fields) {
  bool first = true;
  for (const pipeline::TelemetryField* field : fields) {
    if (!first) line += ',';
    first = false;
    appendNumber(line, field->read(sample));
  }
}

}  // namespace fyd::exports
