// The place "Operate": what is felt now. State bar on top; camera and readiness, curves, tuning below it.
#pragma once

#include <QWidget>

#include "widgets/camera_panel.h"
#include "widgets/curve_view.h"
#include "widgets/readiness_list.h"
#include "widgets/state_bar.h"
#include "widgets/tuning_panel.h"

namespace fyd::console {

class OperatePage : public QWidget {
  Q_OBJECT
 public:
  explicit OperatePage(widgets::TuningModel& tuning, QWidget* parent = nullptr);

  [[nodiscard]] widgets::StateBar* stateBar() const { return state_bar_; }
  [[nodiscard]] widgets::CameraPanel* camera() const { return camera_; }
  [[nodiscard]] widgets::ReadinessList* readiness() const { return readiness_; }
  [[nodiscard]] widgets::CurveView* curves() const { return curves_; }
  [[nodiscard]] widgets::TuningPanel* tuning() const { return tuning_; }

 private:
  widgets::StateBar* state_bar_;
  widgets::CameraPanel* camera_;
  widgets::ReadinessList* readiness_;
  widgets::CurveView* curves_;
  widgets::TuningPanel* tuning_;
};

/// The parameter that holds the target while it is set by hand.
inline constexpr const char* kHandTarget = "pipeline.hand_target_N_per_mm";

}  // namespace fyd::console
