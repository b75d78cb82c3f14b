// The scene's panel of the Operate place: what stands where the robot stands, and what the finger touches of it.
#pragma once

#include <memory>

#include "app/console/background.h"
#include "app/console/side_dock.h"
#include "widgets/scene_view.h"

namespace fyd::scene {
class SceneStage;
}

namespace fyd::console {

class SceneDock : public SideDock {
  Q_OBJECT
 public:
  explicit SceneDock(QWidget* parent = nullptr);

  /// As it is now; comes with every picture. A session with another scene opens the panel, one without closes it.
  void showScene(const std::shared_ptr<scene::SceneStage>& stage);
  /// Lets the mouse in the picture lead the simulated finger, where a scene is shown.
  void setTouchable(bool on) { touchable_ = on; }

  [[nodiscard]] widgets::SceneView* view() const { return view_; }

 signals:
  /// The simulated finger, so that the haptic point comes to where the mouse leads it.
  void fingerMoved(double x_mm, double y_mm, double indentation_mm);
  void fingerReleased();

 private:
  void prepare();
  SceneDock(widgets::SceneView* view, QWidget* parent);

  widgets::SceneView* view_;
  std::shared_ptr<scene::SceneStage> stage_;
  bool looked_ = false;  ///< whether there is a scene is known
  bool touchable_ = false;
  Background preparing_;  ///< the bodies as they are drawn: a large mesh takes a while
};

}  // namespace fyd::console
