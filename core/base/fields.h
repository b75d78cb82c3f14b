// One description of each value that leaves the program, beside its struct:
//
//   struct BridgeReading {
//     double value_mV_per_V = 0.0;
//     static constexpr auto fields() {
//       return std::tuple(Field("value_mV_per_V", "mV/V", "of the bridge", &BridgeReading::value_mV_per_V));
//     }
//   };
//
// From it follow the row in a recording and its reader, the comparison of two runs, the columns of every export, the
// curves and the manual's tables. A field may be added anywhere: a recording is read by the names, and a field missing
// in one keeps the default of a new struct.
// Stability: may change
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "core/base/batch.h"
#include "core/base/timed.h"

namespace fyd {

template <class Member>
struct Field {
  constexpr Field(std::string_view its_name, std::string_view its_unit, std::string_view its_help, Member its_member)
      : name(its_name), unit(its_unit), help(its_help), member(its_member) {}

  /// The struct's member; what `member` computes is only written, never read back.
  template <class T>
  [[nodiscard]] constexpr decltype(auto) of(T& owner) const {
    return std::invoke(member, owner);
  }
  /// Of a list: the name of the column that counts its items.
  [[nodiscard]] constexpr Field counted(std::string_view count_name) const {
    Field out = *this;
    out.count = count_name;
    return out;
  }

  std::string_view name;    ///< stored in files: it never changes
  std::string_view unit;    ///< "1" for a plain number
  std::string_view help;    ///< a phrase for the manual
  Member member;            ///< pointer to a member, or a function of the struct
  std::string_view count;   ///< of a list: the name of the column that counts its items
  std::string_view ending;  ///< appended to the name for the column's name
};

/// An input that has a table of its own: a value with its time, or a list of those that came since the last step.
template <class Member>
struct InputTable {
  constexpr InputTable(const char* its_path, std::size_t its_number, std::string_view its_help, Member its_member,
                       bool comes_often = false)
      : path(its_path), number(its_number), help(its_help), member(its_member), often(comes_often) {}
  template <class T>
  [[nodiscard]] constexpr decltype(auto) of(T& owner) const {
    return std::invoke(member, owner);
  }
  [[nodiscard]] constexpr std::string_view name() const {
    return std::string_view(path).substr(std::string_view(path).rfind('/') + 1);
  }

  const char* path;
  std::size_t number;  ///< its place in a commit: it never changes, and a new table takes the next
  std::string_view help;
  Member member;
  bool often;  ///< may come with nearly every step
};

/// The fields of T; specialised for types that have no fields() of their own.
template <class T>
inline constexpr auto kFieldsOf = T::fields();
template <class T>
inline constexpr std::size_t kFieldCount = std::tuple_size_v<std::remove_const_t<decltype(kFieldsOf<T>)>>;

/// What a field holds; a reference when it can be read back.
template <class F, class T>
using FieldResult = decltype(std::declval<const F&>().of(std::declval<T&>()));
template <class F, class T>
using FieldValue = std::remove_cvref_t<FieldResult<F, T>>;

/// Calls visit(std::integral_constant<std::size_t, i>, element i) for each of a tuple.
template <class Tuple, class Visit>
constexpr void forEachOf(const Tuple& tuple, Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(std::integral_constant<std::size_t, I>(), std::get<I>(tuple)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Tuple>>());
}
template <class T, class Visit>
constexpr void forEachField(Visit&& visit) {
  forEachOf(kFieldsOf<T>, visit);
}

/// A member of a member.
template <class Outer, class Inner>
[[nodiscard]] constexpr auto inside(Outer outer, Inner inner) {
  return [=](auto& owner) -> decltype(auto) { return std::invoke(inner, std::invoke(outer, owner)); };
}

/// The fields of a member that is a struct itself.
template <class Part, class Outer>
[[nodiscard]] constexpr auto part(Outer outer) {
  return std::apply(
      [=](const auto&... field) {
        return std::tuple(
            Field(field.name, field.unit, field.help, inside(outer, field.member)).counted(field.count)...);
      },
      kFieldsOf<Part>);
}

template <class T>
inline constexpr auto kFieldsOf<Timed<T>> =
    std::tuple_cat(std::tuple(Field("count", "1", "values so far; 0: there was none yet", &Timed<T>::count),
                              Field("taken_ns", "ns", "when it was taken", &Timed<T>::taken)),
                   part<T>(&Timed<T>::value));

/// The same bit for bit: NaN equals NaN of the same bits only. T's fields are numbers and arrays of them.
template <class T>
[[nodiscard]] bool sameBits(const T& a, const T& b) {
  bool same = true;
  forEachField<T>([&](auto, const auto& field) {
    using Item = FieldValue<decltype(field), const T>;
    const Item& x = field.of(a);
    const Item& y = field.of(b);
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked for; no field has padding
    same = same && std::memcmp(&x, &y, sizeof(Item)) == 0;
  });
  return same;
}

}  // namespace fyd
