// How a described value (core/base/fields.h) stands in a row of a recording: types, offsets, and both ways.
//
// Columns are listed in the order of the fields. In the row's bytes those of 8 bytes come first, then those of 4, then
// the others, each kind in the same order and aligned; a list is followed by its count. An instant is nanoseconds of
// the station's clock (i64), a flag or an enum one byte (u8).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "core/base/fields.h"

namespace fyd::recording {

static_assert(std::endian::native == std::endian::little, "rows go into the file as they stand in memory");

enum class ColumnType : std::uint8_t { u8, u16, u32, u64, i16, i32, i64, f64 };
inline constexpr std::array<std::size_t, 8> kBytesOfType{1, 2, 4, 8, 2, 4, 8, 8};

struct Column {
  std::string name;
  ColumnType type = ColumnType::f64;
  std::string unit;        ///< "1" for plain numbers
  std::size_t offset = 0;  ///< bytes into the row
  std::size_t count = 1;
  std::string help;
  [[nodiscard]] std::size_t bytes() const { return count * kBytesOfType[static_cast<std::size_t>(type)]; }
};

[[nodiscard]] inline std::int64_t nanoseconds(Instant when) { return when.time_since_epoch().count(); }
[[nodiscard]] inline Instant instantOf(std::int64_t nanoseconds) { return Instant(Duration(nanoseconds)); }

template <class V>
constexpr auto stored(V value) {
  if constexpr (std::is_same_v<V, Instant>) {
    return std::int64_t{value.time_since_epoch().count()};
  } else if constexpr (std::is_same_v<V, bool>) {
    return static_cast<std::uint8_t>(value ? 1 : 0);
  } else if constexpr (std::is_enum_v<V>) {
    static_assert(sizeof(V) == 1);
    return static_cast<std::uint8_t>(value);
  } else {
    return value;
  }
}

/// The number of an enum value that this program does not know is kept.
template <class V, class Number>
V restored(Number number) {
  if constexpr (std::is_same_v<V, Instant>) {
    return instantOf(number);
  } else if constexpr (std::is_same_v<V, bool>) {
    return number != 0;
  } else {
    return static_cast<V>(number);
  }
}

template <class V>
struct Cell {
  using Number = decltype(stored(V()));
  static constexpr std::size_t kCount = 1;
  static constexpr bool kCounted = false;
};
template <class V, std::size_t N>
struct Cell<std::array<V, N>> {
  using Number = V;
  static constexpr std::size_t kCount = N;
  static constexpr bool kCounted = false;
};
template <class V, std::size_t N>
struct Cell<Batch<V, N>> {
  using Number = V;
  static constexpr std::size_t kCount = N;
  static constexpr bool kCounted = true;
};

template <class Number>
constexpr ColumnType columnType() {
  if constexpr (std::is_floating_point_v<Number>) {
    static_assert(sizeof(Number) == sizeof(double));
    return ColumnType::f64;
  } else {
    constexpr auto kFirst = std::is_signed_v<Number> ? ColumnType::i16 : ColumnType::u8;
    constexpr int kStep = std::countr_zero(sizeof(Number)) - (std::is_signed_v<Number> ? 1 : 0);
    static_assert(kStep >= 0);
    return static_cast<ColumnType>(static_cast<int>(kFirst) + kStep);
  }
}

constexpr std::size_t aligned(std::size_t offset, std::size_t to) { return (offset + to - 1) / to * to; }

template <class T>
struct Shape {
  std::array<std::size_t, kFieldCount<T>> offsets{};
  std::size_t bytes = 0;
};
template <class T>
constexpr Shape<T> shapeOf() {
  Shape<T> out;
  std::size_t widest = 1;
  for (const std::size_t width : {8U, 4U, 0U}) {
    forEachField<T>([&](auto i, const auto& field) {
      using C = Cell<FieldValue<decltype(field), T>>;
      constexpr std::size_t kBytes = sizeof(typename C::Number);
      if ((kBytes >= 4 ? kBytes : 0) != width) return;
      out.offsets[i] = aligned(out.bytes, kBytes);
      out.bytes = out.offsets[i] + C::kCount * kBytes;
      if (C::kCounted) out.bytes = aligned(out.bytes, sizeof(std::uint32_t)) + sizeof(std::uint32_t);
      widest = std::max(widest, kBytes);
    });
  }
  out.bytes = aligned(out.bytes, widest);
  return out;
}
template <class T>
inline constexpr Shape<T> kShape = shapeOf<T>();
template <class C>
constexpr std::size_t countOffset(std::size_t items) {
  return aligned(items + C::kCount * sizeof(typename C::Number), sizeof(std::uint32_t));
}

template <class T>
using Row = std::array<std::byte, kShape<T>.bytes>;

template <class T>
[[nodiscard]] Row<T> toRow(const T& value) {
  Row<T> row{};
  forEachField<T>([&](auto i, const auto& field) {
    using V = FieldValue<decltype(field), const T>;
    using C = Cell<V>;
    std::byte* at = row.data() + kShape<T>.offsets[i];
    const V& member = field.of(value);
    if constexpr (C::kCounted) {
      const auto count = std::min<std::uint32_t>(member.count, C::kCount);
      std::memcpy(at, member.items.data(), sizeof member.items);
      std::memcpy(row.data() + countOffset<C>(kShape<T>.offsets[i]), &count, sizeof count);
    } else if constexpr (C::kCount > 1) {
      std::memcpy(at, member.data(), sizeof member);
    } else {
      const typename C::Number number = stored(member);
      std::memcpy(at, &number, sizeof number);
    }
  });
  return row;
}

/// @param row kShape<T>.bytes of them. @return false: a list in it has more items than fit, and `value` is half filled
template <class T>
[[nodiscard]] bool fromRow(const std::byte* row, T& value) {
  bool sound = true;
  forEachField<T>([&](auto i, const auto& field) {
    using V = FieldValue<decltype(field), T>;
    using C = Cell<V>;
    const std::byte* at = row + kShape<T>.offsets[i];
    if constexpr (!std::is_lvalue_reference_v<FieldResult<decltype(field), T>>) {
      return;  // computed from the others
    } else if constexpr (C::kCounted) {
      V& member = field.of(value);
      std::memcpy(member.items.data(), at, sizeof member.items);
      std::memcpy(&member.count, row + countOffset<C>(kShape<T>.offsets[i]), sizeof member.count);
      sound = sound && member.count <= C::kCount;
    } else if constexpr (C::kCount > 1) {
      std::memcpy(field.of(value).data(), at, sizeof(V));
    } else {
      typename C::Number number{};
      std::memcpy(&number, at, sizeof number);
      field.of(value) = restored<V>(number);
    }
  });
  return sound;
}

template <class T>
[[nodiscard]] std::vector<Column> columnsOf() {
  std::vector<Column> columns;
  forEachField<T>([&](auto i, const auto& field) {
    using C = Cell<FieldValue<decltype(field), T>>;
    columns.push_back({std::string(field.name) + std::string(field.ending), columnType<typename C::Number>(),
                       std::string(field.unit), kShape<T>.offsets[i], C::kCount, std::string(field.help)});
    if (C::kCounted)
      columns.push_back({std::string(field.count), ColumnType::u32, "1", countOffset<C>(kShape<T>.offsets[i]), 1,
                         "how many of them are used"});
  });
  return columns;
}

/// A column of one value, as a number.
[[nodiscard]] double numberIn(const std::byte* row, const Column& column);

}  // namespace fyd::recording
