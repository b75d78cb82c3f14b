#include "widgets/tuning/tuning_compare.h"

#include <QHBoxLayout>

#include "widgets/basics/theme.h"

namespace fyd::widgets {

TuningCompare::TuningCompare(TuningModel& model, QWidget* parent)
    : QWidget(parent), model_(model), saved_(new QToolButton(this)), current_(new QToolButton(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  const auto dress = [&](QToolButton* button, const char* name, const QString& letter, const QString& words) {
    button->setObjectName(QLatin1String(name));
    button->setText(letter);
    button->setCheckable(true);
    button->setAccessibleName(words);
    layout->addWidget(button);
  };
  dress(saved_, "compare_saved", tr("A"), tr("A: feel the saved values"));
  dress(current_, "compare_current", tr("B"), tr("B: feel the current values"));
  connect(saved_, &QToolButton::clicked, this, [this] {
    model_.feelSaved(true);
    refresh();
  });
  connect(current_, &QToolButton::clicked, this, [this] {
    model_.feelSaved(false);
    refresh();
  });
  connect(&model_, &TuningModel::changed, this, &TuningCompare::refresh);
  connect(&model_, &TuningModel::feelingSavedChanged, this, &TuningCompare::refresh);
  refresh();
}

void TuningCompare::refresh() {
  const bool saved = model_.feelingSaved();
  saved_->setChecked(saved);
  current_->setChecked(!saved);
  const bool differs = model_.anyChanged();
  saved_->setEnabled(differs || saved);
  saved_->setToolTip(differs ? tr("A: feel the saved values. Nothing can be changed meanwhile (Ctrl+B)")
                             : tr("Nothing differs from the saved values"));
  current_->setToolTip(tr("B: feel the current values (Ctrl+B)"));
}

}  // namespace fyd::widgets
