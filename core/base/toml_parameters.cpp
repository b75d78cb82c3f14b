#include "core/base/toml_parameters.h"

#include <algorithm>

namespace fyd {
namespace {

/// Line of the first key of more than kMostKeyParts, 0 when there is none. Right up to the place where the text is no
/// longer TOML.
std::size_t lineOfTooDeepKey(std::string_view text) {
  std::size_t line = 1, dots = 0, i = 0;
  std::string_view quotes;  // of the string around this place
  while (i < text.size()) {
    const std::string_view rest = text.substr(i);
    const char c = rest.front();
    if (c == '\n') ++line;
    if (!quotes.empty()) {
      const bool escaped = c == '\\' && quotes.front() == '"' && rest.size() > 1 && rest[1] != '\n';
      const bool closed = rest.starts_with(quotes) || (quotes.size() == 1 && c == '\n');
      const char quote = quotes.front();
      i += escaped ? 2 : (closed ? (c == '\n' ? 1 : quotes.size()) : 1);
      if (!closed) continue;
      // A text in three quotes may end with one or two of them.
      for (int more = 0; quotes.size() == 3 && more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
      quotes = {};
    } else if (c == '"' || c == '\'') {
      quotes = rest.substr(0, rest.size() >= 3 && rest[1] == c && rest[2] == c ? 3 : 1);
      i += quotes.size();
    } else if (c == '#') {
      i += std::min(rest.find('\n'), rest.size());
    } else {
      if (c == '.') {
        if (++dots >= kMostKeyParts) return line;
      } else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) {
        dots = 0;
      }
      ++i;
    }
  }
  return 0;
}

Result<double> readNumber(const Parameter& parameter, const toml::node& node, Ranges ranges) {
  if (parameter.kind == ParameterKind::boolean) {
    if (const auto value = node.value_exact<bool>()) return *value ? 1.0 : 0.0;
    return fail("{}: expected true or false", parameter.id);
  }
  if (parameter.kind == ParameterKind::choice) {
    if (const auto value = node.value_exact<std::string>()) {
      for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        if (parameter.choices[i] == *value) return static_cast<double>(i);
      }
      return fail("{} = \"{}\": expected {}", parameter.id, *value, describeRange(parameter));
    }
    return fail("{}: expected {}", parameter.id, describeRange(parameter));
  }
  if (const auto value = node.value_exact<std::int64_t>())
    return checkParameter(parameter, static_cast<double>(*value), ranges);
  if (const auto value = node.value_exact<double>()) return checkParameter(parameter, *value, ranges);
  return fail("{}: expected {}", parameter.id, describeRange(parameter));
}

Result<TomlAssignment> readAssignment(const Parameter& parameter, const toml::node& node, Ranges ranges) {
  TomlAssignment assignment{.parameter = &parameter, .list = {}, .text = {}};
  if (parameter.kind == ParameterKind::text) {
    const auto text = node.value_exact<std::string>();
    if (!text) return fail("{}: expected {}, in quotes", parameter.id, describeRange(parameter));
    auto checked = checkText(parameter, *text);
    if (!checked) return tl::unexpected(checked.error());
    assignment.text = std::move(*checked);
    return assignment;
  }
  if (parameter.kind != ParameterKind::list) {
    const auto value = readNumber(parameter, node, ranges);
    if (!value) return tl::unexpected(value.error());
    assignment.value = *value;
    return assignment;
  }
  const toml::array* array = node.as_array();
  if (array == nullptr) return fail("{}: expected {}", parameter.id, describeRange(parameter));
  for (const toml::node& item : *array) {
    const auto value = readNumber(parameter, item, ranges);
    if (!value) return tl::unexpected(value.error());
    if (!assignment.list.push(*value)) return fail("{}: at most {} values", parameter.id, kParameterListCapacity);
  }
  return assignment;
}

}  // namespace

Result<toml::table> parseToml(std::string_view text, std::string_view source_name) {
  if (const std::size_t line = lineOfTooDeepKey(text); line != 0) {
    return fail("{}:{}: a key of more than {} parts; expected a table and a name", source_name, line, kMostKeyParts);
  }
  try {
    return static_cast<toml::table>(toml::parse(text, source_name));
  } catch (const toml::parse_error& error) {
    return fail(about(fmt::format("{}:{}", source_name, error.source().begin.line), verbatim(error.description())));
  }
}

std::string place(std::string_view source_name, const toml::node& node) {
  return fmt::format("{}:{}", source_name, node.source().begin.line);
}

void TomlAssignment::store() const {
  if (parameter->kind == ParameterKind::list) {
    parameter->list() = list;
  } else if (parameter->kind == ParameterKind::text) {
    parameter->text() = text;
  } else {
    parameter->set(value);
  }
}

Result<void> readTable(const toml::table& table, std::string_view module, std::string_view source_name,
                       std::span<const Parameter> parameters, Ranges ranges, std::string_view listed_by,
                       std::vector<TomlAssignment>& read) {
  for (const auto& [key, value] : table) {
    const std::string id = fmt::format("{}.{}", module, key.str());
    const Parameter* parameter = findParameter(parameters, id);
    if (parameter == nullptr) {
      return fail("{}: unknown parameter '{}'; '{}' lists those there are", place(source_name, value), id, listed_by);
    }
    const auto assignment = readAssignment(*parameter, value, ranges);
    if (!assignment) return fail(about(place(source_name, value), assignment.error().message));
    read.push_back(*assignment);
  }
  return {};
}

}  // namespace fyd
