// All parameters of the sensing module.
// Stability: stable since 0.1
#pragma once

#include "core/sensing/finger_parameters.h"
#include "core/sensing/indentation_parameters.h"
#include "core/sensing/load_cell.h"
#include "core/sensing/stiffness_estimator.h"

namespace fyd::sensing {

struct SensingParameters {
  FingerParameters finger;
  IndentationParameters indentation;
  LoadCellParameters load_cell;
  StiffnessParameters stiffness;

  template <class Visitor>
  void describe(Visitor& v) {
    finger.describe(v);
    indentation.describe(v);
    load_cell.describe(v);
    stiffness.describe(v);
  }
};

}  // namespace fyd::sensing
