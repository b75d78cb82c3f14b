// How what the robot feels becomes the stiffness asked of the cloth: the choice, and in words what it does with the
// robot that is there.
#pragma once

#include <QFrame>
#include <QLabel>

#include "widgets/tuning_row.h"

namespace fyd::widgets {

class CouplingForm : public QFrame {
  Q_OBJECT
 public:
  /// @param model holds pipeline.coupling, or the form says nothing
  explicit CouplingForm(TuningModel& model, QWidget* parent = nullptr);

  enum class Force { unknown, told, not_told };
  /// Whether the robot that is there tells its force; unknown: there is none.
  void setForce(Force force);
  /// Of a touch that is over, mJ: put in less what came back, and what was withheld; NaN: none yet.
  void setEnergy(double put_in_mJ, double withheld_mJ);

  [[nodiscard]] TuningRow* row() const { return row_; }
  [[nodiscard]] QString hint() const { return hint_->text(); }
  [[nodiscard]] QString energy() const { return energy_->text(); }

 private:
  void refresh();

  TuningModel& model_;
  Force force_ = Force::unknown;
  TuningRow* row_ = nullptr;
  QLabel* hint_;
  QLabel* energy_;
};

}  // namespace fyd::widgets
