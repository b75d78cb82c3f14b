// How much is measured for the page of numbers: all subjects of it together take minutes, so the longest draw fewer cases
// there than alone. Each says in its table how many.
#pragma once

#include "app/bench/parts/bench_options.h"

namespace fyd::bench {

/// With --all.
[[nodiscard]] inline bool& isPageRun() {
  static bool page = false;
  return page;
}

/// `whole`; `of_page` with --all; `short_one` with --quick.
template <class T>
[[nodiscard]] T wholePageOrQuick(T whole, T of_page, T short_one) {
  return wholeOrQuick(isPageRun() ? of_page : whole, short_one);
}

}  // namespace fyd::bench
