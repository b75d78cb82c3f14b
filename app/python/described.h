// Values that the core describes (core/base/fields.h) as Python classes and as columns: names, units and help are the
// description's.
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <vector>

#include "app/python/common.h"
#include "core/base/batch.h"
#include "core/base/fields.h"

namespace fyd::python {

template <class V>
inline constexpr bool kIsList = false;
template <class N, std::size_t Count>
inline constexpr bool kIsList<std::array<N, Count>> = true;
template <class V>
inline constexpr bool kIsBatch = false;
template <class N, std::size_t Count>
inline constexpr bool kIsBatch<Batch<N, Count>> = true;

/// As what Python has it: an instant as ns, a list as a tuple.
template <class V>
[[nodiscard]] auto toPython(const V& value) {
  if constexpr (std::is_same_v<V, Instant>) {
    return std::int64_t{value.time_since_epoch().count()};
  } else if constexpr (kIsBatch<V> || kIsList<V>) {
    py::tuple out(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) out[i] = toPython(value[i]);
    return out;
  } else {
    return value;
  }
}

/// Python would make a number of a text, of a part of a complex number, and a whole one of a fraction.
template <class V>
[[nodiscard]] V numberFrom(const py::handle& from) {
  if (!isRealNumber(from) || (std::is_integral_v<V> && PyIndex_Check(from.ptr()) == 0)) throw py::cast_error();
  return from.cast<V>();
}

/// @param name for the message
template <class V>
void fromPython(std::string_view name, const py::handle& from, V& value) {
  if constexpr (std::is_same_v<V, Instant>) {
    value = Instant(Duration(numberFrom<std::int64_t>(from)));
  } else if constexpr (kIsBatch<V>) {
    const auto items = from.cast<py::sequence>();
    if (items.size() > V::capacity())
      throw Refusal{fmt::format("{}: {} items; at most {} fit", name, items.size(), V::capacity())};
    V out;
    for (const auto& item : items) {
      typename decltype(out.items)::value_type one{};
      fromPython(name, item, one);
      static_cast<void>(out.push(one));
    }
    value = out;
  } else if constexpr (kIsList<V>) {
    const auto items = from.cast<py::sequence>();
    if (items.size() != value.size())
      throw Refusal{fmt::format("{}: {} items; expected {}", name, items.size(), value.size())};
    V out{};
    for (std::size_t i = 0; i < out.size(); ++i) fromPython(name, py::object(items[i]), out[i]);
    value = out;
  } else if constexpr (std::is_arithmetic_v<V> && !std::is_same_v<V, bool>) {
    value = numberFrom<V>(from);
  } else {
    value = from.cast<V>();
  }
}

/// A value that Python has no such number for, as of another type or too large: the message of Python's own.
template <class V>
void assignField(std::string_view name, const py::handle& from, V& value) {
  refuseMask(from);
  try {
    fromPython(name, from, value);
  } catch (const py::cast_error&) {
    throw py::type_error(fmt::format("{}: cannot be {}", name, std::string(py::repr(from))));
  }
}

template <class F>
[[nodiscard]] std::string nameOf(const F& field) {
  return std::string(field.name) + std::string(field.ending);
}
template <class F>
[[nodiscard]] std::string docOf(const F& field) {
  return fmt::format("{} [{}]", field.help, field.unit);
}

template <class T>
void assignNamed(T& value, const py::dict& given) {
  std::size_t used = 0;
  forEachField<T>([&](auto, const auto& field) {
    if constexpr (std::is_lvalue_reference_v<FieldResult<decltype(field), T>>) {
      const std::string name = nameOf(field);
      if (!given.contains(name.c_str())) return;
      assignField(name, py::object(given[name.c_str()]), field.of(value));
      ++used;
    }
  });
  if (used == given.size()) return;
  std::string names;
  forEachField<T>([&](auto, const auto& field) { names += (names.empty() ? "" : ", ") + nameOf(field); });
  for (const auto& [name, value_of] : given)
    if (fmt::format(", {}, ", names).find(fmt::format(", {}, ", std::string(py::str(name)))) == std::string::npos)
      throw py::type_error(
          fmt::format("{}: there is no such value; expected one of {}", std::string(py::str(name)), names));
}

/// A property for each field, a constructor by their names, `as_dict()`, and of the class `units` and `help`.
template <class T, class... More>
void describe(py::class_<T, More...>& type) {
  py::dict units;
  py::dict help;
  forEachField<T>([&](auto, const auto& field) {
    using F = std::remove_cvref_t<decltype(field)>;
    using V = FieldValue<F, T>;
    const std::string name = nameOf(field);
    units[name.c_str()] = std::string(field.unit);
    help[name.c_str()] = std::string(field.help);
    const auto get = [field](const T& value) { return toPython<V>(field.of(value)); };
    if constexpr (std::is_lvalue_reference_v<FieldResult<F, T>>) {
      type.def_property(
          name.c_str(), get,
          [field, name](T& value, const py::object& from) { assignField(name, from, field.of(value)); },
          docOf(field).c_str());
    } else {
      type.def_property_readonly(name.c_str(), get, docOf(field).c_str());
    }
  });
  type.attr("units") = units;
  type.attr("help") = help;
  type.def(
      "as_dict",
      [](const T& value) {
        py::dict out;
        forEachField<T>([&](auto, const auto& field) {
          using V = FieldValue<decltype(field), T>;
          out[nameOf(field).c_str()] = toPython<V>(field.of(value));
        });
        return out;
      },
      "Every value by its name. Units: those in `units`.");
  type.def("__repr__", [](const py::object& value) {
    std::string out;
    for (const auto& [name, one] : value.attr("as_dict")().template cast<py::dict>())
      out += fmt::format("{}{}={}", out.empty() ? "" : ", ", std::string(py::str(name)), std::string(py::repr(one)));
    return fmt::format("{}({})", std::string(py::str(py::type::of(value).attr("__name__"))), out);
  });
}

template <class T>
[[nodiscard]] auto byNames() {
  return py::init([](const py::kwargs& values) {
    T out;
    assignNamed(out, values);
    return out;
  });
}

/// Copies, also to another process, by the values that can be set.
template <class T, class... More>
void copyable(py::class_<T, More...>& type) {
  type.def(py::pickle(
      [](const T& value) {
        py::dict out;
        forEachField<T>([&](auto, const auto& field) {
          using F = std::remove_cvref_t<decltype(field)>;
          if constexpr (std::is_lvalue_reference_v<FieldResult<F, T>>)
            out[nameOf(field).c_str()] = toPython<FieldValue<F, T>>(field.of(value));
        });
        return out;
      },
      [](const py::dict& values) {
        T out;
        assignNamed(out, values);
        return out;
      }));
}

// -- columns -----------------------------------------------------------------------------------------------------

/// What a column of V holds: flags are NumPy's bool, an enum its number, an instant ns as int64.
template <class V>
[[nodiscard]] py::dtype dtypeOf() {
  if constexpr (std::is_same_v<V, Instant>) {
    return py::dtype::of<std::int64_t>();
  } else if constexpr (std::is_enum_v<V>) {
    return py::dtype::of<std::underlying_type_t<V>>();
  } else {
    return py::dtype::of<V>();
  }
}

/// The columns of rows in memory, by name: views of the rows themselves, not copies, but for what is computed of them.
template <class T>
[[nodiscard]] py::dict columnsOf(std::vector<T> rows) {
  auto* kept = new std::vector<T>(std::move(rows));
  const py::capsule owner(kept, [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  py::dict out;
  forEachField<T>([&](auto, const auto& field) {
    using F = std::remove_cvref_t<decltype(field)>;
    using V = FieldValue<F, T>;
    const std::string name = nameOf(field);
    const auto count = static_cast<py::ssize_t>(kept->size());
    if constexpr (std::is_lvalue_reference_v<FieldResult<F, T>>) {
      static const T none{};  // NumPy takes no null for the memory of an empty column
      const void* first = &field.of(kept->empty() ? none : static_cast<const T&>(kept->front()));
      py::array column(dtypeOf<V>(), {count}, {static_cast<py::ssize_t>(sizeof(T))}, first, owner);
      column.attr("flags").attr("writeable") = false;
      out[name.c_str()] = column;
    } else {
      py::array_t<V> column(count);
      for (py::ssize_t i = 0; i < count; ++i) column.mutable_at(i) = field.of((*kept)[static_cast<std::size_t>(i)]);
      column.attr("flags").attr("writeable") = false;
      out[name.c_str()] = column;
    }
  });
  return out;
}

}  // namespace fyd::python
