// A scene as it is shown: what of it stands, and its newest moment, from the thread that steps it to one that draws it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/base/latest_value.h"
#include "core/scene/felt_scene.h"

namespace fyd::scene {

/// Frame and units: the scene's, mm and N.
struct SceneMoment {
  bool stepped = false;  ///< false: nobody has touched the scene yet, and the rest says nothing
  double time_s = 0.0;   ///< since the first step; bodies fly with it
  Vec3 point_mm;         ///< the haptic point
  SceneTouch touch;
  std::optional<SwordState> swords;
  std::optional<BallGameState> ball;
  /// Vertices of each soft body that has been pressed, in its own coordinates; empty for the others.
  std::vector<std::vector<Vec3>> shapes_mm;
};

class SceneStage {
 public:
  explicit SceneStage(std::shared_ptr<const LoadedScene> scene);

  [[nodiscard]] const LoadedScene& scene() const { return *scene_; }
  /// Of each body, at time 0.
  [[nodiscard]] const std::vector<Placement>& placements() const { return placements_; }

  /// By the thread that steps: the first moment, and each that is kShown_s or more after the one shown before.
  void show(const FeltScene& scene);
  void show(const SceneMoment& moment) { newest_.write(moment); }
  static constexpr double kShown_s = 0.016;
  /// By one thread that draws; valid until its next call.
  [[nodiscard]] const SceneMoment& newest() { return newest_.read(); }

 private:
  std::shared_ptr<const LoadedScene> scene_;
  std::vector<Placement> placements_;
  SceneMoment moment_;
  LatestValue<SceneMoment> newest_;
};

}  // namespace fyd::scene
