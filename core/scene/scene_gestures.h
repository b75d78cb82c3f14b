// The tele-gesture paper's three gestures in a scene. The haptic point is
//   swords      the grip of a sword that points along x and rises by kBladesRise_rad, at `fencing.scale` times the
//               point's position; the other player's rises likewise and does not move
//   ball        the centre of a racket whose normal points along +z; a ball that no longer bounces on the court is
//               served again
//   palpation   the probe: on the bodies of the scene, or on the plane if the scene has no body
// Only the gestures that the description names exist.
// Stability: may change
#pragma once

#include <cstddef>

#include <optional>

#include "core/base/api.h"
#include "core/scene/scene_description.h"

namespace fyd::scene {

inline constexpr std::size_t kNoBody = static_cast<std::size_t>(-1);

/// What the haptic point of a scene feels.
struct SceneTouch {
  bool touching = false;
  Vec3 force_N;   ///< on the haptic point
  Vec3 proxy_mm;  ///< of what pushes most; the haptic point if nothing is touched
  Vec3 normal;
  double depth_mm = 0.0;
  double stiffness_N_per_mm = 0.0;  ///< along the force; 0 if nothing is touched
  std::size_t body = kNoBody;       ///< that pushes most; kNoBody: a gesture, or nothing is touched

  template <class Archive>
  void serialize(Archive& archive) {
    std::uint64_t number = body;
    archive(touching, force_N, proxy_mm, normal, depth_mm, stiffness_N_per_mm, number);
    body = static_cast<std::size_t>(number);
  }
};

class FYD_API SceneGestures {
 public:
  SceneGestures() = default;
  explicit SceneGestures(const SceneDescription& description);

  /// Adds the gestures' forces to those of the bodies. @param dt_s > 0 @param with_bodies whether the scene has any
  void step(const Vec3& probe_mm, double dt_s, bool with_bodies, SceneTouch& touch);

  /// As of the last step.
  [[nodiscard]] const std::optional<SwordState>& swords() const { return swords_; }
  [[nodiscard]] const std::optional<BallGameState>& ball() const { return ball_; }
  [[nodiscard]] const std::optional<PalpationForce>& palpation() const { return palpated_; }

  /// What the next steps depend on.
  template <class Archive>
  void serialize(Archive& archive) {
    if (swords_) archive(*swords_);
    if (ball_) archive(*ball_);
    if (palpating_) archive(*palpating_);
  }

 private:
  void fence(const Vec3& probe_mm, double dt_s, SceneTouch& touch);
  void play(const Vec3& probe_mm, double dt_s, SceneTouch& touch);
  void palpate(const Vec3& probe_mm, double dt_s, bool with_bodies, SceneTouch& touch);

  SwordParameters sword_;
  FencingParameters fencing_;
  BallParameters ball_game_;
  BallState served_;
  PalpationParameters palpation_;
  PlaneParameters plane_;
  std::optional<SwordState> swords_;
  std::optional<BallGameState> ball_;
  std::optional<PalpationState> palpating_;
  std::optional<PalpationForce> palpated_;
};

}  // namespace fyd::scene
