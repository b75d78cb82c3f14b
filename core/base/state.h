// How a class declares its state, once, for archives that save and restore it: one member template that names all that
// changes between two steps.
//
//   template <class Archive>
//   void serialize(Archive& archive) {
//     archive(value_, started_, within(index_, kCells - 1), within(mode_, Mode::last), contents(window_));
//   }
//
// What follows from the parameters alone is recomputed and left out. No size is ever read: an object is filled as large
// as it is, so damaged bytes allocate nothing.
// Stability: may change
#pragma once

#include <span>
#include <stdexcept>

namespace fyd {

/// What an index, a counter or a choice may be: 0 … highest. Bytes that say otherwise are refused by an exception,
/// which whoever owns the archive turns into an error.
template <class T>
struct Within {
  T& value;
  T highest;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(value);
    if constexpr (Archive::is_loading::value) {
      if (!(T{} <= value && value <= highest)) throw std::out_of_range("an index or a choice that cannot be");
    }
  }
};

template <class T, class Highest>
[[nodiscard]] Within<T> within(T& value, Highest highest) {
  return {value, static_cast<T>(highest)};
}

/// A counter that other code bounds; here it is only protected against overflow.
template <class T>
[[nodiscard]] Within<T> counter(T& value) {
  return within(value, 1 << 30);
}

/// The items of a vector or array, without their number.
template <class T>
struct Contents {
  std::span<T> items;

  template <class Archive>
  void serialize(Archive& archive) {
    for (T& item : items) archive(item);
  }
};

template <class Range>
[[nodiscard]] auto contents(Range& range) {
  return Contents<typename Range::value_type>{range};
}

}  // namespace fyd
