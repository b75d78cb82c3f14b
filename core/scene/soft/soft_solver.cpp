#include "core/scene/soft/soft_solver.h"

namespace fyd::scene {
namespace {

constexpr int kMostIterations = 400;

Four ratio(const Four& a, const Four& b) { return (b > 0.0).select(a / (b > 0.0).select(b, 1.0), 0.0); }

}  // namespace

SoftSolver::SoftSolver(std::size_t points)
    : r_(points, Four::Zero()), p_(points, Four::Zero()), q_(points, Four::Zero()) {}

int SoftSolver::solve(const SoftMatrix& k, double scale, std::span<const double> d,
                      std::span<const std::uint32_t> awake, std::span<const Four> b, std::span<Four> x,
                      double tolerance, const Four& least) {
  const auto times = [&](std::uint32_t i, std::span<const Four> v) -> Four {
    Four sum = k.diagonal[i] * v[i];
    for (std::uint32_t e = k.first[i]; e < k.first[i + 1]; ++e) sum += k.value[e] * v[k.column[e]];
    return d[i] * v[i] + scale * sum;
  };
  const auto inverse = [&](std::uint32_t i) { return 1.0 / (d[i] + scale * k.diagonal[i]); };

  Four rz = Four::Zero(), bb = Four::Zero();
  for (const std::uint32_t i : awake) {
    const double z = inverse(i);
    r_[i] = b[i] - times(i, x);
    p_[i] = z * r_[i];
    rz += r_[i] * p_[i];
    bb += z * b[i] * b[i];
  }
  const Four enough = tolerance * tolerance * bb.max(least);
  int n = 0;
  for (; n < kMostIterations && (rz > enough).any(); ++n) {
    Four pq = Four::Zero();
    for (const std::uint32_t i : awake) {
      q_[i] = times(i, p_);
      pq += p_[i] * q_[i];
    }
    const Four step = (rz > enough).select(ratio(rz, pq), 0.0);  // a column that has converged stays
    Four next = Four::Zero();
    for (const std::uint32_t i : awake) {
      x[i] += step * p_[i];
      r_[i] -= step * q_[i];
      next += inverse(i) * r_[i] * r_[i];
    }
    const Four turn = ratio(next, rz);
    for (const std::uint32_t i : awake) p_[i] = inverse(i) * r_[i] + turn * p_[i];
    rz = next;
  }
  for (const std::uint32_t i : awake) p_[i] = Four::Zero();
  return n;
}

}  // namespace fyd::scene
