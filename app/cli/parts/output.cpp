#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/parts/command.h"
#include "app/cli/parts/terminal_text.h"
#include "core/base/csv.h"
#include "core/base/whole_file.h"

namespace fyd::cli {

nlohmann::ordered_json jsonNumber(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value;
}

std::string textOf(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

namespace {

std::optional<nlohmann::ordered_json> document;  // NOLINT: one process, one document

nlohmann::ordered_json partsOf(const Message& message);

nlohmann::ordered_json partsOf(const Value& value) {
  return std::visit(
      [](const auto& is) -> nlohmann::ordered_json {
        using Is = std::remove_cvref_t<decltype(is)>;
        if constexpr (std::is_same_v<Is, Message>) return partsOf(is);
        if constexpr (std::is_same_v<Is, double>) return jsonNumber(is);
        if constexpr (!std::is_same_v<Is, Message> && !std::is_same_v<Is, double>) return is;
      },
      value.is);
}

nlohmann::ordered_json partsOf(const Message& message) {
  auto values = nlohmann::ordered_json::array();
  for (const Value& value : message.values) values.push_back(partsOf(value));
  return {{"kind", toString(message.kind)}, {"format", message.format}, {"values", values}, {"text", message.text()}};
}

using Lines = std::vector<std::pair<std::string, std::string>>;

void addLines(const nlohmann::ordered_json& object, const std::string& prefix, Lines& lines) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      addLines(value, prefix + key + ".", lines);
    } else {
      lines.emplace_back(forTerminal(prefix + key), forTerminal(textOf(value)));
    }
  }
}

}  // namespace

void printJson(const nlohmann::ordered_json& json) { document = json; }

void printValues(const nlohmann::ordered_json& object, bool as_json) {
  if (as_json) return printJson(object);
  Lines lines;
  addLines(object, "", lines);
  std::size_t widest = 0;
  for (const auto& [name, value] : lines) widest = std::max(widest, name.size());
  for (const auto& [name, value] : lines) std::cout << fmt::format("{:<{}}  {}\n", name, widest, value);
}

void printErrorJson(const Message& message) {
  if (!document) {
    document = nlohmann::ordered_json::object();
  } else if (!document->is_object()) {
    document = nlohmann::ordered_json{{"result", *document}};
  }
  (*document)["error"] = partsOf(message);
}

bool flushOutput() {
  // Names of files and devices may be invalid UTF-8.
  if (document) std::cout << document->dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  document.reset();
  return static_cast<bool>(std::cout.flush());
}

std::string readTextFile(const std::string& path) {
  return valueOrFail(readWholeFile(path, kLargestWholeFile_bytes, FileKind::pipe_too));
}

std::string readCsvText(const std::string& path) {
  return valueOrFail(readWholeFile(path, kLargestCsv_bytes, FileKind::pipe_too));
}

}  // namespace fyd::cli
