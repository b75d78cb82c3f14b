#include "core/base/toml_parameters.h"

namespace fyd {
namespace {

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
