#include "widgets/curves/curve_setup_panel.h"

#include <QGridLayout>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/vertical_scroll.h"
#include "widgets/curves/curve_choice.h"

namespace fyd::widgets {
namespace {

QLabel* small(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(textFont(TextSize::small));
  label->setProperty("role", "muted");
  return label;
}

void markRefused(QLineEdit* field, bool refused) {
  field->setProperty("refused", refused ? "true" : "");
  restyle(*field);
}

}  // namespace

CurveSetupPanel::CurveSetupPanel(CurveStack* stack, QWidget* parent)
    : QWidget(parent),
      stack_(stack),
      span_(new QLineEdit(this)),
      link_(new QCheckBox(tr("One time for all curves"), this)),
      problem_(new QLabel(this)) {
  setAccessibleName(tr("Choice of curves"));
  build();
  refresh();
}

void CurveSetupPanel::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid / 2, 0, kGrid / 2);
  layout->setSpacing(kGrid / 2);
  auto* head = new QHBoxLayout;
  auto* title = new QLabel(tr("Curves"), this);
  title->setFont(textFont(TextSize::normal, true));
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("close_curve_setup"));
  close->setProperty("flat", true);
  close->setIcon(icon(QStringLiteral("cross")));
  close->setIconSize({2 * kGrid, 2 * kGrid});
  close->setAccessibleName(tr("Close the choice of curves"));
  close->setToolTip(close->accessibleName());
  connect(close, &QToolButton::clicked, this, &CurveSetupPanel::closeAsked);
  head->addWidget(title, 1);
  head->addWidget(close);
  layout->addLayout(head);

  auto* time = new QHBoxLayout;
  span_->setObjectName(QStringLiteral("curve_span"));
  span_->setAccessibleName(tr("Time shown in seconds"));
  span_->setFixedWidth(8 * kGrid);
  span_->setAlignment(Qt::AlignRight);
  connect(span_, &QLineEdit::editingFinished, this, &CurveSetupPanel::takeSpan);
  time->addWidget(new QLabel(tr("Time shown"), this), 1);
  time->addWidget(span_);
  time->addWidget(small(tr("s"), this));
  layout->addLayout(time);
  link_->setObjectName(QStringLiteral("curve_link"));
  link_->setToolTip(tr("Off: each curve is moved and zoomed by itself (T)"));
  connect(link_, &QCheckBox::toggled, stack_, &CurveStack::setLinked);
  layout->addWidget(link_);

  auto* scroll = makeVerticalScroll(this);
  auto* body = new QWidget(scroll);
  auto* grid = new QGridLayout(body);
  grid->setContentsMargins(0, 0, kGrid, 0);
  grid->setHorizontalSpacing(kGrid / 2);
  grid->setVerticalSpacing(kGrid / 2);
  grid->setColumnStretch(0, 1);
  grid->addWidget(small(tr("from"), body), 0, 1, Qt::AlignRight);
  grid->addWidget(small(tr("to"), body), 0, 2, Qt::AlignRight);
  for (std::size_t i = 0; i < stack_->size(); ++i) addRow(grid, i);
  grid->setRowStretch(static_cast<int>(stack_->size()) + 1, 1);
  scroll->setWidget(body);
  layout->addWidget(scroll, 1);
  // Names in every language, both ends of a range, and the scroll bar have room beside each other.
  setFixedWidth(kGrid + body->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());

  problem_->setObjectName(QStringLiteral("curve_problem"));
  problem_->setWordWrap(true);
  problem_->setProperty("role", "warning");
  problem_->hide();
  layout->addWidget(problem_);
}

void CurveSetupPanel::addRow(QGridLayout* grid, std::size_t index) {
  const StripSetup& setup = stack_->setup(index);
  const QString name = setup.unit.isEmpty() ? setup.title : tr("%1, %2").arg(setup.title, setup.unit);
  QWidget* body = grid->parentWidget();
  Row row{.shown = new QCheckBox(setup.title, body), .lower = new QLineEdit(body), .upper = new QLineEdit(body)};
  row.shown->setObjectName(QStringLiteral("show_") + setup.id);
  row.shown->setAccessibleName(tr("Show %1").arg(name));
  connect(row.shown, &QCheckBox::toggled, this, [this, index](bool shown) {
    stack_->setShown(index, shown);
    refresh();  // the last one cannot be hidden
  });
  const int line = static_cast<int>(index) + 1;
  grid->addWidget(row.shown, line, 0);
  int column = 1;
  for (QLineEdit* field : {row.lower, row.upper}) {
    field->setObjectName((field == row.lower ? QStringLiteral("from_") : QStringLiteral("to_")) + setup.id);
    field->setAccessibleName((field == row.lower ? tr("Lower end of %1") : tr("Upper end of %1")).arg(name));
    field->setToolTip(tr("Both ends: this range is kept. Both empty: it follows the values."));
    field->setPlaceholderText(tr("auto"));
    field->setAlignment(Qt::AlignRight);
    field->setFixedWidth(7 * kGrid);
    connect(field, &QLineEdit::editingFinished, this, [this, index, field] { takeRange(index, field); });
    grid->addWidget(field, line, column++);
  }
  rows_.push_back(row);
}

void CurveSetupPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void CurveSetupPanel::refresh() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const QSignalBlocker quiet(row.shown);
    row.shown->setChecked(stack_->shown(i));
    const auto& chosen = stack_->strip(i)->chosenRange();
    if (!row.lower->hasFocus() && !row.upper->hasFocus()) {
      row.lower->setText(chosen ? plainNumber(chosen->lower) : QString());
      row.upper->setText(chosen ? plainNumber(chosen->upper) : QString());
    }
  }
  const QSignalBlocker quiet(link_);
  link_->setChecked(stack_->linked());
  if (!span_->hasFocus()) span_->setText(plainNumber(std::round(1000.0 * stack_->window().span_s()) / 1000.0));
}

void CurveSetupPanel::refuse(QLineEdit* field, const QString& why) {
  markRefused(field, true);
  problem_->setText(why);
  problem_->show();
}

void CurveSetupPanel::takeRange(std::size_t index, QLineEdit* changed) {
  if (!changed->isModified()) return;  // the signal also comes when the field only loses the focus
  changed->setModified(false);
  const Row& row = rows_[index];
  for (QLineEdit* field : {row.lower, row.upper}) markRefused(field, false);
  problem_->hide();
  problem_->clear();
  const bool none = row.lower->text().trimmed().isEmpty() && row.upper->text().trimmed().isEmpty();
  if (none) {
    stack_->strip(index)->chooseRange(std::nullopt);
    emit stack_->moved();
    return;
  }
  // While one end is still empty, the entry is incomplete and not yet an error.
  if (row.lower->text().trimmed().isEmpty() || row.upper->text().trimmed().isEmpty()) return;
  for (QLineEdit* field : {row.lower, row.upper}) {
    const double value = readNumber(field->text());
    if (!(std::abs(value) <= kLargestChosen)) {
      refuse(field, tr("%1: expected a number from %2 to %3")
                        .arg(field->text(), plainNumber(-kLargestChosen), plainNumber(kLargestChosen)));
      return;
    }
  }
  const Range wanted{readNumber(row.lower->text()), readNumber(row.upper->text())};
  if (wanted.lower >= wanted.upper) {
    refuse(row.upper, tr("%1 to %2: the upper end must be the larger one").arg(row.lower->text(), row.upper->text()));
    return;
  }
  stack_->strip(index)->chooseRange(wanted);
  emit stack_->moved();
}

void CurveSetupPanel::takeSpan() {
  if (!span_->isModified()) return;
  span_->setModified(false);
  markRefused(span_, false);
  problem_->hide();
  problem_->clear();
  const double span_s = readNumber(span_->text());
  const double longest_s = std::min(stack_->window().longest_s(), kLargestChosen);
  if (!(span_s >= TimeWindow::kShortest_s && span_s <= longest_s)) {
    refuse(
        span_,
        tr("%1: expected %2 to %3 s").arg(span_->text(), plainNumber(TimeWindow::kShortest_s), plainNumber(longest_s)));
    return;
  }
  stack_->forEachWindow([span_s](TimeWindow& window) {
    if (window.following()) {
      window.chooseSpan(span_s);
    } else {
      window.show(window.to_s() - span_s, window.to_s());
    }
  });
  span_->setText(plainNumber(std::round(1000.0 * stack_->window().span_s()) / 1000.0));
}

}  // namespace fyd::widgets
