#include "core/base/parameter.h"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <charconv>
#include <cmath>

namespace fyd {
namespace {

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Result<double> parseNumber(const Parameter& parameter, std::string_view text) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size()) {
    return fail("{}: '{}' is not a number; expected {}", parameter.id, text, describeRange(parameter));
  }
  return value;
}

bool isUtf8(std::string_view text) {
  using Utf = boost::locale::utf::utf_traits<char>;
  for (auto at = text.begin(); at != text.end();) {
    if (!boost::locale::utf::is_valid_codepoint(Utf::decode(at, text.end()))) return false;
  }
  return true;
}

template <class T>
double readAs(const void* field) {
  return static_cast<double>(*static_cast<const T*>(field));
}

}  // namespace

void ParameterCollector::real(std::string_view id, double& field, const ParameterInfo& info) {
  out_.push_back({.id = id,
                  .kind = ParameterKind::real,
                  .info = info,
                  .field = &field,
                  .read = readAs<double>,
                  .store = [](void* to, double value) { *static_cast<double*>(to) = value; }});
}

void ParameterCollector::integer(std::string_view id, int& field, const ParameterInfo& info) {
  out_.push_back({.id = id,
                  .kind = ParameterKind::integer,
                  .info = info,
                  .field = &field,
                  .read = readAs<int>,
                  .store = [](void* to, double value) { *static_cast<int*>(to) = static_cast<int>(value); }});
}

void ParameterCollector::boolean(std::string_view id, bool& field, const ParameterInfo& info) {
  out_.push_back({.id = id,
                  .kind = ParameterKind::boolean,
                  .info = info,
                  .field = &field,
                  .read = readAs<bool>,
                  .store = [](void* to, double value) { *static_cast<bool*>(to) = value != 0.0; }});
  out_.back().info.minimum = 0;
  out_.back().info.maximum = 1;
}

void ParameterCollector::list(std::string_view id, ParameterList& field, const ParameterInfo& info) {
  out_.push_back({.id = id, .kind = ParameterKind::list, .info = info, .field = &field});
}

void ParameterCollector::text(std::string_view id, std::string& field, const ParameterInfo& info) {
  out_.push_back({.id = id, .kind = ParameterKind::text, .info = info, .field = &field});
}

void ParameterCollector::add(std::string_view id, void* field, std::span<const std::string_view> names,
                             const ParameterInfo& info, double (*read)(const void*), void (*store)(void*, double)) {
  out_.push_back({.id = id,
                  .kind = ParameterKind::choice,
                  .info = info,
                  .choices = names,
                  .field = field,
                  .read = read,
                  .store = store});
  out_.back().info.minimum = 0;
  out_.back().info.maximum = static_cast<double>(names.size()) - 1;
}

bool mayTake(const Parameter& parameter, double value, Ranges ranges) {
  const ParameterKind kind = parameter.kind;
  const bool whole = kind != ParameterKind::real && kind != ParameterKind::list;
  const bool bound = ranges == Ranges::bind || kind != ParameterKind::real || !parameter.info.live;
  if (kind == ParameterKind::text || !std::isfinite(value) || (whole && value != std::floor(value))) return false;
  return !bound || (value >= parameter.info.minimum && value <= parameter.info.maximum);
}

Result<double> checkParameter(const Parameter& parameter, double value, Ranges ranges) {
  if (!mayTake(parameter, value, ranges)) {
    return fail("{} = {}: expected {}", parameter.id, value, describeRange(parameter));
  }
  return value + 0.0;  // -0 would be written as -0, an integer in TOML, and read again as 0: it is 0 at once
}

bool insideRange(const Parameter& parameter) {
  const auto inside = [&](double value) { return mayTake(parameter, value); };
  if (parameter.kind == ParameterKind::text) return true;
  if (parameter.kind == ParameterKind::list) return std::ranges::all_of(parameter.list(), inside);
  return inside(parameter.value());
}

Result<std::string> checkText(const Parameter& parameter, std::string_view text) {
  const bool one_line =
      std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (!isUtf8(text)) return fail("{}: not UTF-8", parameter.id);  // TOML would hold another text
  if (one_line && text.size() <= kParameterTextLimit) return std::string(text);
  if (one_line) return fail("{}: {} bytes; expected {}", parameter.id, text.size(), describeRange(parameter));
  return fail("{}: {} bytes with control characters; expected {}", parameter.id, text.size(), describeRange(parameter));
}

Result<void> assignParameter(const Parameter& parameter, std::string_view text, Ranges ranges) {
  text = trim(text);
  if (parameter.kind == ParameterKind::text) {
    auto checked = checkText(parameter, text);
    if (!checked) return tl::unexpected(checked.error());
    parameter.text() = std::move(*checked);
    return {};
  }
  if (parameter.kind == ParameterKind::list) {
    if (text.size() < 2 || text.front() != '[' || text.back() != ']') {
      return fail("{} = {}: expected a list such as [1, 2]", parameter.id, text);
    }
    ParameterList values;
    std::string_view rest = trim(text.substr(1, text.size() - 2));
    while (!rest.empty()) {
      const auto comma = rest.find(',');
      const auto value = parseNumber(parameter, trim(rest.substr(0, comma))).and_then([&](double v) {
        return checkParameter(parameter, v, ranges);
      });
      if (!value) return tl::unexpected(value.error());
      if (!values.push(*value)) return fail("{}: at most {} values", parameter.id, kParameterListCapacity);
      rest = comma == std::string_view::npos ? std::string_view{} : trim(rest.substr(comma + 1));
    }
    parameter.list() = values;
    return {};
  }
  if (parameter.kind == ParameterKind::boolean && (text == "true" || text == "false")) {
    parameter.set(text == "true" ? 1.0 : 0.0);
    return {};
  }
  if (parameter.kind == ParameterKind::choice) {
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
      if (parameter.choices[i] == text) {
        parameter.set(static_cast<double>(i));
        return {};
      }
    }
    return fail("{} = '{}': expected {}", parameter.id, text, describeRange(parameter));
  }
  if (parameter.kind == ParameterKind::boolean) {
    return fail("{} = '{}': expected true or false", parameter.id, text);
  }
  const auto value =
      parseNumber(parameter, text).and_then([&](double v) { return checkParameter(parameter, v, ranges); });
  if (!value) return tl::unexpected(value.error());
  parameter.set(*value);
  return {};
}

std::string formatParameter(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::boolean: return parameter.value() != 0.0 ? "true" : "false";
    case ParameterKind::choice: return std::string(parameter.choices[static_cast<std::size_t>(parameter.value())]);
    case ParameterKind::integer: return fmt::format("{}", static_cast<long>(parameter.value()));
    case ParameterKind::list: return fmt::format("[{}]", fmt::join(parameter.list().view(), ", "));
    case ParameterKind::text: return parameter.text();
    case ParameterKind::real: break;
  }
  return fmt::format("{}", parameter.value());
}

Message describeRange(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::boolean) return say("true or false");
  if (parameter.kind == ParameterKind::choice) return say("one of {}", fmt::join(parameter.choices, ", "));
  if (parameter.kind == ParameterKind::text) return say("a line of at most {} bytes", kParameterTextLimit);
  const double lowest = parameter.info.minimum;
  const double highest = parameter.info.maximum;
  const std::string unit = parameter.info.unit == "1" ? "" : fmt::format(" {}", parameter.info.unit);
  if (parameter.kind == ParameterKind::list) {
    return say("a list of numbers, each from {} to {}{}", lowest, highest, unit);
  }
  if (parameter.kind == ParameterKind::integer) {
    return say("a whole number from {} to {}{}", lowest, highest, unit);
  }
  return say("a number from {} to {}{}", lowest, highest, unit);
}

const Parameter* findParameter(std::span<const Parameter> parameters, std::string_view id) {
  for (const Parameter& parameter : parameters) {
    if (parameter.id == id || (!id.empty() && parameter.info.formerly == id)) return &parameter;
  }
  return nullptr;
}

}  // namespace fyd
