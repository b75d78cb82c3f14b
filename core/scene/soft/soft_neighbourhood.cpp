// Which part of a soft body is computed: the place under the finger, and the points that are awake.
#include <algorithm>
#include <cmath>

#include "core/scene/mesh/vector.h"
#include "core/scene/soft/soft_body.h"

namespace fyd::scene {
namespace {

/// A press wakes what lies this many spreads beyond the finger: e^−4.6 is 1 %.
constexpr double kSpreads = 4.6;
/// A point falls asleep below this share of the largest displacement and of the largest speed.
constexpr double kStill = 1e-3;
/// Displacements are compared with the largest, or with this share of the largest since the body woke if that is more.
constexpr double kFaded = 0.01;
/// An untouched body falls asleep as a whole at this share of the largest displacement since it woke.
constexpr double kWholeStill = 1e-5;

}  // namespace

SoftBody::Place SoftBody::placeUnder(const Vec3& hand_mm) {
  const Mesh& mesh = tree_->mesh();
  const Nearest nearest = tree_->nearest(hand_mm, hint_);
  Place place;
  if (nearest.triangle == kNoTriangle) return place;
  hint_ = nearest.triangle;
  place.found = true;
  place.at_mm = nearest.point_mm;
  place.triangle = nearest.triangle;
  const Triangle& t = mesh.triangles()[nearest.triangle];
  place.normal = unit((1.0 - nearest.at_1 - nearest.at_2) * mesh.vertexNormal(t[0]) +
                      nearest.at_1 * mesh.vertexNormal(t[1]) + nearest.at_2 * mesh.vertexNormal(t[2]));
  const Vec3 off = hand_mm - nearest.point_mm;
  place.aside_mm = nearest.feature == Feature::inside ? 0.0 : length(off - dot(off, place.normal) * place.normal);
  // The weights of the vertices within the finger's radius, whose sum is 1, and how they change as it moves.
  for (const std::uint32_t i : pressed_) weight_[i] = 0.0;
  pressed_.clear();
  queue_.clear();
  ++visit_;
  const auto meet = [&](std::uint32_t i) {
    if (visited_[i] == visit_) return;
    visited_[i] = visit_;
    queue_.push_back(i);
  };
  for (const std::uint32_t i : t) meet(i);
  const double radius2 = finger_mm_ * finger_mm_;
  double sum = 0.0;
  Vec3 slopes{};
  for (std::size_t at = 0; at < queue_.size(); ++at) {  // NOLINT(modernize-loop-convert): the queue grows meanwhile
    const std::uint32_t i = queue_[at];
    const Vec3 from = mesh.vertices()[i] - place.at_mm;
    const double inside = 1.0 - squared(from) / radius2;
    if (!(inside > 0.0)) continue;
    weight_[i] = area_[i] * inside * inside;
    slope_[i] = (area_[i] * 4.0 * inside / radius2) * from;
    sum += weight_[i];
    slopes = slopes + slope_[i];
    pressed_.push_back(i);
    for (std::uint32_t e = stiffness_.first[i]; e < stiffness_.first[i + 1]; ++e) meet(stiffness_.column[e]);
  }
  if (!(sum > 0.0)) {  // a triangle much larger than the finger: its three vertices
    const double share[3] = {1.0 - nearest.at_1 - nearest.at_2, nearest.at_1, nearest.at_2};
    for (std::size_t c = 0; c < 3; ++c) {
      weight_[t[c]] = std::max(0.0, share[c]);
      slope_[t[c]] = {};
      pressed_.push_back(t[c]);
    }
    return place;
  }
  for (const std::uint32_t i : pressed_) {
    weight_[i] /= sum;
    slope_[i] = (1.0 / sum) * slope_[i] - (weight_[i] / sum) * slopes;
  }
  return place;
}

bool SoftBody::wake(std::uint32_t i) {
  if (is_awake_[i] != 0) return true;
  if (awake_.size() >= resolution_.most_points && weight_[i] == 0.0) return false;
  is_awake_[i] = 1;
  awake_.push_back(i);
  solution_[i] = Four::Zero();
  elastic_[i] = elastic(i);
  return true;
}

void SoftBody::wakeAround(const Place& place) {
  const Vec3 moved = place.at_mm - woken_around_mm_;
  if (woken_ && squared(moved) < 0.25 * finger_mm_ * finger_mm_) {
    for (const std::uint32_t i : pressed_) wake(i);
    return;
  }
  woken_ = true;
  woken_around_mm_ = place.at_mm;
  for (const std::uint32_t i : pressed_) wake(i);
  const double reach = 1.5 * finger_mm_ + kSpreads * material_.spread_mm;
  const auto vertices = tree_->mesh().vertices();
  ++visit_;
  ++near_;
  queue_.clear();
  for (const std::uint32_t i : tree_->mesh().triangles()[place.triangle]) {
    visited_[i] = visit_;
    queue_.push_back(i);
  }
  for (std::size_t at = 0; at < queue_.size() && at < resolution_.most_points; ++at) {
    const std::uint32_t i = queue_[at];
    if (squared(vertices[i] - place.at_mm) > reach * reach) continue;
    is_near_[i] = near_;
    wake(i);
    for (std::uint32_t e = stiffness_.first[i]; e < stiffness_.first[i + 1]; ++e) {
      const std::uint32_t j = stiffness_.column[e];
      if (visited_[j] == visit_) continue;
      visited_[j] = visit_;
      queue_.push_back(j);
    }
  }
}

Vec3 SoftBody::elastic(std::uint32_t i) const {
  Vec3 f = stiffness_.diagonal[i] * u_[i];
  for (std::uint32_t e = stiffness_.first[i]; e < stiffness_.first[i + 1]; ++e) {
    f = f + stiffness_.value[e] * u_[stiffness_.column[e]];
  }
  return f;
}

Vec3 SoftBody::underFinger() const {
  Vec3 mean{};
  for (const std::uint32_t i : pressed_) mean = mean + weight_[i] * u_[i];
  return mean;
}

Vec3 SoftBody::gradientUnder(const Place& place) const {
  Vec3 rise{};  // of the deformed surface
  for (const std::uint32_t i : pressed_) rise = rise + dot(place.normal, u_[i]) * slope_[i];
  return place.normal - (rise - dot(rise, place.normal) * place.normal);
}

void SoftBody::measure() {
  double twice = 0.0, largest = 0.0, fastest = 0.0;
  for (const std::uint32_t i : awake_) {
    elastic_[i] = elastic(i);
    const double u2 = squared(u_[i]), v2 = squared(v_[i]);
    twice += dot(u_[i], elastic_[i]) + mass_[i] * v2;
    largest = std::max(largest, u2);
    fastest = std::max(fastest, v2);
  }
  energy_mJ_ = 0.5 * twice;
  largest_mm_ = std::sqrt(largest);
  fastest_mm_per_s_ = std::sqrt(fastest);
  peak_mm_ = std::max(peak_mm_, largest_mm_);
  peak_mJ_ = std::max(peak_mJ_, energy_mJ_);
}

void SoftBody::wakeWhereItMatters() {
  const double matters = resolution_.border * std::max(largest_mm_, kFaded * peak_mm_);
  const std::size_t awake = awake_.size();
  for (std::size_t at = 0; at < awake; ++at) {
    const std::uint32_t i = awake_[at];
    if (squared(u_[i]) <= matters * matters) continue;
    for (std::uint32_t e = stiffness_.first[i]; e < stiffness_.first[i + 1]; ++e) wake(stiffness_.column[e]);
  }
}

void SoftBody::fallAsleep() {
  if (!contact_.touching && largest_mm_ <= kWholeStill * peak_mm_ &&
      energy_mJ_ <= kWholeStill * kWholeStill * peak_mJ_) {
    sleepWhole();
    return;
  }
  const double reference = std::max(largest_mm_, kFaded * peak_mm_);
  const double border = 0.5 * resolution_.border * reference, still = kStill * reference;
  constexpr double kSlow_per_s = 1.0;  // times the displacement: slower speeds are negligible
  const double slow = kStill * std::max(fastest_mm_per_s_, kSlow_per_s * reference);
  const bool full = awake_.size() >= resolution_.most_points;
  std::size_t kept = 0;
  for (const std::uint32_t i : awake_) {
    bool stays = weight_[i] > 0.0 || (woken_ && is_near_[i] == near_);
    if (!stays && !full) {
      stays = squared(u_[i]) > still * still || squared(v_[i]) > slow * slow;
      for (std::uint32_t e = stiffness_.first[i]; !stays && e < stiffness_.first[i + 1]; ++e) {
        stays = squared(u_[stiffness_.column[e]]) > border * border;
      }
    }
    // Energy added by setting the point to rest: it must fit into what has been dissipated before.
    const double more =
        0.5 * stiffness_.diagonal[i] * squared(u_[i]) - dot(u_[i], elastic_[i]) - 0.5 * mass_[i] * squared(v_[i]);
    if (stays || energy_mJ_ + more > work_mJ_) {
      awake_[kept++] = i;
      continue;
    }
    for (std::uint32_t e = stiffness_.first[i]; e < stiffness_.first[i + 1]; ++e) {
      const std::uint32_t j = stiffness_.column[e];
      elastic_[j] = elastic_[j] - stiffness_.value[e] * u_[i];
    }
    energy_mJ_ += more;
    u_[i] = v_[i] = elastic_[i] = {};
    solution_[i] = Four::Zero();
    is_awake_[i] = 0;
  }
  awake_.resize(kept);
}

void SoftBody::sleepWhole() {
  for (const std::uint32_t i : awake_) {
    u_[i] = v_[i] = elastic_[i] = {};
    solution_[i] = Four::Zero();
    is_awake_[i] = 0;
  }
  awake_.clear();
  woken_ = false;
  sunk_mm_ = {};
  force_N_ = energy_mJ_ = largest_mm_ = fastest_mm_per_s_ = peak_mm_ = peak_mJ_ = 0.0;
  work_mJ_ = paid_mJ_ = 0.0;
}

}  // namespace fyd::scene
