// A deformable body: the vertices of a mesh are heavy, elastic, viscous material points (SoftMaterial), pressed by a
// finger that cannot go through them.
//
// Implicit Euler, linear: stable at any stiffness, mass, viscosity and step; its energy grows only by the work of the
// press. Press and body are solved together: with y the body's response to a unit press within the step, the force is
// the one, ≥ 0, with which the surface under the finger just reaches the finger. It acts on the hand along the normal
// of the deformed surface and on the body along the normal of the surface at rest: so the hand's work equals the work
// on the body. Where steps are too long for that, the hand's force is scaled to make up the difference.
//
// Only points near the press, or that move, are awake; the others stay at their rest position and are not computed. A
// point is woken where the displacement next to it matters, and put to sleep where it no longer does, if the body's
// energy then does not exceed the work done on it. A body that sleeps as a whole costs one comparison while the hand is
// farther from it than five finger radii.
//
// Allocates only when built. Bit-reproducible.
// Stability: may change
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/scene/mesh/triangle_tree.h"
#include "core/scene/soft/soft_material.h"
#include "core/scene/soft/soft_solver.h"
#include "core/scene/soft/soft_touch.h"

namespace fyd::scene {

/// Error against cost.
struct SoftResolution {
  std::size_t most_points = SIZE_MAX;  ///< awake at a time; those nearest to the press first
  double border = 0.01;                ///< a neighbour is woken above this share of the largest displacement
  double longest_step_s = 0.001;       ///< a longer step is divided into equal ones of about this
  int most_parts = 4;                  ///< of a step; a longer one still has longer parts
  double tolerance = 1e-4;             ///< of the linear equations' residual, relative
  double reach_mm = 1e3;               ///< a point deeper below the deformed surface touches nothing
};

struct SoftContact {
  bool touching = false;
  Vec3 force_N;                     ///< on the hand; the body gets the opposite
  Vec3 surface_mm;                  ///< the deformed surface under the finger
  Vec3 normal;                      ///< outwards, of the deformed surface
  double depth_mm = 0.0;            ///< of the hand below the surface at rest, along the normal
  double stiffness_N_per_mm = 0.0;  ///< of a slow press on a wide flat piece
  std::uint32_t triangle = kNoTriangle;
};

class FYD_API SoftBody {
 public:
  /// The tree (and its mesh) must outlive the body. @return an error that names what is out of range
  [[nodiscard]] static Result<SoftBody> build(const TriangleTree& tree, const SoftMaterial& material,
                                              const SoftResolution& resolution = {});

  /// @param step_s > 0; anything else, and a hand that is no number, leaves the body as it was and touches nothing
  const SoftContact& step(double step_s, const Vec3& hand_mm);

  [[nodiscard]] const SoftContact& contact() const { return contact_; }
  /// For the 1 kHz force on another thread.
  [[nodiscard]] SoftTouch touch(double date_s) const;

  /// From its rest position.
  [[nodiscard]] Vec3 displacement_mm(std::uint32_t vertex) const { return u_[vertex]; }
  [[nodiscard]] std::span<const std::uint32_t> awake() const { return awake_; }
  /// Kinetic and elastic.
  [[nodiscard]] double energy_mJ() const { return energy_mJ_; }
  /// Work of the press on the body since it woke.
  [[nodiscard]] double work_mJ() const { return work_mJ_; }
  /// Work of the hand since then, less what it got back. The work of a step is that of the force at its end.
  [[nodiscard]] double paid_mJ() const { return paid_mJ_; }
  [[nodiscard]] const SoftSurface& surface() const { return surface_; }
  /// The finger's radius in use: at least three times the mesh's mean edge.
  [[nodiscard]] double finger_mm() const { return finger_mm_; }
  [[nodiscard]] std::size_t bytes() const;
  /// At rest, asleep.
  void reset();

  /// What the next steps depend on; sleeping points are not stored.
  template <class Archive>
  void serialize(Archive& archive) {
    constexpr bool kLoading = Archive::is_loading::value;
    if constexpr (kLoading) reset();
    archive(hint_, woken_, woken_around_mm_, force_N_, sunk_mm_, last_hand_mm_, hand_known_, clear_at_mm_, clear_mm_,
            last_step_s_, energy_mJ_, work_mJ_, paid_mJ_, largest_mm_, fastest_mm_per_s_, peak_mm_, peak_mJ_);
    if (hint_ != kNoTriangle && hint_ >= tree_->mesh().triangles().size()) throw std::out_of_range("no such triangle");
    const auto last = static_cast<std::uint32_t>(u_.size() - 1);
    auto awake = static_cast<std::uint32_t>(awake_.size());
    archive(within(awake, last + 1));
    for (std::uint32_t k = 0; k < awake; ++k) {
      std::uint32_t i = kLoading ? 0 : awake_[k];
      archive(within(i, last));
      if constexpr (kLoading) {
        if (is_awake_[i] != 0) throw std::out_of_range("a point that is awake twice");
        is_awake_[i] = 1;
        awake_.push_back(i);
      }
      archive(u_[i], v_[i], elastic_[i], solution_[i][0], solution_[i][1], solution_[i][2], solution_[i][3]);
    }
    if constexpr (kLoading) ++near_;
    auto near = woken_ ? static_cast<std::uint32_t>(std::count(is_near_.begin(), is_near_.end(), near_)) : 0U;
    archive(within(near, last + 1));
    std::uint32_t i = 0;
    for (std::uint32_t k = 0; k < near; ++k, ++i) {
      if constexpr (!kLoading) {
        while (is_near_[i] != near_) ++i;
      }
      archive(within(i, last));
      is_near_[i] = near_;
    }
  }

 private:
  SoftBody(const TriangleTree& tree, const SoftMaterial& material, const SoftResolution& resolution);
  void assemble();

  struct Place {
    bool found = false;
    Vec3 at_mm;             // on the surface at rest
    Vec3 normal;            // there
    double aside_mm = 0.0;  // of the hand, along the surface: more than 0 beyond a rim
    std::uint32_t triangle = kNoTriangle;
  };
  /// The nearest place of the surface at rest. The finger's weights become those there.
  [[nodiscard]] Place placeUnder(const Vec3& hand_mm);
  void wakeAround(const Place& place);
  bool wake(std::uint32_t vertex);
  void substep(double step_s, const Vec3& hand_mm);
  void measure();  // updates energy and largest displacement
  void wakeWhereItMatters();
  void fallAsleep();
  void sleepWhole();
  [[nodiscard]] Vec3 elastic(std::uint32_t vertex) const;
  [[nodiscard]] Vec3 underFinger() const;
  /// Gradient of the hand's height above the deformed surface.
  [[nodiscard]] Vec3 gradientUnder(const Place& place) const;
  /// Scales the hand's force so that the body never holds more energy than the hand paid.
  void limitToPaidEnergy(const Vec3& moved_mm);

  const TriangleTree* tree_;
  SoftMaterial material_;
  SoftResolution resolution_;
  SoftSurface surface_;
  double finger_mm_ = 0.0;

  SoftMatrix stiffness_;      // N/mm
  std::vector<double> area_;  // mm²
  std::vector<double> mass_;  // N·s²/mm
  SoftSolver solver_;

  std::vector<Vec3> u_, v_, elastic_;  // displacement, speed, K·u
  std::vector<double> inertia_;        // mass over step²
  std::vector<Four> rhs_, solution_;   // of a step's equations: displacement (x, y, z), response to a unit press
  std::vector<std::uint8_t> is_awake_;
  std::vector<std::uint32_t> awake_;

  // The press.
  std::vector<std::uint32_t> pressed_;  // vertices under the finger
  std::vector<double> weight_;          // of a vertex; 0 where it is not pressed
  std::vector<Vec3> slope_;             // gradient of its weight with the finger's place, 1/mm
  std::vector<std::uint32_t> queue_;
  std::vector<std::uint32_t> visited_, is_near_;  // number of the walk, of the press' surroundings that held the vertex
  std::uint32_t visit_ = 0, near_ = 0;
  std::uint32_t hint_ = kNoTriangle;
  Vec3 woken_around_mm_;
  bool woken_ = false;
  double force_N_ = 0.0;
  Vec3 sunk_mm_;  // the displacement under the finger where it last was
  Vec3 last_hand_mm_;
  bool hand_known_ = false;
  Vec3 clear_at_mm_;  // a hand within clear_mm_ of this point does not touch the sleeping body
  double clear_mm_ = 0.0;

  SoftContact contact_;
  double last_step_s_ = 0.0;
  double energy_mJ_ = 0.0, work_mJ_ = 0.0, paid_mJ_ = 0.0;
  double largest_mm_ = 0.0, fastest_mm_per_s_ = 0.0, peak_mm_ = 0.0, peak_mJ_ = 0.0;
};

}  // namespace fyd::scene
