// The tele-gesture paper's three gestures in a scene, where the haptic point is
//   swords      the grip of a sword that points along x, `fencing.scale` times as far out; the other player stands
//   still ball        the middle of a racket that looks up palpation   the probe: on the bodies of the scene, or on the
//   plane where it has none
// Only those that the description names are there.
#pragma once

#include <optional>

#include "core/scene/scene_description.h"
#include "core/scene/scene_touch.h"

namespace fyd::scene {

class SceneGestures {
 public:
  SceneGestures() = default;
  explicit SceneGestures(const SceneDescription& description);

  /// Adds what they make the haptic point feel to what the bodies do. @param dt_s > 0 @param with_bodies of the scene
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
  PalpationParameters palpation_;
  PlaneParameters plane_;
  std::optional<SwordState> swords_;
  std::optional<BallGameState> ball_;
  std::optional<PalpationState> palpating_;
  std::optional<PalpationForce> palpated_;
};

}  // namespace fyd::scene
