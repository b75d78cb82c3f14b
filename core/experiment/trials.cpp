#include "core/experiment/trials.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace fyd::experiment {
namespace {

using Order = std::vector<std::size_t>;

/// A uniform random number below `limit`, the same with every standard library.
std::size_t below(std::mt19937_64& random, std::size_t limit) {
  const std::uint64_t all = std::mt19937_64::max();
  const std::uint64_t fair = all - all % limit;
  std::uint64_t drawn = random();
  while (drawn >= fair) drawn = random();
  return static_cast<std::size_t>(drawn % limit);
}

void shuffle(Order& order, std::mt19937_64& random) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(random, i)]);
}

Order inOrder(std::size_t count) {
  Order out(count);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

/// [Williams 1949]: the first row runs 0, 1, n−1, 2, n−2, …; each further row adds one to it. With an odd number of
/// conditions the mirrored rows follow, which balances the neighbours there too.
std::vector<Order> williams(std::size_t n) {
  Order first;
  for (std::size_t i = 0; i < n; ++i) first.push_back(i % 2 == 1 ? (i + 1) / 2 : (n - i / 2) % n);
  std::vector<Order> rows;
  for (std::size_t shift = 0; shift < n; ++shift) {
    Order row;
    for (const std::size_t value : first) row.push_back((value + shift) % n);
    rows.push_back(row);
  }
  for (std::size_t i = 0; n % 2 == 1 && n > 1 && i < n; ++i) rows.emplace_back(rows[i].rbegin(), rows[i].rend());
  return rows;
}

Result<void> check(const std::vector<std::string>& conditions, std::size_t repetitions) {
  if (conditions.empty() || conditions.size() > kMaximumConditions) {
    return fail("{} conditions: expected 1 … {}", conditions.size(), kMaximumConditions);
  }
  if (repetitions < 1 || repetitions > kMaximumRepetitions) {
    return fail("{} repetitions: expected 1 … {}", repetitions, kMaximumRepetitions);
  }
  for (auto i = conditions.begin(); i != conditions.end(); ++i) {
    if (i->empty()) return fail("a condition without a name");
    if (std::find(conditions.begin(), i, *i) != i) return fail("condition '{}' is given twice", *i);
  }
  return {};
}

}  // namespace

Result<std::vector<Trial>> orderTrials(const std::vector<std::string>& conditions, std::size_t repetitions,
                                       std::uint64_t seed, TrialOrder order) {
  if (auto checked = check(conditions, repetitions); !checked) return tl::unexpected(checked.error());
  std::mt19937_64 random(seed);
  const std::size_t n = conditions.size();
  Order names = inOrder(n);
  shuffle(names, random);  // assigns the conditions to the square's symbols
  std::vector<Order> square = williams(n);
  Order rows = inOrder(square.size());

  std::vector<Trial> out;
  std::size_t last = n;
  for (std::size_t block = 0; out.size() < n * repetitions; ++block) {
    Order row;
    if (order == TrialOrder::latin_square) {
      if (block % square.size() == 0) shuffle(rows, random);
      for (const std::size_t symbol : square[rows[block % square.size()]]) row.push_back(names[symbol]);
    } else if (n == 2) {
      const std::size_t each = std::min<std::size_t>(2, repetitions - out.size() / n);
      for (std::size_t i = 0; i < n * each; ++i) row.push_back(i % n);
      shuffle(row, random);
    } else {
      row = inOrder(n);
      do shuffle(row, random);
      while (n > 1 && row.front() == last);
    }
    for (const std::size_t condition : row) {
      out.push_back({.number = static_cast<std::uint32_t>(out.size() + 1),
                     .block = static_cast<std::uint32_t>(block + 1),
                     .condition = conditions[condition]});
    }
    last = row.back();
  }
  return out;
}

std::string markerText(const Trial& trial) { return fmt::format("{} {}", trial.number, trial.condition); }

}  // namespace fyd::experiment
