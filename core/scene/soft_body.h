// A deformable body: the vertices of a mesh are heavy, elastic, viscous material points (SoftMaterial), pressed by a
// finger that cannot go through them.
//
// Implicit Euler, linear: stable at any stiffness, mass, viscosity and step, and its energy never grows but by the work
// of the press. The press is solved with the body, not after it: with y the body's answer to a unit press within the
// step, the force is the one, ≥ 0, with which the surface under the finger just reaches the finger. The hand feels it
// along the normal of the deformed surface, the body along that of the surface at rest: what each of the two works is
// what the other gets. Where steps are too long for that the hand pays the difference.
//
// Only points near the press, or that move, are awake; others stand at their rest place and are not looked at. Points
// are woken where the displacement next to them matters and fall asleep where it no longer does, if the energy which
// that frees or takes leaves the body no more than was worked into it. A body that sleeps whole costs a comparison.
//
// Allocates only when built. Bit-reproducible.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/base/state.h"
#include "core/scene/soft_material.h"
#include "core/scene/soft_solver.h"
#include "core/scene/soft_touch.h"
#include "core/scene/triangle_tree.h"

namespace fyd::scene {

/// Error against cost.
struct SoftResolution {
  std::size_t most_points = SIZE_MAX;  ///< awake at a time; those nearest to the press first
  double border = 0.01;                ///< a neighbour is woken above this share of the largest displacement
  double longest_step_s = 0.001;       ///< a longer step is made of equal ones no longer than this
  double tolerance = 1e-4;             ///< of the linear equations
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

class SoftBody {
 public:
  /// The tree (and its mesh) must outlive the body. @return an error that names what is out of range
  [[nodiscard]] static Result<SoftBody> build(const TriangleTree& tree, const SoftMaterial& material,
                                              const SoftResolution& resolution = {});

  /// @param step_s > 0; anything else, and a hand that is no number, leaves the body as it was and touches nothing
  const SoftContact& step(double step_s, const Vec3& hand_mm);

  [[nodiscard]] const SoftContact& contact() const { return contact_; }
  /// For the 1 kHz force on another thread.
  [[nodiscard]] SoftTouch touch(double date_s) const;

  /// From its rest place.
  [[nodiscard]] Vec3 displacement_mm(std::uint32_t vertex) const { return u_[vertex]; }
  [[nodiscard]] std::span<const std::uint32_t> awake() const { return awake_; }
  /// Kinetic and elastic.
  [[nodiscard]] double energy_mJ() const { return energy_mJ_; }
  /// What the press worked on it since it woke.
  [[nodiscard]] double work_mJ() const { return work_mJ_; }
  /// What the hand worked since then, less what it got back: a step's is that of the force at its end.
  [[nodiscard]] double paid_mJ() const { return paid_mJ_; }
  [[nodiscard]] const SoftSurface& surface() const { return surface_; }
  /// The finger's radius in use: at least three times the mesh's mean edge.
  [[nodiscard]] double finger_mm() const { return finger_mm_; }
  [[nodiscard]] int iterations() const { return iterations_; }  ///< of the last step
  [[nodiscard]] std::size_t bytes() const;
  /// At rest, asleep.
  void reset();

  /// What the next steps depend on: points that sleep take no room.
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
      archive(u_[i], v_[i], elastic_[i], answer_[i][0], answer_[i][1], answer_[i][2], answer_[i][3]);
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
  void part(double step_s, const Vec3& hand_mm);
  void measure();  // energy and largest displacement
  void wakeWhereItMatters();
  void fallAsleep();
  void sleepWhole();
  [[nodiscard]] Vec3 elastic(std::uint32_t vertex) const;
  [[nodiscard]] Vec3 underFinger() const;
  /// Of the hand's height above the deformed surface.
  [[nodiscard]] Vec3 gradientUnder(const Place& place) const;
  /// The hand's ledger: its body never holds more than it paid.
  void payFor(const Vec3& moved_mm);

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
  std::vector<Four> right_, answer_;   // of the equations: three of the displacement in a step, one of the unit press
  std::vector<std::uint8_t> is_awake_;
  std::vector<std::uint32_t> awake_;

  // The press.
  std::vector<std::uint32_t> pressed_;  // vertices under the finger
  std::vector<double> weight_;          // of a vertex; 0 where it is not pressed
  std::vector<Vec3> slope_;             // of its weight, as the finger moves
  std::vector<std::uint32_t> queue_;
  std::vector<std::uint32_t> visited_, is_near_;  // in the walk, in the last press' surroundings, of that number
  std::uint32_t visit_ = 0, near_ = 0;
  std::uint32_t hint_ = kNoTriangle;
  Vec3 woken_around_mm_;
  bool woken_ = false;
  double force_N_ = 0.0;
  Vec3 sunk_mm_;  // the displacement under the finger where it last was
  Vec3 last_hand_mm_;
  bool hand_known_ = false;
  Vec3 clear_at_mm_;       // a sleeping body is not touched by a hand
  double clear_mm_ = 0.0;  // within this of there

  SoftContact contact_;
  double last_step_s_ = 0.0;
  double energy_mJ_ = 0.0, work_mJ_ = 0.0, paid_mJ_ = 0.0;
  double largest_mm_ = 0.0, fastest_mm_per_s_ = 0.0, peak_mm_ = 0.0, peak_mJ_ = 0.0;
  int iterations_ = 0;
};

}  // namespace fyd::scene
