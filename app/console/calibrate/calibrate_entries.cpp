#include "app/console/calibrate/calibrate_entries.h"

#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;

CalibrationEntryForm::CalibrationEntryForm(QWidget* parent) : QWidget(parent), problem_(new QLabel(this)) {
  problem_->setObjectName(QStringLiteral("entry_problem"));
  problem_->setProperty("role", "warning");
  problem_->setWordWrap(true);
  problem_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(problem_);
}

void CalibrationEntryForm::setEntries(std::vector<CalibrationEntry> entries) {
  entries_ = std::move(entries);
  delete body_;
  fields_.clear();
  units_.clear();
  problem_->hide();
  problem_->clear();
  body_ = new QWidget(this);
  auto* grid = new QGridLayout(body_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(kGrid);
  int row = 0;
  for (const CalibrationEntry& entry : entries_) {
    auto* field = new QLineEdit(body_);
    field->setObjectName(QStringLiteral("entry_%1").arg(row));
    field->setAccessibleName(tr("%1, in the unit beside").arg(entry.name));
    if (std::isfinite(entry.empty)) field->setPlaceholderText(widgets::plainNumber(entry.empty));
    auto* unit = new QComboBox(body_);
    unit->addItems(entry.units);
    unit->setAccessibleName(tr("Unit of: %1").arg(entry.name));
    unit->setEnabled(entry.units.size() > 1);
    grid->addWidget(new QLabel(entry.name, body_), row, 0);
    grid->addWidget(field, row, 1);
    grid->addWidget(unit, row, 2);
    connect(field, &QLineEdit::returnPressed, this, &CalibrationEntryForm::entered);
    fields_.push_back(field);
    units_.push_back(unit);
    ++row;
  }
  static_cast<QVBoxLayout*>(layout())->insertWidget(0, body_);
  body_->setVisible(!entries_.empty());
}

QString CalibrationEntryForm::problemOf(std::size_t i, double value) const {
  const CalibrationEntry& entry = entries_[i];
  const QString written = fields_[i]->text().trimmed();
  if (written.isEmpty() && std::isfinite(entry.empty)) return {};
  if (written.isEmpty()) return tr("%1: type a number first.").arg(entry.name);
  if (!std::isfinite(value)) return tr("%1: \"%2\" is no number.").arg(entry.name, written.left(24));
  if (value >= entry.lowest && value <= entry.highest) return {};
  const auto unit = static_cast<std::size_t>(std::max(0, units_[i]->currentIndex()));
  // Inwards, to a hundredth, of large ranges to one; what a division rounds is no hundredth.
  const double per_unit = entry.per_unit[unit], parts = entry.highest / per_unit < 1000.0 ? 100.0 : 1.0;
  const double lowest = std::ceil(parts * entry.lowest / per_unit - 1e-6) / parts;
  const double highest = std::floor(parts * entry.highest / per_unit + 1e-6) / parts;
  return tr("%1: %2 is out of range; expected %3 to %4 %5.")
      .arg(entry.name, written.left(24), widgets::plainNumber(lowest), widgets::plainNumber(highest),
           units_[i]->currentText());
}

std::optional<std::vector<double>> CalibrationEntryForm::read() {
  std::vector<double> out;
  QString problem;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto unit = static_cast<std::size_t>(std::max(0, units_[i]->currentIndex()));
    double value = widgets::readNumber(fields_[i]->text()) * entries_[i].per_unit[unit];
    if (fields_[i]->text().trimmed().isEmpty()) value = entries_[i].empty;
    const QString here = problemOf(i, value);
    fields_[i]->setProperty("refused", !here.isEmpty());
    widgets::restyle(*fields_[i]);
    if (problem.isEmpty() && !here.isEmpty()) {
      problem = here;
      fields_[i]->setFocus();
      fields_[i]->selectAll();
    }
    out.push_back(value);
  }
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  if (!problem.isEmpty()) return {};
  return out;
}

void CalibrationEntryForm::clear() {
  for (QLineEdit* field : fields_) field->clear();
}

}  // namespace fyd::console
