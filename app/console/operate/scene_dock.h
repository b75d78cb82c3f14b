// The scene panel of the Operate place: the virtual scene in the robot's place, and how the finger touches it.
#pragma once

#include <memory>

#include "app/console/shell/background.h"
#include "app/console/shell/side_dock.h"
#include "widgets/scene/scene_view.h"

namespace fyd::scene {
class SceneStage;
}

namespace fyd::console {

class SceneDock : public SideDock {
  Q_OBJECT
 public:
  explicit SceneDock(QWidget* parent = nullptr);

  /// Shows the scene's present state; called about 60 times a second. A session with another scene opens the
  /// panel, one without closes it.
  void showScene(const std::shared_ptr<scene::SceneStage>& stage);
  /// Lets the mouse in the picture lead the simulated finger, where a scene is shown.
  void setTouchable(bool on);

  [[nodiscard]] widgets::SceneView* view() const { return view_; }

 signals:
  /// Position of the simulated finger that brings the haptic point to the mouse's target.
  void fingerMoved(double x_mm, double y_mm, double indentation_mm);
  void fingerReleased();

 private:
  void prepare();
  SceneDock(widgets::SceneView* view, QWidget* parent);

  widgets::SceneView* view_ = nullptr;
  std::shared_ptr<scene::SceneStage> stage_;
  bool looked_ = false;  ///< whether the first session was checked for a scene
  bool touchable_ = false;
  Background preparing_;  ///< of the meshes for drawing: a large one takes a while
};

}  // namespace fyd::console
