// The place "Operate": the running session. Camera and readiness, curves, tuning, and the scene where there is one.
#pragma once

#include "app/console/operate/finger_menu.h"
#include "app/console/operate/scene_dock.h"
#include "app/console/shell/calibration_ages.h"
#include "app/console/shell/curve_tools.h"
#include "app/console/shell/dock_set.h"
#include "app/console/shell/page.h"
#include "widgets/curves/curve_view.h"
#include "widgets/devices/camera_panel.h"
#include "widgets/status/readiness_list.h"
#include "widgets/tuning/tuning_panel.h"

namespace fyd::console {

class OperatePage : public Page {
  Q_OBJECT
 public:
  explicit OperatePage(const PageContext& context, QWidget* parent = nullptr);
  void addCommands(PlaceCommands& commands) override;
  void enter() override;

  [[nodiscard]] widgets::CameraPanel* camera() const { return camera_; }
  /// Hidden beside a real touchpad.
  [[nodiscard]] FingerMenu* finger() const { return finger_; }
  [[nodiscard]] widgets::ReadinessList* readiness() const { return readiness_; }
  [[nodiscard]] widgets::CurveView* curves() const { return curves_; }
  [[nodiscard]] CurveTools* curveTools() const { return curve_tools_; }
  [[nodiscard]] widgets::TuningPanel* tuning() const { return tuning_; }
  [[nodiscard]] SceneDock* scene() const { return scene_; }
  /// Camera, readiness, scene and tuning around the curves.
  [[nodiscard]] DockSet& panels() { return panels_; }

 private:
  void build();
  void connectFeed();
  void connectCurves();
  void showLimits();
  void connectTuning();
  void connectFinger();
  void showFinger();
  void addCurveCommands(PlaceCommands& commands);

  PageContext context_;
  CalibrationAges ages_;
  widgets::CameraPanel* camera_ = nullptr;
  FingerMenu* finger_ = nullptr;
  widgets::ReadinessList* readiness_ = nullptr;
  widgets::CurveView* curves_ = nullptr;
  CurveTools* curve_tools_ = nullptr;
  widgets::TuningPanel* tuning_ = nullptr;
  QMainWindow* area_ = nullptr;
  SceneDock* scene_ = nullptr;
  DockSet panels_;
  std::vector<QAction*> finger_actions_;
};

}  // namespace fyd::console
