// The fields for what the operator types at each point; a bad entry is explained below them.
#pragma once

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/console/calibrate/calibrate_step.h"

namespace fyd::console {

class CalibrationEntryForm : public QWidget {
  Q_OBJECT
 public:
  explicit CalibrationEntryForm(QWidget* parent = nullptr);
  void setEntries(std::vector<CalibrationEntry> entries);
  /// The values in each entry's first unit. An invalid field is marked and explained; nothing is returned then.
  [[nodiscard]] std::optional<std::vector<double>> read();
  /// Empties the fields for the next point; the units stay.
  void clear();

  [[nodiscard]] QLineEdit* field(std::size_t i) const { return fields_[i]; }
  [[nodiscard]] QComboBox* unit(std::size_t i) const { return units_[i]; }
  [[nodiscard]] QString problem() const { return problem_->text(); }

 signals:
  void entered();  ///< Return in a field

 private:
  [[nodiscard]] QString problemOf(std::size_t i, double value) const;

  std::vector<CalibrationEntry> entries_;
  std::vector<QLineEdit*> fields_;
  std::vector<QComboBox*> units_;
  QWidget* body_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace fyd::console
