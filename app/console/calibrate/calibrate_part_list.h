// The parts of a touchpad with the age of their calibration.
#pragma once

#include <QListWidget>
#include <memory>
#include <vector>

#include "app/console/calibrate/calibrate_step.h"

namespace fyd::console {

class CalibrationPartList : public QListWidget {
  Q_OBJECT
 public:
  explicit CalibrationPartList(QWidget* parent);
  /// A row for each step, in their order.
  void setSteps(const std::vector<std::unique_ptr<CalibrationStep>>& steps);
  /// Says of each how old its calibration is, by the records beside the profile.
  void refresh(const std::vector<std::unique_ptr<CalibrationStep>>& steps, const QString& profile_path,
               const station::Profile& profile);
};

}  // namespace fyd::console
