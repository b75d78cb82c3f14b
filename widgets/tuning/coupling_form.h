// Choice of the coupling, which turns the robot's contact into the stiffness target of the cloth, with a text on what
// it does with the connected robot.
#pragma once

#include <QFrame>
#include <QLabel>

#include "widgets/tuning/tuning_row.h"

namespace fyd::widgets {

class CouplingForm : public QFrame {
  Q_OBJECT
 public:
  /// @param model must hold pipeline.coupling, or the form stays empty
  explicit CouplingForm(TuningModel& model, QWidget* parent = nullptr);

  enum class Force { unknown, told, not_told };
  /// Whether the connected robot reports its force; unknown: no robot.
  void setForce(Force force);
  /// Energies of the last touch, mJ: put in minus returned, and withheld by the coupling; NaN: none yet.
  void setEnergy(double put_in_mJ, double withheld_mJ);

  [[nodiscard]] TuningRow* row() const { return row_; }
  [[nodiscard]] QString hint() const { return hint_->text(); }
  [[nodiscard]] QString energy() const { return energy_->text(); }

 private:
  void refresh();

  TuningModel& model_;
  Force force_ = Force::unknown;
  TuningRow* row_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* energy_ = nullptr;
};

}  // namespace fyd::widgets
