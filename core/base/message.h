// What the program says to a person, as data: a format and its values. English is made of it where it is shown
// (`text`), another language in the window, by the format.
//
// A format stands as a literal in one of these calls, where lupdate finds it for those who translate
// (tests/translations/translations.py):
//
//   fail("{}: cannot be read: {}", path, why)    an error (core/base/error.h)
//   say("encoder {} jumped by {:.0f}°", i, by)    any other sentence with values
//   sentence("the robot is silent")               words without values: a name in a table, a parameter's help
//
// A value is a number, a text that no language changes (a name, a path, an id), or a Message of its own where it is
// itself words: `say("Not armed: {}.", phrase(toString(fault)))`.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/base/api.h"

namespace fyd {

/// The part of the program that a message comes from; the folder of its source file decides. Its name (`toString`) is
/// stable: scripts read it.
enum class MessageKind : std::uint8_t {
  command,      ///< the command line or the window itself
  input,        ///< a value or a file that was given: parameters, profiles, tables (core/base)
  device,       ///< touchpad, motors, camera, robot (core/device)
  link,         ///< the connection to the remote site (core/protocol)
  recording,    ///< recordings, exports, reports and the catalogue (core/recording, replay, export, report, catalogue)
  calibration,  ///< core/calibration
  algorithm,    ///< the step and what it is made of (core/pipeline, control, sensing, signal, texture)
  simulation,   ///< the simulated devices (core/sim)
  station,      ///< what runs the devices and the step (core/station)
};

[[nodiscard]] FYD_API std::string_view toString(MessageKind kind);

struct Value;

// Nearly every file makes, copies and drops messages: what that takes is compiled once.
struct FYD_API Message {
  MessageKind kind = MessageKind::command;
  std::string_view format;  ///< static storage; places as fmt has them, each filled by the value of its number
  std::vector<Value> values;

  Message();
  Message(MessageKind its_kind, std::string_view its_format);
  Message(const Message&);
  Message(Message&&) noexcept;
  Message& operator=(const Message&);
  Message& operator=(Message&&) noexcept;
  ~Message();

  [[nodiscard]] bool empty() const { return format.empty(); }
  /// In English.
  [[nodiscard]] std::string text() const;
  /// Equal format and values; `kind` is not compared.
  FYD_API friend bool operator==(const Message& a, const Message& b);

  /// One value more.
  void add(std::int64_t value);
  void add(std::uint64_t value);
  void add(double value);
  void add(std::string value);
  void add(Message value);
};

/// A value of a message.
struct Value {
  std::variant<std::int64_t, std::uint64_t, double, std::string, Message> is;

  FYD_API friend bool operator==(const Value&, const Value&);
};

// Not within the class: what they would destroy must be complete.
inline Message::Message() = default;
inline Message::Message(MessageKind its_kind, std::string_view its_format) : kind(its_kind), format(its_format) {}

/// A value as a place with this spec ("" or ".2f") shows it, in English.
[[nodiscard]] FYD_API std::string shown(const Value& value, std::string_view spec);

using ShowValue = std::function<std::string(const Value& value, std::string_view spec)>;
/// The values filled into `form`, the message's format or its translation.
/// @return nullopt when the form's places do not fit the values: every value in at least one place, with the same spec
///         as in the message's own format
[[nodiscard]] FYD_API std::optional<std::string> filledIn(std::string_view form, const Message& message,
                                                          const ShowValue& show);
[[nodiscard]] FYD_API std::optional<std::string> filledIn(std::string_view form,
                                                          const Message& message);  ///< as `shown`

/// Marks a literal for translation, and returns it.
[[nodiscard]] consteval std::string_view sentence(const char* english) { return english; }

/// A `sentence` as a message.
/// @param english static storage
[[nodiscard]] inline Message phrase(std::string_view english) { return {MessageKind::command, english}; }

/// Words that are not the program's own (of the system, of a library, of a file) and that no language changes.
[[nodiscard]] FYD_API Message verbatim(std::string_view text);

/// "{}: {}": what was wrong with what, when the message alone does not name it.
[[nodiscard]] FYD_API Message about(std::string_view name, Message message);
[[nodiscard]] FYD_API Message about(Message what, Message message);

/// "{} ({})": the reason, or what else belongs to it, in brackets.
[[nodiscard]] FYD_API Message explained(Message message, Message by);

/// One after the other; empty ones are left out.
/// @param format "{}; {}" or "{}, {}": what stands between
[[nodiscard]] FYD_API Message listed(std::vector<Message> messages, std::string_view format = "{}; {}");

namespace message_detail {

constexpr MessageKind kindOf(std::string_view file) {
  using enum MessageKind;
  constexpr auto kModules = std::to_array<std::pair<std::string_view, MessageKind>>({{"base/", input},
                                                                                     {"calibration/", calibration},
                                                                                     {"catalogue/", recording},
                                                                                     {"device/", device},
                                                                                     {"export/", recording},
                                                                                     {"protocol/", link},
                                                                                     {"recording/", recording},
                                                                                     {"replay/", recording},
                                                                                     {"report/", recording},
                                                                                     {"sim/", simulation},
                                                                                     {"station/", station}});
  constexpr std::string_view kCore = "core/";
  const auto core = file.rfind(kCore);
  if (core == std::string_view::npos) return command;
  for (const auto& [module, kind] : kModules) {
    if (file.substr(core + kCore.size()).starts_with(module)) return kind;
  }
  return algorithm;
}

/// Whether a format says anything beside its values: has a letter outside of its places.
constexpr bool hasWords(std::string_view format) {
  bool in_place = false;
  for (const char c : format) {
    if (c == '{') in_place = true;
    if (!in_place && (((c | 0x20) >= 'a' && (c | 0x20) <= 'z') || static_cast<unsigned char>(c) >= 0x80)) return true;
    if (c == '}') in_place = false;
  }
  return false;
}

template <class T>
inline constexpr bool kIsList = false;
template <class Iterator, class End, class Char>
inline constexpr bool kIsList<fmt::join_view<Iterator, End, Char>> = true;

template <class T>
consteval auto heldAs() {
  constexpr bool kText = std::is_same_v<T, bool> || std::is_same_v<T, char>;  // though integral
  if constexpr (std::is_same_v<T, Message>) {
    return std::type_identity<Message>();
  } else if constexpr (std::signed_integral<T> && !kText) {
    return std::type_identity<std::int64_t>();
  } else if constexpr (std::unsigned_integral<T> && !kText) {
    return std::type_identity<std::uint64_t>();
  } else if constexpr (std::floating_point<T>) {
    return std::type_identity<double>();
  } else {
    return std::type_identity<std::string>();
  }
}

/// As what a message holds a T: a number of the widest type of its sort, a message, or a text (fmt::join makes one).
template <class T>
using Held = typename decltype(heldAs<T>())::type;

template <class T>
void add(Message& message, T&& from) {
  using Plain = std::remove_cvref_t<T>;
  static_assert(!std::is_same_v<Plain, float>, "a float and a double show other digits: say which is meant");
  if constexpr (kIsList<Plain>) {
    message.add(fmt::format("{}", std::forward<T>(from)));
  } else if constexpr (std::is_same_v<Plain, bool>) {
    message.add(std::string(from ? "true" : "false"));
  } else if constexpr (std::is_same_v<Plain, char>) {
    message.add(std::string(1, from));
  } else {
    message.add(static_cast<Held<Plain>>(std::forward<T>(from)));
  }
}

/// Type that a place's format spec is checked against: a message is shown as a text.
template <class T>
using Checked = std::conditional_t<std::is_arithmetic_v<Held<std::remove_cvref_t<T>>>, Held<std::remove_cvref_t<T>>,
                                   std::string_view>;

template <class... Held>
consteval void checkPlaces(const char* literal) {
  static_cast<void>(fmt::format_string<Held...>(literal));
}

/// A literal, checked as it is compiled: its places fit the arguments, and it says something beside them.
template <class... Args>
struct Format {
  std::string_view text;
  MessageKind kind;

  consteval Format(const char* literal, const char* file = __builtin_FILE())  // NOLINT: a literal becomes one
      : text(literal), kind(kindOf(file)) {
    checkPlaces<Checked<Args>...>(literal);
    if (!hasWords(text)) throw "a format of places only: there is nothing to translate; see verbatim and about";
  }
};

}  // namespace message_detail

template <class... Args>
using MessageFormat = message_detail::Format<std::type_identity_t<Args>...>;

/// A message from a format, as fmt has it, and its values.
template <class... Args>
[[nodiscard]] Message say(MessageFormat<Args...> format, Args&&... args) {
  Message out(format.kind, format.text);
  (message_detail::add(out, std::forward<Args>(args)), ...);
  return out;
}

}  // namespace fyd
