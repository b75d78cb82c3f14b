// Two swords against truths that share no formula with them: closest points in whole numbers, crossings from ten
// thousand pictures of a step, and the work on closed paths.
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/scene/gesture/swords.h"

namespace fyd::scene {
namespace {

__extension__ using Whole = __int128;
struct WholeVec {
  std::int64_t x, y, z;
};
WholeVec minus(WholeVec a, WholeVec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
std::int64_t product(WholeVec a, WholeVec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
WholeVec crossed(WholeVec a, WholeVec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Share {
  Whole over, under;  ///< under > 0
};
bool less(const Share& a, const Share& b) { return a.over * b.under < b.over * a.under; }

/// Squared distance of p to the segment ab, exactly.
Share toSegment(WholeVec p, WholeVec a, WholeVec b) {
  const WholeVec ab = minus(b, a), ap = minus(p, a);
  const std::int64_t along = product(ab, ap), whole = product(ab, ab);
  if (along <= 0) return {product(ap, ap), 1};
  if (along >= whole) return {product(minus(p, b), minus(p, b)), 1};
  const WholeVec n = crossed(ab, ap);
  return {product(n, n), whole};
}

/// Of two segments: at an end of one of them, or along the common perpendicular where both feet lie within.
Share exactSquared(WholeVec a, WholeVec b, WholeVec c, WholeVec d) {
  Share best = toSegment(a, c, d);
  for (const Share& each : {toSegment(b, c, d), toSegment(c, a, b), toSegment(d, a, b)}) {
    if (less(each, best)) best = each;
  }
  const WholeVec n = crossed(minus(b, a), minus(d, c));
  const std::int64_t nn = product(n, n);
  if (nn == 0) return best;
  // The plane through ab along n cuts cd, and the plane through cd along n cuts ab.
  const auto cuts = [&](WholeVec p, WholeVec q, WholeVec from, WholeVec to) {
    const WholeVec wall = crossed(minus(q, p), n);
    const Whole one = product(wall, minus(from, p)), other = product(wall, minus(to, p));
    return (one <= 0 && other >= 0) || (one >= 0 && other <= 0);
  };
  if (!cuts(a, b, c, d) || !cuts(c, d, a, b)) return best;
  const Whole height = product(n, minus(a, c));
  const Share perpendicular{height * height, nn};
  return less(perpendicular, best) ? perpendicular : best;
}

Vec3 real(WholeVec v) { return {double(v.x), double(v.y), double(v.z)}; }

TEST(SwordsTruth, TheNearestPointsAreThoseOfWholeNumbers) {
  std::mt19937 random(1);
  for (const int span : {2, 5, 50, 1000}) {  // small ones: many that are parallel, meet, or have no length
    std::uniform_int_distribution<int> any(-span, span);
    const auto point = [&] { return WholeVec{any(random), any(random), any(random)}; };
    for (int i = 0; i < 20'000; ++i) {
      const WholeVec a = point(), b = point(), c = point(), d = point();
      const NearestOfBlades near = nearestOf(Blade{real(a), real(b)}, Blade{real(c), real(d)});
      const Share exact = exactSquared(a, b, c, d);
      const double truth = std::sqrt(double(exact.over) / double(exact.under));
      ASSERT_NEAR(length(near.apart_mm), truth, 1e-12 * span * 10) << span << " " << i;
      ASSERT_TRUE(near.at_a >= 0.0 && near.at_a <= 1.0 && near.at_b >= 0.0 && near.at_b <= 1.0);
    }
  }
}

Vec3 mixed(Vec3 from, Vec3 to, double share) { return (1.0 - share) * from + share * to; }

struct Passages {
  int through = 0;       ///< how often one blade passes through the other
  int outside = 0;       ///< how often their lines pass each other elsewhere
  bool crossed = false;  ///< since the last of both
  bool doubtful = false;
};

/// How often blades pass through each other, from pictures: between two of them the one's end points lie on other sides
/// of the plane through the other and the direction of sight, in both ways of looking.
Passages passages(const Blade& a0, const Blade& a1, const Blade& b0, const Blade& b1) {
  constexpr int kPictures = 4000;
  const auto picture = [&](int i, long double out[4][3]) {
    const double t = double(i) / kPictures;
    const Vec3 p[4] = {mixed(a0.grip_mm, a1.grip_mm, t), mixed(a0.tip_mm, a1.tip_mm, t),
                       mixed(b0.grip_mm, b1.grip_mm, t), mixed(b0.tip_mm, b1.tip_mm, t)};
    for (int k = 0; k < 4; ++k) {
      out[k][0] = p[k].x;
      out[k][1] = p[k].y;
      out[k][2] = p[k].z;
    }
  };
  const auto spanned = [](const long double* p, const long double* q, const long double* r, const long double* s) {
    const long double a[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, b[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]},
                      c[3] = {s[0] - p[0], s[1] - p[1], s[2] - p[2]};
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  Passages found;
  long double before = 0.0L;
  for (int i = 0; i <= kPictures; ++i) {
    long double p[4][3];
    picture(i, p);
    const long double now = spanned(p[0], p[1], p[2], p[3]);
    if (i > 0 && (before < 0) != (now < 0)) {
      // In the plane of all four: each pair on both sides of the other's line.
      long double n[3];
      const long double u[3] = {p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2]};
      const long double v[3] = {p[3][0] - p[2][0], p[3][1] - p[2][1], p[3][2] - p[2][2]};
      n[0] = u[1] * v[2] - u[2] * v[1];
      n[1] = u[2] * v[0] - u[0] * v[2];
      n[2] = u[0] * v[1] - u[1] * v[0];
      const auto lifted = [&](int from, int k) {
        long double q[3];
        for (int m = 0; m < 3; ++m) q[m] = p[from][m] + n[m];
        return spanned(p[from], p[from + 1], q, p[k]);
      };
      const long double c = lifted(0, 2), d = lifted(0, 3), e = lifted(2, 0), f = lifted(2, 1);
      const bool through = (c < 0) != (d < 0) && (e < 0) != (f < 0);
      ++(through ? found.through : found.outside);
      found.crossed = through && !found.crossed;
      // Too near to an end for pictures.
      const auto close = [](long double one, long double other) {
        return std::min(std::abs(one), std::abs(other)) < 0.01L * std::max(std::abs(one), std::abs(other));
      };
      found.doubtful = found.doubtful || close(c, d) || close(e, f);
    }
    before = now;
  }
  return found;
}

TEST(SwordsTruth, AStepOfAnySpeedCrossesAsOftenAsItsPicturesShow) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vec = [&](double size) { return Vec3{size * any(random), size * any(random), size * any(random)}; };
  SwordParameters parameters;
  parameters.length_mm = 900.0;
  int crossings = 0, checked = 0, doubts = 0, often = 0;
  for (int i = 0; i < 6000; ++i) {
    const double speed = i % 3 == 0 ? 50.0 : i % 3 == 1 ? 5.0 : 400.0;  // mm a step
    const Blade a0{vec(300.0), vec(300.0)}, b0{vec(300.0), vec(300.0)};
    const Blade a1{a0.grip_mm + vec(speed), a0.tip_mm + vec(speed)},
        b1{b0.grip_mm + vec(speed), b0.tip_mm + vec(speed)};
    const Passages truth = passages(a0, a1, b0, b1);
    if (truth.doubtful) {
      ++doubts;
      continue;
    }
    SwordState state;
    static_cast<void>(stepSwords(parameters, state, a0, b0, 0.001));
    const SwordTouch touch = stepSwords(parameters, state, a1, b1, 0.001);
    // Who crossed is crossed, unless it has slid over an end in the rest of the step.
    const NearestOfBlades near = nearestOf(a1, b1);
    const auto inner = [](double x) { return x > 0.0 && x < 1.0; };
    if (!truth.crossed || (inner(near.at_a) && inner(near.at_b))) {
      ASSERT_EQ(touch.crossed, truth.crossed) << i << ": " << truth.through << " " << truth.outside;
    }
    ++checked;
    crossings += truth.through == 1;
    often += truth.through + truth.outside > 1;
  }
  EXPECT_GT(checked, 5000);
  EXPECT_GT(crossings, 250);
  EXPECT_GT(often, 50);
  EXPECT_LT(doubts, 300);
  std::printf("%d steps, %d crossed once, %d pass several times, %d too near to an end\n", checked, crossings, often,
              doubts);
}

Blade posed(Vec3 middle, double yaw, double pitch) {
  const Vec3 by{450.0 * std::cos(yaw) * std::cos(pitch), 450.0 * std::sin(yaw) * std::cos(pitch),
                450.0 * std::sin(pitch)};
  return {middle - by, middle + by};
}

struct Loop {
  Vec3 middle, reach[3];
  double yaw, turn[3], phase[3];

  [[nodiscard]] Blade at(double share) const {
    Vec3 where = middle;
    double angle = yaw, pitch = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double wave = std::sin(2.0 * M_PI * (k + 1) * share + phase[k]);
      where = where + wave * reach[k];
      (k == 2 ? pitch : angle) += wave * turn[k];
    }
    return posed(where, angle, pitch);
  }
};

/// The work that the blades' forces do on both hands over a closed path; least = most that was taken at any time.
double work(const SwordParameters& parameters, const Loop& a, const Loop& b, int steps, double seconds, bool& touched,
            bool& open) {
  SwordState state;
  const double dt = seconds / steps;
  double sum = 0.0;
  SwordTouch before;
  for (int i = 0; i <= steps; ++i) {
    const double share = double(i) / steps, last = double(i - 1) / steps;
    const Blade local = a.at(share), distant = b.at(share);
    const SwordTouch now = stepSwords(parameters, state, local, distant, dt);
    if (i > 0) {
      // Force times the path of the material points it acts on; the mean of both ends of the step.
      const auto part = [&](const SwordTouch& touch, const Blade& on_a, const Blade& on_b) {
        const auto share_of = [](const Blade& blade, const Vec3& p) {
          const Vec3 u = blade.tip_mm - blade.grip_mm;
          return dot(p - blade.grip_mm, u) / squared(u);
        };
        const auto moved = [&](const Blade& of, const Blade& from, const Blade& to, const Vec3& p) {
          const double s = share_of(of, p);
          return mixed(to.grip_mm, to.tip_mm, s) - mixed(from.grip_mm, from.tip_mm, s);
        };
        return dot(touch.force_N, moved(on_a, a.at(last), local, touch.point_mm) -
                                      moved(on_b, b.at(last), distant, touch.other_point_mm));
      };
      sum += 0.5 * (part(before, a.at(last), b.at(last)) + part(now, local, distant));
    }
    touched = touched || now.touching;
    if (i == 0 || i == steps) open = open || now.touching;
    before = now;
  }
  return sum;
}

TEST(SwordsTruth, ClosedPathsGiveNoEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vec = [&](double size) { return Vec3{size * any(random), size * any(random), size * any(random)}; };
  int touching = 0, kept = 0;
  double most = 0.0;
  for (int i = 0; i < 300; ++i) {
    SwordParameters parameters;
    parameters.radius_mm = i % 2 == 0 ? 0.0 : 6.0;
    parameters.damping_Ns_per_mm = i % 4 < 2 ? 0.0 : 0.0005;
    parameters.friction = i % 8 < 4 ? 0.0 : 0.3;
    const bool near_tip = i % 3 == 0;  // slides over ends
    const auto loop = [&](double yaw, Vec3 middle) {
      Loop out{middle,
               {vec(15.0), vec(10.0), vec(8.0)},
               yaw,
               {0.1 * any(random), 0.05 * any(random), 0.01 * any(random)},
               {}};
      for (double& each : out.phase) each = 3.0 * any(random);
      return out;
    };
    const Loop a = loop(0.0, near_tip ? Vec3{-445.0, 0.0, 3.0} : Vec3{0.0, 0.0, 12.0}), b = loop(1.3, {});
    bool touched = false, open = false;
    const double sum = work(parameters, a, b, 20'000, 2.0, touched, open);
    if (!touched || open) continue;
    ++touching;
    most = std::max(most, sum);
    ASSERT_LE(sum, 2e-3) << i;  // mJ; the strokes hold up to 100 of them
    if (!near_tip && parameters.damping_Ns_per_mm == 0.0 && parameters.friction == 0.0) {
      EXPECT_NEAR(sum, 0.0, 2e-3) << i;
      ++kept;
    }
  }
  EXPECT_GT(touching, 60);
  EXPECT_GT(kept, 10);
  std::printf("%d closed paths in touch: at most %.2g mJ given\n", touching, most);
}

/// Slides over ends, parallel passages and turns included: in steps of 0.1 ms no difference of the force stands out
/// from those beside it, as a jump would.
TEST(SwordsTruth, TheForceNeverJumps) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vec = [&](double size) { return Vec3{size * any(random), size * any(random), size * any(random)}; };
  constexpr int kSteps = 20'000;
  std::vector<double> by(kSteps);
  double worst_N = 0.0;
  int touching = 0, slid = 0;
  for (int i = 0; i < 400; ++i) {
    SwordParameters parameters;
    parameters.radius_mm = i % 2 == 0 ? 0.0 : 6.0;
    parameters.damping_Ns_per_mm = 0.0;
    const auto loop = [&](double yaw, Vec3 middle) {
      Loop out{middle,
               {vec(15.0), vec(10.0), vec(8.0)},
               yaw,
               {0.1 * any(random), 0.05 * any(random), 0.01 * any(random)},
               {}};
      for (double& each : out.phase) each = 3.0 * any(random);
      return out;
    };
    const Loop a = loop(0.0, i % 3 == 0 ? Vec3{-445.0, 0.0, 3.0} : Vec3{0.0, 0.0, 12.0});
    const Loop b = loop(i % 4 < 2 ? 1.3 : 0.3, {});
    SwordState state;
    Vec3 before = stepSwords(parameters, state, a.at(0.0), b.at(0.0), 1e-4).force_N;
    for (std::size_t k = 0; k < kSteps; ++k) {
      const bool was = state.crossed;
      const SwordTouch now =
          stepSwords(parameters, state, a.at(double(k + 1) / kSteps), b.at(double(k + 1) / kSteps), 1e-4);
      by[k] = length(now.force_N - before);
      before = now.force_N;
      touching += now.touching;
      slid += was && !now.crossed && state.hold < 1.0;
    }
    for (std::size_t k = 1; k + 1 < kSteps; ++k)
      worst_N = std::max(worst_N, by[k] - 2.0 * std::max(by[k - 1], by[k + 1]));
  }
  std::printf("%d steps in touch, %d slides over an end: largest jump %.3f N\n", touching, slid, worst_N);
  EXPECT_GT(touching, 100'000);
  EXPECT_GT(slid, 5);
  EXPECT_LT(worst_N, 0.02);
}

TEST(SwordsTruth, TheForceAtAMomentDoesNotDependOnTheStepsBefore) {
  const Loop a{
      {0.0, 0.0, 9.0}, {{10.0, 0.0, 12.0}, {3.0, 9.0, 0.0}, {0.0, 2.0, 5.0}}, 0.0, {0.2, 0.1, 0.02}, {0.0, 1.0, 2.0}};
  const Loop b{{}, {{0.0, 8.0, 0.0}, {6.0, 0.0, 2.0}, {1.0, 1.0, 1.0}}, 1.4, {0.1, 0.2, 0.01}, {0.4, 0.2, 1.0}};
  SwordParameters parameters;
  parameters.radius_mm = 2.0;
  parameters.damping_Ns_per_mm = 0.0;
  constexpr double kSeconds = 1.0;
  const auto forces = [&](bool jitter) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> step(0.0002, 0.005);
    SwordState state;
    std::vector<Vec3> out;
    double t = 0.0, last = -0.001;
    int next = 0;
    while (next <= 100) {
      const double mark = 0.01 * next;
      const bool at_mark = t >= mark - 1e-12;
      const double now = at_mark ? mark : t;
      const Vec3 force = stepSwords(parameters, state, a.at(now / kSeconds), b.at(now / kSeconds), now - last).force_N;
      if (at_mark) {
        out.push_back(force);
        ++next;
      }
      last = now;
      t = std::min(now + (jitter ? step(random) : 0.001), 0.01 * next);
    }
    return out;
  };
  const auto even = forces(false), uneven = forces(true);
  double largest = 0.0;
  for (std::size_t i = 0; i < even.size(); ++i) {
    ASSERT_NEAR(length(even[i] - uneven[i]), 0.0, 1e-9) << i;
    largest = std::max(largest, length(even[i]));
  }
  EXPECT_GT(largest, 1.0);
}

TEST(SwordsTruth, AThousandTimesLargerOrSmallerIsTheSame) {
  const Loop a{
      {0.0, 0.0, 9.0}, {{10.0, 0.0, 12.0}, {3.0, 9.0, 0.0}, {0.0, 2.0, 5.0}}, 0.0, {0.2, 0.1, 0.02}, {0.0, 1.0, 2.0}};
  const Loop b{{}, {{0.0, 8.0, 0.0}, {6.0, 0.0, 2.0}, {1.0, 1.0, 1.0}}, 1.4, {0.1, 0.2, 0.01}, {0.4, 0.2, 1.0}};
  for (const double scale : {1.0 / 1024.0, 1024.0}) {  // powers of two: the same to the bit but for sliding speeds
    SwordParameters one, other;
    one.damping_Ns_per_mm = other.damping_Ns_per_mm = 0.0;
    one.radius_mm = 2.0;
    other.radius_mm = 2.0 * scale;
    other.fade_mm = one.fade_mm * scale;
    other.stiffness_N_per_mm = one.stiffness_N_per_mm / scale;
    SwordState here, there;
    for (int i = 0; i <= 1000; ++i) {
      const Blade p = a.at(0.001 * i), q = b.at(0.001 * i);
      const auto scaled = [&](const Blade& blade) { return Blade{scale * blade.grip_mm, scale * blade.tip_mm}; };
      const Vec3 force = stepSwords(one, here, p, q, 0.001).force_N;
      ASSERT_EQ(stepSwords(other, there, scaled(p), scaled(q), 0.001).force_N, force) << i;
    }
  }
}

TEST(SwordsTruth, AMillionStepsAtRestDoNotDrift) {
  SwordParameters parameters;
  parameters.radius_mm = 1.0;
  SwordState state;
  const Blade a = posed({0.0, 0.0, 20.0}, 0.0, 0.0), b = posed({}, 1.2, 0.01);
  static_cast<void>(stepSwords(parameters, state, a, b, 0.001));
  const Blade low = posed({0.0, 0.0, -3.0}, 0.0, 0.0);
  static_cast<void>(stepSwords(parameters, state, low, b, 0.001));
  const Vec3 first = stepSwords(parameters, state, low, b, 0.001).force_N;
  Vec3 last;
  for (int i = 0; i < 1'000'000; ++i) last = stepSwords(parameters, state, low, b, i % 2 == 0 ? 0.0002 : 0.005).force_N;
  EXPECT_EQ(first, last);
  EXPECT_GT(first.z, 2.0);
}

/// A hand of 0.3 kg presses its blade against a fixed one with more force than the blade ever gives back, and less.
TEST(SwordsTruth, AHandThatPressesStaysOnItsSide) {
  SwordParameters parameters;
  for (const double hand_N : {1.0, 5.0, 6.3}) {
    SwordState state;
    double z = 30.0, v = -3000.0;
    const Blade fixed = posed({}, M_PI / 2, 0.0);
    double deepest = 0.0;
    for (int i = 0; i < 20'000; ++i) {
      const double dt = i % 3 == 0 ? 0.0004 : 0.001;
      const SwordTouch touch = stepSwords(parameters, state, posed({0.0, 0.0, z}, 0.0, 0.0), fixed, dt);
      v += (touch.force_N.z - hand_N - 2.0 * 1e-3 * v) / 0.3 * 1000.0 * dt;
      z += v * dt;
      deepest = std::min(deepest, z);
      ASSERT_EQ(touch.touching, z - v * dt < 0.0);
    }
    EXPECT_NEAR(z, -hand_N / parameters.stiffness_N_per_mm, 0.2);
    EXPECT_LT(deepest, 0.0);
  }
}

}  // namespace
}  // namespace fyd::scene
