// One description of each parameter, declared beside the code that uses it.
//
// A module's parameters are a plain struct whose defaults are its initialisers, with one member template:
//
//   struct PwmParameters {
//     double k_vib = 1.0;
//     template <class Visitor>
//     void describe(Visitor& v) {
//       v.real("texture.k_vib", k_vib, {.name = sentence("Gain"), .minimum = 0, .maximum = 10,
//                                       .help = sentence("Gain of the vibration."), .live = true});
//     }
//   };
//
// The profile file, the command line, the tuning panel, the recorder and the manual's tables all read
// the list that `bindParameters` makes of it. A live change travels to the step as (index, value).
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/api.h"
#include "core/base/batch.h"
#include "core/base/error.h"
#include "core/base/message.h"

namespace fyd {

enum class ParameterKind : std::uint8_t { real, integer, boolean, choice, list, text };

/// Description of a parameter, beside its id and its default.
struct ParameterInfo {
  std::string_view name;        ///< short, for the window, without its unit; only of those that may change live
  std::string_view unit = "1";  ///< "1" for a pure number
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  std::string_view help;  ///< one sentence, for the window and the manual; `sentence("…")` where the window shows it
  bool live = false;      ///< may change while the pipeline is active
  /// Value for recordings made before this parameter existed, so that a replay behaves as they did; none: the default.
  std::optional<double> before_it_was = std::nullopt;
  std::string_view formerly;  ///< id that it had before and that is still read; empty: none
};

/// How strictly a range is applied. bind: a value outside is refused. mark: as bind, except for live reals, which may
/// lie outside because an earlier program or a recording set them; the caller only marks them.
enum class Ranges : std::uint8_t { bind, mark };

inline constexpr std::size_t kParameterListCapacity = 16;
inline constexpr std::size_t kParameterTextLimit = 1024;  // bytes
using ParameterList = Batch<double, kParameterListCapacity>;

/// One parameter of one instance of a parameter struct. Numbers travel as double, a choice as its index.
struct Parameter {
  std::string_view id;  ///< "module.name"
  ParameterKind kind = ParameterKind::real;
  ParameterInfo info;
  std::span<const std::string_view> choices;  ///< kind choice only
  void* field = nullptr;
  double (*read)(const void*) = nullptr;
  void (*store)(void*, double) = nullptr;

  /// Whether it is one number: neither a list nor a text, which have no value() and never change live.
  [[nodiscard]] bool isNumber() const { return kind != ParameterKind::list && kind != ParameterKind::text; }
  [[nodiscard]] double value() const { return read(field); }
  /// Of a number: stores without a check; callers check with `checkParameter` first.
  void set(double value) const { store(field, value); }
  [[nodiscard]] ParameterList& list() const { return *static_cast<ParameterList*>(field); }
  [[nodiscard]] std::string& text() const { return *static_cast<std::string*>(field); }
};

/// The visitor that collects the descriptions.
class FYD_API ParameterCollector {
 public:
  explicit ParameterCollector(std::vector<Parameter>& out) : out_(out) {}

  void real(std::string_view id, double& field, const ParameterInfo& info);
  void integer(std::string_view id, int& field, const ParameterInfo& info);
  void boolean(std::string_view id, bool& field, const ParameterInfo& info);
  /// @param names static storage; the enum's values count from 0 in the same order.
  template <class Enum>
  void choice(std::string_view id, Enum& field, std::span<const std::string_view> names, const ParameterInfo& info) {
    static_assert(std::is_enum_v<Enum>);
    add(
        id, &field, names, info, [](const void* p) { return static_cast<double>(*static_cast<const Enum*>(p)); },
        [](void* p, double value) { *static_cast<Enum*>(p) = static_cast<Enum>(static_cast<int>(value)); });
  }
  void list(std::string_view id, ParameterList& field, const ParameterInfo& info);
  void text(std::string_view id, std::string& field, const ParameterInfo& info);

 private:
  void add(std::string_view id, void* field, std::span<const std::string_view> names, const ParameterInfo& info,
           double (*read)(const void*), void (*store)(void*, double));

  std::vector<Parameter>& out_;
};

/// Parameters of `instance`, in the order they are described. The result points into `instance`. A header of parameters
/// that many files bind declares it `extern template`: hundreds of descriptions are then compiled once.
template <class Parameters>
[[nodiscard]] std::vector<Parameter> bindParameters(Parameters& instance) {
  std::vector<Parameter> out;
  ParameterCollector collector(out);
  instance.describe(collector);
  return out;
}

/// Whether `value` may be stored, of a list as one of its values: finite, in range, whole where it must be. A text takes
/// none. Allocates nothing.
[[nodiscard]] FYD_API bool mayTake(const Parameter& parameter, double value, Ranges ranges = Ranges::bind);
/// The value to store, which is `value`, with 0 for -0; the message names id, value and range.
[[nodiscard]] FYD_API Result<double> checkParameter(const Parameter& parameter, double value,
                                                    Ranges ranges = Ranges::bind);
/// Whether its present value may be stored.
[[nodiscard]] FYD_API bool insideRange(const Parameter& parameter);

/// Whether `text` may be stored: one line of at most kParameterTextLimit bytes, in UTF-8. The message names the id.
[[nodiscard]] FYD_API Result<std::string> checkText(const Parameter& parameter, std::string_view text);

/// Reads one value as a person writes it ("12.5", "true", "dft321", "[1, 2]"), checks it and stores it.
[[nodiscard]] FYD_API Result<void> assignParameter(const Parameter& parameter, std::string_view text,
                                                   Ranges ranges = Ranges::bind);

/// The value as `assignParameter` reads it; reals with the digits that round-trip.
[[nodiscard]] FYD_API std::string formatParameter(const Parameter& parameter);

/// "a number from 0 to 10 N" or "one of a, b": what is allowed, for messages and tables.
[[nodiscard]] FYD_API Message describeRange(const Parameter& parameter);

/// nullptr when there is none.
[[nodiscard]] FYD_API const Parameter* findParameter(std::span<const Parameter> parameters, std::string_view id);

}  // namespace fyd
