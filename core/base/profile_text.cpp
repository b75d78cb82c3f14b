#include "core/base/profile_text.h"

#include <cmath>
#include <sstream>

#include <toml++/toml.h>

namespace fyd {
namespace {

struct Assignment {
  const Parameter* parameter;
  double value = 0.0;
  ParameterList list;
  std::string text;
};

std::string place(std::string_view source, const toml::node& node) {
  return fmt::format("{}:{}", source, node.source().begin.line);
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

Result<Assignment> readAssignment(const Parameter& parameter, const toml::node& node, Ranges ranges) {
  Assignment assignment{.parameter = &parameter, .list = {}, .text = {}};
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

toml::table parseToml(std::string_view text, std::string_view source_name) { return toml::parse(text, source_name); }

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

// What describeRange says of a choice.
constexpr std::string_view kChoiceMark = "  # one of ";

std::vector<std::string> parted(std::string_view list, std::string_view by) {
  std::vector<std::string> parts;
  for (std::size_t end = list.find(by); end != std::string_view::npos; end = list.find(by)) {
    parts.emplace_back(list.substr(0, end));
    list.remove_prefix(end + by.size());
  }
  parts.emplace_back(list);
  return parts;
}

}  // namespace

std::vector<ProfileEntry> profileEntries(std::string_view text) {
  std::vector<ProfileEntry> entries;
  std::string room;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.starts_with('[') && line.ends_with(']')) {
      room = line.substr(1, line.size() - 2);
      continue;
    }
    const std::size_t equals = line.find(" = ");
    if (room.empty() || line.starts_with('#') || equals == std::string_view::npos) continue;
    const std::string_view value = line.substr(equals + 3);
    ProfileEntry entry{
        .id = fmt::format("{}.{}", room, line.substr(0, equals)), .list = value.starts_with('['), .choices = {}};
    const std::size_t choices = value.rfind(kChoiceMark);
    if (choices != std::string_view::npos) entry.choices = parted(value.substr(choices + kChoiceMark.size()), ", ");
    entries.push_back(std::move(entry));
  }
  return entries;
}

Result<void> parseProfile(std::string_view text, std::string_view source_name, std::span<const Parameter> parameters,
                          Ranges ranges) {
  toml::table root;
  try {
    root = parseToml(text, source_name);
  } catch (const toml::parse_error& error) {
    return fail(about(fmt::format("{}:{}", source_name, error.source().begin.line), verbatim(error.description())));
  }
  std::vector<Assignment> assignments;
  for (const auto& [room, node] : root) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      return fail("{}: '{}' stands outside a table; expected a table such as [control]", place(source_name, node),
                  room.str());
    }
    for (const auto& [key, value] : *table) {
      const std::string id = fmt::format("{}.{}", room.str(), key.str());
      const Parameter* parameter = findParameter(parameters, id);
      if (parameter == nullptr) {
        return fail("{}: unknown parameter '{}'; 'fyd params' lists those there are", place(source_name, value), id);
      }
      const auto assignment = readAssignment(*parameter, value, ranges);
      if (!assignment) return fail(about(place(source_name, value), assignment.error().message));
      assignments.push_back(*assignment);
    }
  }
  for (const Assignment& assignment : assignments) {
    if (assignment.parameter->kind == ParameterKind::list) {
      assignment.parameter->list() = assignment.list;
    } else if (assignment.parameter->kind == ParameterKind::text) {
      assignment.parameter->text() = assignment.text;
    } else {
      assignment.parameter->set(assignment.value);
    }
  }
  return {};
}

std::string formatProfile(std::span<const Parameter> parameters) {
  std::string out;
  std::string_view room;
  for (const Parameter& parameter : parameters) {
    const auto dot = parameter.id.find('.');
    if (parameter.id.substr(0, dot) != room) {
      room = parameter.id.substr(0, dot);
      out += fmt::format("{}[{}]\n", out.empty() ? "" : "\n", room);
    }
    std::string value = formatParameter(parameter);
    if (parameter.kind == ParameterKind::choice || parameter.kind == ParameterKind::text) value = quoted(value);
    out += fmt::format("{} = {}  # {}\n", parameter.id.substr(dot + 1), value, describeRange(parameter).text());
  }
  return out;
}

}  // namespace fyd
