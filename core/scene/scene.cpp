#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/portable_math.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

constexpr double kMargin = 0.1;  // of the bodies' mean reach: way of the haptic point after which wake() runs again

Vec3 three(const ParameterList& list) { return list.size() == 3 ? Vec3{list[0], list[1], list[2]} : Vec3{}; }

double fromSegment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double all = squared(way);
  const double at = all > 0.0 ? std::clamp(dot(p - from, way) / all, 0.0, 1.0) : 0.0;
  return length(p - (from + at * way));
}

}  // namespace

Placement::Placement(const BodyDescription& body)
    : position_mm(three(body.position_mm)), velocity_mm_per_s(three(body.velocity_mm_per_s)) {
  const Vec3 by = (std::numbers::pi / 180.0) * three(body.turned_deg);
  const double cx = math::cos(by.x), sx = math::sin(by.x), cy = math::cos(by.y), sy = math::sin(by.y),
               cz = math::cos(by.z), sz = math::sin(by.z);
  rows_ = {Vec3{cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx},
           Vec3{sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx}, Vec3{-sy, cy * sx, cy * cx}};
}

Vec3 Placement::turned(const Vec3& way) const { return {dot(rows_[0], way), dot(rows_[1], way), dot(rows_[2], way)}; }

Vec3 Placement::turnedBack(const Vec3& way) const { return way.x * rows_[0] + way.y * rows_[1] + way.z * rows_[2]; }

Contact Scene::Body::touch(const Vec3& probe_mm, const Vec3& velocity_mm_per_s, double dt_s) {
  if (auto* rigid = std::get_if<BodyContact>(&touched)) {
    return rigid->touch(probe_mm, velocity_mm_per_s, nearest->find(probe_mm));
  }
  Contact out;
  out.proxy_mm = probe_mm;
  const SoftContact& soft = std::get<SoftBody>(touched).step(dt_s, probe_mm);
  if (!(dt_s > 0.0) || !soft.touching) return out;
  return {.touching = true,
          .force_N = soft.force_N,
          .proxy_mm = soft.surface_mm,
          .normal = soft.normal,
          .depth_mm = soft.depth_mm,
          .stiffness_N_per_mm = soft.stiffness_N_per_mm,
          .triangle = soft.triangle};
}

Result<Scene::Body> Scene::bodyOf(const BodyDescription& from, std::shared_ptr<const SearchedMesh> with,
                                  const BodyModel& model) {
  const MeshReport& r = with->mesh.report();
  const Vec3 middle_mm = 0.5 * (r.lowest_mm + r.highest_mm);
  const double half_diagonal_mm = 0.5 * length(r.highest_mm - r.lowest_mm);
  if (from.soft) {
    SoftResolution resolution = model.resolution;
    if (from.depth_mm > 0.0) resolution.reach_mm = from.depth_mm;
    auto soft = SoftBody::build(with->tree, materialOf(from), resolution);
    if (!soft) return fail(about(from.name, soft.error().message));
    const double reach_mm = 2.0 * half_diagonal_mm + soft->finger_mm();
    return Body{Placement(from), std::move(with), std::move(*soft), std::nullopt, middle_mm, reach_mm};
  }
  BodyContact contact(with->tree,
                      Surface{.stiffness_N_per_mm = from.stiffness_N_per_mm,
                              .damping_Ns_per_mm = from.damping_Ns_per_mm,
                              .static_friction = from.static_friction,
                              .kinetic_friction = from.kinetic_friction},
                      ContactSettings{.model = model.contact, .radius_mm = from.radius_mm, .reach_mm = from.depth_mm});
  // The mesh's bounding sphere, plus how deep under an open mesh it acts, plus the finger's radius.
  const double reach_mm = half_diagonal_mm + contact.settings().reach_mm + contact.settings().radius_mm;
  const NearestPoint nearest(*with->walkable);
  return Body{Placement(from), std::move(with), std::move(contact), nearest, middle_mm, reach_mm};
}

Result<void> checkMeshes(const SceneDescription& description,
                         std::span<const std::shared_ptr<const SearchedMesh>> meshes) {
  if (meshes.size() != description.bodies.size()) {
    return fail("scene: {} meshes; expected {}, as there are bodies", meshes.size(), description.bodies.size());
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const BodyDescription& body = description.bodies[i];
    if (meshes[i] == nullptr) return fail("{}: no mesh; expected one", body.name);
    if (!body.soft && !meshes[i]->walkable)
      return fail("{}: its mesh is not walkable; expected one for a rigid body", body.name);
  }
  return {};
}

Result<Scene> Scene::build(const SceneDescription& description, std::vector<std::shared_ptr<const SearchedMesh>> meshes,
                           const std::vector<BodyModel>& models) {
  if (auto checked = checkMeshes(description, meshes); !checked) return tl::unexpected(checked.error());
  if (models.size() != description.bodies.size()) {
    return fail("scene: {} models; expected {}, as there are bodies", models.size(), description.bodies.size());
  }
  Scene out;
  out.gestures_ = SceneGestures(description);
  out.bodies_.reserve(description.bodies.size());
  double reaches_mm = 0.0;
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    auto body = bodyOf(description.bodies[i], std::move(meshes[i]), models[i]);
    if (!body) return tl::unexpected(body.error());
    reaches_mm += body->reach_mm;
    out.fastest_mm_per_s_ = std::max(out.fastest_mm_per_s_, length(body->placement.velocity_mm_per_s));
    out.bodies_.push_back(std::move(*body));
  }
  if (!out.bodies_.empty()) out.margin_mm_ = kMargin * reaches_mm / static_cast<double>(out.bodies_.size());
  out.awake_.reserve(out.bodies_.size());
  return out;
}

void Scene::wake(const Vec3& from_mm, double from_s, const Vec3& to_mm) {
  awake_.clear();
  const double beyond_mm = margin_mm_ + fastest_mm_per_s_ * (time_s_ - anchor_s_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    const bool asleep = !body.awake;
    const Vec3 middle_mm = body.placement.toScene(body.middle_mm, time_s_);
    const auto* soft = std::get_if<SoftBody>(&body.touched);
    body.awake = fromSegment(middle_mm, from_mm, to_mm) <= body.reach_mm + beyond_mm ||
                 (soft != nullptr && !soft->awake().empty());  // still moves
    if (!body.awake) continue;
    awake_.push_back(i);
    if (!asleep || soft != nullptr) continue;
    // A proxy must know from which side the haptic point comes.
    const Vec3 before_mm = body.placement.toBody(from_mm, from_s);
    std::get<BodyContact>(body.touched).restore({});
    body.nearest->reset();
    static_cast<void>(body.touch(before_mm, {}, 0.0));
  }
  anchor_mm_ = to_mm;
  anchor_s_ = time_s_;
}

SceneTouch Scene::step(const Vec3& probe_mm, double time_s) {
  SceneTouch out;
  if (!probe_mm.finite() || !std::isfinite(time_s)) {
    out.proxy_mm = last_mm_;
    return out;
  }
  out.proxy_mm = probe_mm;
  if (!known_) first_s_ = time_s;
  const double dt_s = time_s - first_s_ - time_s_;
  if (known_ && !(dt_s > 0.0)) {
    if (dt_s < -kSetBack_s) first_s_ = time_s - time_s_;  // bodies go on from where they are
    return last_;
  }
  const double from_s = time_s_;
  time_s_ = time_s - first_s_;
  const Vec3 from_mm = known_ ? last_mm_ : probe_mm;
  const Vec3 velocity = known_ ? (1.0 / dt_s) * (probe_mm - from_mm) : Vec3{};
  if (!known_ || length(probe_mm - anchor_mm_) + fastest_mm_per_s_ * (time_s_ - anchor_s_) > margin_mm_) {
    wake(from_mm, from_s, probe_mm);
  }
  const bool known = std::exchange(known_, true);
  last_mm_ = probe_mm;
  double largest_N = -1.0;
  int touched = 0;
  std::array<Vec3, 3> together{};  // Σ k n nᵀ
  for (const std::size_t i : awake_) {
    Body& body = bodies_[i];
    const Placement& at = body.placement;
    const Vec3 local_mm = at.toBody(probe_mm, time_s_);
    const Contact contact = body.touch(local_mm, at.turnedBack(velocity - at.velocity_mm_per_s), known ? dt_s : 0.0);
    if (!contact.touching) continue;
    ++touched;
    out.force_N = out.force_N + at.turned(contact.force_N);
    const Vec3 normal = at.turned(contact.normal);
    together[0] = together[0] + (contact.stiffness_N_per_mm * normal.x) * normal;
    together[1] = together[1] + (contact.stiffness_N_per_mm * normal.y) * normal;
    together[2] = together[2] + (contact.stiffness_N_per_mm * normal.z) * normal;
    const double force_N = length(contact.force_N);
    if (!(force_N > largest_N)) continue;
    largest_N = force_N;
    out.body = i;
    out.normal = normal;
    out.proxy_mm = at.toScene(contact.proxy_mm, time_s_);
    out.depth_mm = contact.depth_mm;
    out.stiffness_N_per_mm = contact.stiffness_N_per_mm;
  }
  out.touching = touched > 0;
  if (touched > 1) {
    const Vec3 along = unit(out.force_N);
    out.stiffness_N_per_mm = dot(along, {dot(together[0], along), dot(together[1], along), dot(together[2], along)});
  }
  if (known) gestures_.step(probe_mm, dt_s, !bodies_.empty(), out);
  last_ = out;
  return out;
}

std::size_t Scene::bytes(std::size_t body) const {
  const Body& b = bodies_[body];
  return sizeof(Body) + std::visit([](const auto& touched) { return touched.bytes(); }, b.touched) + b.mesh->bytes();
}

std::size_t Scene::bytes() const {
  std::size_t sum = sizeof(Scene);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const auto& mesh = bodies_[i].mesh;
    const auto here = bodies_.begin() + static_cast<std::ptrdiff_t>(i);
    const bool shared = std::any_of(bodies_.begin(), here, [&mesh](const Body& b) { return b.mesh == mesh; });
    sum += bytes(i) - (shared ? mesh->bytes() : 0);
  }
  return sum;
}

}  // namespace fyd::scene
