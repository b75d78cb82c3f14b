// A haptic scene as it is stepped: the bodies that its description names and a haptic point among them.
//
// A scene of one body holds one mesh and one contact. A body that is not near the haptic point sleeps: it is checked
// again only after the point, or the body itself, may have come near.
//
// Forces of several bodies add up. The stiffness felt is that along the force: Σ k (n·f)². The contact that is reported
// is the one with the largest force; of two equal ones the body that stands first.
// Stability: may change
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/scene/contact/contact.h"
#include "core/scene/mesh/nearest_point.h"
#include "core/scene/scene_description.h"
#include "core/scene/scene_gestures.h"
#include "core/scene/soft/soft_body.h"

namespace fyd::scene {

/// A body's mesh with what its searches need. Immutable and shared by any number of bodies; not copied or moved, as the
/// trees point to the mesh.
struct SearchedMesh {
  /// @param walks whether a rigid body uses it: only those need `walkable`
  explicit SearchedMesh(Mesh from, bool walks = true) : mesh(std::move(from)), tree(mesh) {
    if (walks) walkable.emplace(tree);
  }
  SearchedMesh(const SearchedMesh&) = delete;
  SearchedMesh& operator=(const SearchedMesh&) = delete;
  [[nodiscard]] std::size_t bytes() const { return mesh.bytes() + tree.bytes() + (walkable ? walkable->bytes() : 0); }
  Mesh mesh;
  TriangleTree tree;
  std::optional<WalkableMesh> walkable;
};

/// How a mesh stands in the scene: turned about x, then y, then z, then moved.
class FYD_API Placement {
 public:
  Placement() = default;
  explicit Placement(const BodyDescription& body);
  [[nodiscard]] Vec3 toBody(const Vec3& point_mm, double time_s) const {
    return turnedBack(point_mm - position_mm - time_s * velocity_mm_per_s);
  }
  [[nodiscard]] Vec3 toScene(const Vec3& point_mm, double time_s) const {
    return turned(point_mm) + position_mm + time_s * velocity_mm_per_s;
  }
  [[nodiscard]] Vec3 turned(const Vec3& way) const;
  [[nodiscard]] Vec3 turnedBack(const Vec3& way) const;

  Vec3 position_mm, velocity_mm_per_s;

 private:
  std::array<Vec3, 3> rows_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
};

/// Of a soft body for which no accuracy is asked: a step stays within a millisecond.
inline constexpr std::size_t kUsualPoints = 1000;

/// A time that is earlier by more than this is another clock's; by less, it came too late.
inline constexpr double kSetBack_s = 1.0;

/// What the description of a body may leave open.
struct BodyModel {
  ContactModel contact = ContactModel::vicinity;              ///< of a rigid body
  SoftResolution resolution = {.most_points = kUsualPoints};  ///< of a soft one
};

/// Whether there is a mesh for each body of the description, walkable for a rigid one.
[[nodiscard]] FYD_API Result<void> checkMeshes(const SceneDescription& description,
                                               std::span<const std::shared_ptr<const SearchedMesh>> meshes);

class FYD_API Scene {
 public:
  /// @param meshes as checkMeshes wants them @param models one for each body of the description
  /// @return the error of checkMeshes, or one that names the body and what of its material is out of range
  [[nodiscard]] static Result<Scene> build(const SceneDescription& description,
                                           std::vector<std::shared_ptr<const SearchedMesh>> meshes,
                                           const std::vector<BodyModel>& models);

  /// One step; allocates nothing. A haptic point or a time that is no number touches nothing and moves nothing; if
  /// `time_s` did not increase, the last touch is returned again; if it is more than kSetBack_s earlier, the caller's
  /// clock was set back, and time goes on from there.
  /// @param time_s of the caller's clock; bodies fly from where they are at the first step
  SceneTouch step(const Vec3& probe_mm, double time_s);

  [[nodiscard]] std::size_t bodies() const { return bodies_.size(); }
  [[nodiscard]] std::size_t awake() const { return awake_.size(); }
  /// Of the last step, since the first.
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] const Mesh& mesh(std::size_t body) const { return bodies_[body].mesh->mesh; }
  [[nodiscard]] const Placement& placement(std::size_t body) const { return bodies_[body].placement; }
  /// Of a rigid body.
  [[nodiscard]] const BodyContact* contact(std::size_t body) const {
    return std::get_if<BodyContact>(&bodies_[body].touched);
  }
  /// Of a soft body.
  [[nodiscard]] const SoftBody* soft(std::size_t body) const { return std::get_if<SoftBody>(&bodies_[body].touched); }
  /// For drawing.
  [[nodiscard]] const SceneGestures& gestures() const { return gestures_; }
  /// Memory in use, with meshes and trees; a mesh that several bodies share is counted once.
  [[nodiscard]] std::size_t bytes() const;
  /// Of one body, with what it shares.
  [[nodiscard]] std::size_t bytes(std::size_t body) const;

  /// What the next steps depend on, without what it was built from.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(known_, first_s_, time_s_, last_mm_, last_, gestures_, anchor_mm_, anchor_s_);
    if (last_.body != kNoBody && last_.body >= bodies_.size()) throw std::out_of_range("no such body");
    awake_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body& body = bodies_[i];
      archive(body.awake);
      if (body.awake) awake_.push_back(i);
      std::visit([&archive](auto& touched) { archive(touched); }, body.touched);
      if (body.nearest) archive(*body.nearest);
    }
  }

 private:
  struct Body {
    Placement placement;
    std::shared_ptr<const SearchedMesh> mesh;
    std::variant<BodyContact, SoftBody> touched;
    std::optional<NearestPoint> nearest;  // of a rigid body
    Vec3 middle_mm;                       // of the mesh
    double reach_mm = 0.0;                // from it, beyond which nothing is felt
    bool awake = false;

    /// @param dt_s 0 at the first step: a soft body is then not stepped
    [[nodiscard]] Contact touch(const Vec3& probe_mm, const Vec3& velocity_mm_per_s, double dt_s);
  };

  Scene() = default;
  [[nodiscard]] static Result<Body> bodyOf(const BodyDescription& from, std::shared_ptr<const SearchedMesh> with,
                                           const BodyModel& model);
  /// Which bodies may be touched before the haptic point has moved `margin_mm_`.
  void wake(const Vec3& from_mm, double from_s, const Vec3& to_mm);

  std::vector<Body> bodies_;
  std::vector<std::size_t> awake_;
  double margin_mm_ = 0.0;
  double fastest_mm_per_s_ = 0.0;  // of the bodies
  bool known_ = false;
  double first_s_ = 0.0;
  double time_s_ = 0.0;  // since then
  Vec3 last_mm_;
  SceneTouch last_;
  SceneGestures gestures_;
  Vec3 anchor_mm_;
  double anchor_s_ = 0.0;
};

}  // namespace fyd::scene
