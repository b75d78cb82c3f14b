// A scene as it is shown: its file, which stands, and its newest moment, from the thread that steps it to one that
// draws it.
#pragma once

#include <utility>

#include "core/base/latest_value.h"
#include "core/sim/scene_file.h"

namespace fyd::sim {

/// Frame and units: the scene's, mm and N.
struct SceneMoment {
  bool stepped = false;  ///< false: nobody has touched the scene yet, and the rest says nothing
  double time_s = 0.0;   ///< since the first step; bodies fly with it
  Vec3 point_mm;         ///< the haptic point
  scene::SceneTouch touch;
  std::optional<scene::SwordState> swords;
  std::optional<scene::BallGameState> ball;
  /// Vertices of each soft body that has been pressed, in its own coordinates; empty for the others.
  std::vector<std::vector<Vec3>> shapes_mm;
};

class SceneStage {
 public:
  explicit SceneStage(SceneFile file) : file_(std::move(file)) {
    for (const scene::BodyDescription& body : file_.description.bodies) placements_.emplace_back(body);
  }

  [[nodiscard]] const SceneFile& file() const { return file_; }
  /// Of each body, at time 0.
  [[nodiscard]] const std::vector<scene::Placement>& placements() const { return placements_; }

  /// By the thread that steps.
  void show(const SceneMoment& moment) { newest_.write(moment); }
  /// By one thread that draws; valid until its next call.
  [[nodiscard]] const SceneMoment& newest() { return newest_.read(); }

 private:
  SceneFile file_;
  std::vector<scene::Placement> placements_;
  LatestValue<SceneMoment> newest_;
};

}  // namespace fyd::sim
