#include "core/scene/soft/soft_body.h"

#include <algorithm>
#include <cmath>

#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

/// A needle triangle's cotangents are limited to this by scaling the whole triangle: its matrix stays positive
/// semidefinite.
constexpr double kSteepest = 100.0;
/// A finger spans at least this many mean edges, so that its weights change smoothly from vertex to vertex.
constexpr double kFewestEdges = 3.0;
/// Finger radii. A hand farther than this from a sleeping body is not checked again until it moved by the excess.
constexpr double kNearFingers = 5.0;

}  // namespace

Result<SoftBody> SoftBody::build(const TriangleTree& tree, const SoftMaterial& material,
                                 const SoftResolution& resolution) {
  const auto good = checked(material);
  if (!good) return tl::unexpected(good.error());
  const auto positive = [](double x) { return std::isfinite(x) && x > 0.0; };
  if (!positive(resolution.border) || resolution.border >= 1.0) {
    return fail("border of a soft body is {}; expected between 0 and 1", resolution.border);
  }
  if (!positive(resolution.longest_step_s)) {
    return fail("longest_step_s of a soft body is {}; expected more than 0", resolution.longest_step_s);
  }
  if (resolution.most_parts < 1) {
    return fail("most_parts of a soft body is {}; expected 1 or more", resolution.most_parts);
  }
  if (!positive(resolution.tolerance) || resolution.tolerance >= 1.0) {
    return fail("tolerance of a soft body is {}; expected between 0 and 1", resolution.tolerance);
  }
  if (!positive(resolution.reach_mm)) {
    return fail("reach_mm of a soft body is {}; expected more than 0", resolution.reach_mm);
  }
  if (resolution.most_points < 3) {
    return fail("most_points of a soft body is {}; expected 3 or more", resolution.most_points);
  }
  return SoftBody(tree, material, resolution);
}

SoftBody::SoftBody(const TriangleTree& tree, const SoftMaterial& material, const SoftResolution& resolution)
    : tree_(&tree), material_(material), resolution_(resolution), solver_(tree.mesh().vertices().size()) {
  const MeshReport& report = tree.mesh().report();
  finger_mm_ = std::max(material.finger_mm, kFewestEdges * report.mean_edge_mm);
  material_.finger_mm = finger_mm_;
  surface_ = surfaceOf(material_, report.area_mm2);
  assemble();
  const std::size_t n = tree.mesh().vertices().size();
  u_.assign(n, {});
  v_.assign(n, {});
  elastic_.assign(n, {});
  inertia_.assign(n, 0.0);
  rhs_.assign(n, Four::Zero());
  solution_.assign(n, Four::Zero());
  is_awake_.assign(n, 0);
  weight_.assign(n, 0.0);
  slope_.assign(n, {});
  visited_.assign(n, 0);
  is_near_.assign(n, 0);
  awake_.reserve(n);
  pressed_.reserve(n);
  queue_.reserve(n);
}

void SoftBody::assemble() {
  const auto vertices = tree_->mesh().vertices();
  const auto triangles = tree_->mesh().triangles();
  const std::size_t n = vertices.size();
  struct Tie {
    std::uint32_t from, to;
    double value;
  };
  std::vector<Tie> ties;
  ties.reserve(6 * triangles.size());
  area_.assign(n, 0.0);
  for (const Triangle& t : triangles) {
    std::array<double, 3> cotangent{};
    double steepest = 0.0, doubled = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 a = vertices[t[(c + 1) % 3]] - vertices[t[c]], b = vertices[t[(c + 2) % 3]] - vertices[t[c]];
      doubled = length(cross(a, b));
      cotangent[c] = dot(a, b) / doubled;
      steepest = std::max(steepest, std::abs(cotangent[c]));
    }
    const double softer = steepest > kSteepest ? kSteepest / steepest : 1.0;
    for (std::size_t c = 0; c < 3; ++c) {
      area_[t[c]] += doubled / 6.0;
      const double value = 0.5 * surface_.tension_N_per_mm * softer * cotangent[c];
      const std::uint32_t i = t[(c + 1) % 3], j = t[(c + 2) % 3];
      ties.push_back({i, j, value});
      ties.push_back({j, i, value});
    }
  }
  std::stable_sort(ties.begin(), ties.end(),
                   [](const Tie& a, const Tie& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  stiffness_.diagonal.resize(n);
  mass_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    stiffness_.diagonal[i] = surface_.foundation_N_per_mm3 * area_[i];
    mass_[i] = surface_.mass_Ns2_per_mm3 * area_[i];
  }
  stiffness_.first.assign(n + 1, 0);
  for (std::size_t i = 0; i < ties.size();) {
    double value = 0.0;
    std::size_t j = i;
    for (; j < ties.size() && ties[j].from == ties[i].from && ties[j].to == ties[i].to; ++j) value += ties[j].value;
    stiffness_.diagonal[ties[i].from] += value;
    stiffness_.column.push_back(ties[i].to);
    stiffness_.value.push_back(-value);
    ++stiffness_.first[ties[i].from + 1];
    i = j;
  }
  for (std::size_t i = 0; i < n; ++i) stiffness_.first[i + 1] += stiffness_.first[i];
}

void SoftBody::reset() {
  sleepWhole();
  contact_ = {};
  hand_known_ = false;
  hint_ = kNoTriangle;
}

std::size_t SoftBody::bytes() const {
  const std::size_t n = u_.size();
  return n * (5 * sizeof(Vec3) + 5 * sizeof(Four) + 4 * sizeof(double) + 5 * sizeof(std::uint32_t) + 1) +
         stiffness_.column.size() * (sizeof(double) + sizeof(std::uint32_t));
}

const SoftContact& SoftBody::step(double step_s, const Vec3& hand_mm) {
  contact_ = {};
  if (!(step_s > 0.0) || !std::isfinite(step_s) || !hand_mm.finite()) {
    hand_known_ = false;
    return contact_;
  }
  // Half a part more or less is left to the parts' length: the loop's jitter costs nothing. The bound keeps a late step
  // from making the next one later still; the equations are stable at any step.
  const double wanted = std::ceil(step_s / resolution_.longest_step_s - 0.5);
  const int parts = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(resolution_.most_parts)));
  const Vec3 from = hand_known_ ? last_hand_mm_ : hand_mm;
  for (int i = 1; i <= parts; ++i) {
    const double share = i / static_cast<double>(parts);
    substep(step_s / parts, i == parts ? hand_mm : from + share * (hand_mm - from));
  }
  limitToPaidEnergy(hand_mm - from);
  last_hand_mm_ = hand_mm;
  hand_known_ = true;
  return contact_;
}

void SoftBody::limitToPaidEnergy(const Vec3& moved) {
  if (awake_.empty()) return;
  const double back = dot(contact_.force_N, moved);
  const double most = paid_mJ_ - energy_mJ_;
  // Where steps are too long for the body's dynamics the hand's force is reduced, or raised up to twice.
  double share = 1.0;
  if (back > most && back != 0.0) share = std::clamp(most / back, 0.0, 2.0);
  contact_.force_N = share * contact_.force_N;
  paid_mJ_ -= share * back;
}

SoftTouch SoftBody::touch(double date_s) const {
  SoftTouch t;
  t.date_s = date_s;
  t.near = contact_.triangle != kNoTriangle;
  t.normal = contact_.normal;
  t.stiffness_N_per_mm = material_.rigidity_N_per_mm;
  t.reach_mm = resolution_.reach_mm;
  t.surface_mm = contact_.touching ? last_hand_mm_ + (force_N_ / material_.rigidity_N_per_mm) * contact_.normal
                                   : contact_.surface_mm;
  return t;
}

void SoftBody::substep(double h, const Vec3& hand) {
  if (awake_.empty() && squared(hand - clear_at_mm_) < clear_mm_ * clear_mm_) return;
  clear_mm_ = 0.0;

  // The surface under the hand. The rest position of the point that it meets is the hand's less the displacement there.
  Place place = placeUnder(hand - sunk_mm_);
  if (place.found && !awake_.empty()) {
    sunk_mm_ = underFinger();
    place = placeUnder(hand - sunk_mm_);
  }
  contact_ = {};
  contact_.stiffness_N_per_mm = material_.rigidity_N_per_mm;
  // Both forces follow from one height, that of the hand above the deformed surface along the surface's normal at rest:
  // on the body along that normal, on the hand along the height's gradient at the step's end. So the hand's work equals
  // the work on the body, and a body pushed obliquely does not oscillate under a hand at rest.
  double gap = 0.0;
  bool may = false;
  if (place.found) {
    sunk_mm_ = underFinger();
    gap = dot(place.normal, hand - place.at_mm - sunk_mm_);
    may = place.aside_mm <= finger_mm_ && gap > -resolution_.reach_mm;
    contact_.triangle = place.aside_mm <= finger_mm_ ? place.triangle : kNoTriangle;
    contact_.normal = unit(gradientUnder(place));
    contact_.surface_mm = place.at_mm + sunk_mm_;
  }
  if (awake_.empty() && !(may && gap < 0.0)) {
    force_N_ = 0.0;
    clear_at_mm_ = hand;
    clear_mm_ = gap > 0.0 ? std::max(0.0, length(hand - place.at_mm) - kNearFingers * finger_mm_) : 0.0;
    return;
  }
  if (may && (gap < 0.0 || force_N_ > 0.0)) {
    wakeAround(place);
  } else {
    woken_ = false;
  }

  // (m/h² + (1 + relaxation/h)·K)·du = m·v/h − K·u + force, and the same with the unit press at the right.
  const double scale = 1.0 + surface_.relaxation_s / h;
  const double before_N = may ? force_N_ : 0.0;
  double press = 0.0;
  for (const std::uint32_t i : awake_) {
    inertia_[i] = mass_[i] / (h * h);
    const double w = may ? weight_[i] : 0.0;
    const Vec3 b = (mass_[i] / h) * v_[i] - elastic_[i] - (w * before_N) * place.normal;
    rhs_[i] = Four(b.x, b.y, b.z, w);
    if (w > 0.0) press += w * w / (inertia_[i] + scale * stiffness_.diagonal[i]);
  }
  if (h != last_step_s_) {
    for (const std::uint32_t i : awake_) solution_[i].head<3>() *= last_step_s_ > 0.0 ? h / last_step_s_ : 0.0;
  }
  last_step_s_ = h;
  const double of_force = before_N * before_N * press;
  solver_.solve(stiffness_, scale, inertia_, awake_, rhs_, solution_, resolution_.tolerance,
                Four(of_force, of_force, of_force, 0.0));
  double force = 0.0;
  if (may) {
    double response = 0.0;
    Vec3 moved{};
    for (const std::uint32_t i : pressed_) {
      response += weight_[i] * solution_[i][3];
      moved = moved + weight_[i] * Vec3{solution_[i][0], solution_[i][1], solution_[i][2]};
    }
    if (response > 0.0) force = std::max(0.0, before_N + (dot(place.normal, moved) - gap) / response);
  }
  const double more = force - before_N;
  double worked = 0.0;
  for (const std::uint32_t i : awake_) {
    const Four& a = solution_[i];
    const Vec3 du = Vec3{a[0], a[1], a[2]} - (more * a[3]) * place.normal;
    u_[i] = u_[i] + du;
    v_[i] = (1.0 / h) * du;
    if (may) worked -= force * weight_[i] * dot(place.normal, du);
  }
  force_N_ = force;
  work_mJ_ += worked;
  if (place.found) sunk_mm_ = underFinger();
  contact_.touching = force > 0.0;
  if (contact_.touching) {
    const Vec3 gradient = gradientUnder(place);
    contact_.normal = unit(gradient);
    contact_.force_N = force * gradient;
  }
  contact_.surface_mm = place.at_mm + sunk_mm_;
  contact_.depth_mm = contact_.touching ? dot(contact_.normal, place.at_mm - hand) : 0.0;
  measure();
  wakeWhereItMatters();
  fallAsleep();
}

}  // namespace fyd::scene
