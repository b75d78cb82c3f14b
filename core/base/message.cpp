#include "core/base/message.h"

#include <charconv>

namespace fyd {
namespace {

/// A piece of a form: text as it stands, then a place (none behind the last).
struct Piece {
  std::string text;
  std::optional<std::size_t> value;
  std::string_view spec;
};

/// nullopt: a brace without its partner, a name in place of a number, numbered places beside others.
std::optional<std::vector<Piece>> pieces(std::string_view form) {
  std::vector<Piece> out(1);
  std::size_t next = 0;
  bool numbered = false;
  bool counted = false;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const char c = form[i];
    if (c != '{' && c != '}') {
      out.back().text += c;
      continue;
    }
    if (i + 1 < form.size() && form[i + 1] == c) {
      out.back().text += c;
      ++i;
      continue;
    }
    const auto end = form.find('}', i);
    if (c == '}' || end == std::string_view::npos) return std::nullopt;
    const std::string_view place = form.substr(i + 1, end - i - 1);
    const std::string_view number = place.substr(0, place.find(':'));
    std::size_t index = next++;
    if (!number.empty()) {
      const auto [rest, problem] = std::from_chars(number.data(), number.data() + number.size(), index);
      if (problem != std::errc{} || rest != number.data() + number.size()) return std::nullopt;
    }
    (number.empty() ? counted : numbered) = true;
    out.back().value = index;
    out.back().spec = number.size() < place.size() ? place.substr(number.size() + 1) : std::string_view{};
    out.emplace_back();
    i = end;
  }
  if (numbered && counted) return std::nullopt;
  return out;
}

/// For each value, the spec of its place; nullopt where it has none, or the places name other values.
std::optional<std::vector<std::string_view>> specsOf(const std::vector<Piece>& form, std::size_t values) {
  std::vector<std::optional<std::string_view>> found(values);
  for (const Piece& piece : form) {
    if (!piece.value) continue;
    if (*piece.value >= values) return std::nullopt;
    auto& spec = found[*piece.value];
    if (spec && *spec != piece.spec) return std::nullopt;
    spec = piece.spec;
  }
  std::vector<std::string_view> out;
  for (const auto& spec : found) {
    if (!spec) return std::nullopt;
    out.push_back(*spec);
  }
  return out;
}

/// Of a message of two.
Message pair(std::string_view format, Message first, Message second) {
  Message out(second.kind, format);
  out.add(std::move(first));
  out.add(std::move(second));
  return out;
}

}  // namespace

Message::Message(const Message&) = default;
Message::Message(Message&&) noexcept = default;
Message& Message::operator=(const Message&) = default;
Message& Message::operator=(Message&&) noexcept = default;
Message::~Message() = default;

void Message::add(std::int64_t value) { values.push_back({value}); }
void Message::add(std::uint64_t value) { values.push_back({value}); }
void Message::add(double value) { values.push_back({value}); }
void Message::add(std::string value) { values.push_back({std::move(value)}); }
void Message::add(Message value) { values.push_back({std::move(value)}); }

bool operator==(const Value& a, const Value& b) { return a.is == b.is; }
bool operator==(const Message& a, const Message& b) { return a.format == b.format && a.values == b.values; }

std::string_view toString(MessageKind kind) {
  using enum MessageKind;
  switch (kind) {
    case command: return "command";
    case input: return "input";
    case device: return "device";
    case link: return "link";
    case recording: return "recording";
    case calibration: return "calibration";
    case algorithm: return "algorithm";
    case simulation: return "simulation";
    case station: return "station";
  }
  return "command";
}

std::string shown(const Value& value, std::string_view spec) {
  return std::visit(
      [&](const auto& is) -> std::string {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(is)>, Message>) {
          return is.text();
        } else {
          return fmt::format(fmt::runtime(fmt::format("{{:{}}}", spec)), is);
        }
      },
      value.is);
}

std::optional<std::string> filledIn(std::string_view form, const Message& message, const ShowValue& show) {
  const auto parts = pieces(form);
  if (!parts) return std::nullopt;
  const auto specs = specsOf(*parts, message.values.size());
  if (!specs) return std::nullopt;
  if (form.data() != message.format.data()) {
    const auto own = pieces(message.format);
    if (!own || specsOf(*own, message.values.size()) != specs) return std::nullopt;
  }
  std::string out;
  for (const Piece& piece : *parts) {
    out += piece.text;
    if (piece.value) out += show(message.values[*piece.value], piece.spec);
  }
  return out;
}

std::optional<std::string> filledIn(std::string_view form, const Message& message) {
  return filledIn(form, message, shown);
}

std::string Message::text() const { return filledIn(format, *this).value_or(std::string(format)); }

Message verbatim(std::string_view text) {
  if (text.empty()) return {};
  Message out(MessageKind::input, "{}");
  out.add(std::string(text));
  return out;
}

Message about(std::string_view name, Message message) { return about(verbatim(name), std::move(message)); }

Message about(Message what, Message message) { return pair("{}: {}", std::move(what), std::move(message)); }

Message explained(Message message, Message by) { return pair("{} ({})", std::move(message), std::move(by)); }

Message listed(std::vector<Message> messages, std::string_view format) {
  Message out;
  for (Message& each : messages) {
    if (out.empty()) {
      out = std::move(each);
    } else if (!each.empty()) {
      out = pair(format, std::move(out), std::move(each));
    }
  }
  return out;
}

}  // namespace fyd
