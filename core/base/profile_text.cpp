#include "core/base/profile_text.h"

#include <sstream>

#include "core/base/toml_parameters.h"

namespace fyd {
namespace {

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
  std::string module;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.starts_with('[') && line.ends_with(']')) {
      module = line.substr(1, line.size() - 2);
      continue;
    }
    const std::size_t equals = line.find(" = ");
    if (module.empty() || line.starts_with('#') || equals == std::string_view::npos) continue;
    const std::string_view value = line.substr(equals + 3);
    ProfileEntry entry{
        .id = fmt::format("{}.{}", module, line.substr(0, equals)), .list = value.starts_with('['), .choices = {}};
    const std::size_t choices = value.rfind(kChoiceMark);
    if (choices != std::string_view::npos) entry.choices = parted(value.substr(choices + kChoiceMark.size()), ", ");
    entries.push_back(std::move(entry));
  }
  return entries;
}

Result<void> parseProfile(std::string_view text, std::string_view source_name, std::span<const Parameter> parameters,
                          Ranges ranges) {
  const auto root = parseToml(text, source_name);
  if (!root) return tl::unexpected(root.error());
  std::vector<TomlAssignment> assignments;
  for (const auto& [module, node] : *root) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      return fail("{}: '{}' stands outside a table; expected a table such as [control]", place(source_name, node),
                  module.str());
    }
    if (auto read = readTable(*table, module.str(), source_name, parameters, ranges, "fyd params", assignments); !read)
      return read;
  }
  for (const TomlAssignment& assignment : assignments) assignment.store();
  return {};
}

std::string formatProfile(std::span<const Parameter> parameters) {
  std::string out;
  std::string_view module;
  for (const Parameter& parameter : parameters) {
    const auto dot = parameter.id.find('.');
    if (parameter.id.substr(0, dot) != module) {
      module = parameter.id.substr(0, dot);
      out += fmt::format("{}[{}]\n", out.empty() ? "" : "\n", module);
    }
    std::string value = formatParameter(parameter);
    if (parameter.kind == ParameterKind::choice || parameter.kind == ParameterKind::text) value = quoted(value);
    out += fmt::format("{} = {}  # {}\n", parameter.id.substr(dot + 1), value, describeRange(parameter).text());
  }
  return out;
}

}  // namespace fyd
