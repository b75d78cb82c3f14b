// A scene as it is shown: its description and placements, and its newest state, passed from the thread that steps it to
// the one that draws it. The stepping thread passes on only the points of soft bodies that are awake, and allocates
// nothing; the drawing thread adds them to the shapes at rest.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/latest_value.h"
#include "core/scene/felt_scene.h"

namespace fyd::scene {

/// Frame and units: the scene's, mm and N.
struct SceneMoment {
  bool stepped = false;  ///< false: the scene has not been stepped yet; the other members have no meaning
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

  /// For the thread that steps: publishes the first moment, and each that is kPublishPeriod_s or more after the last published.
  void show(const FeltScene& scene);
  /// Without shapes: all soft bodies are at rest.
  void show(const SceneMoment& moment);
  static constexpr double kPublishPeriod_s = 0.016;
  /// For one thread that draws; valid until its next call.
  [[nodiscard]] const SceneMoment& newest();

 private:
  struct Displaced {
    std::uint32_t body = 0, vertex = 0;
    Vec3 by_mm;
  };
  struct Published {
    SceneMoment moment;  // without shapes
    std::vector<Displaced> points;
  };

  std::shared_ptr<const LoadedScene> scene_;
  std::vector<Placement> placements_;
  Published next_;  // of the thread that steps
  LatestValue<Published> published_;
  SceneMoment shown_;  // this and the following: of the thread that draws
  std::vector<Displaced> drawn_;
};

}  // namespace fyd::scene
