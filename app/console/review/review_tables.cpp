#include "app/console/review/review_tables.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/basics/number_text.h"

namespace fyd::console {

using widgets::numberText;
using widgets::quantityText;

ReviewTable::ReviewTable(const QStringList& columns, const QList<int>& words, const QString& name, QWidget* parent)
    : QTableWidget(0, static_cast<int>(columns.size()), parent), words_(words) {
  setAccessibleName(name);
  setHorizontalHeaderLabels(columns);
  for (int column = 0; column < columnCount(); ++column) {
    horizontalHeaderItem(column)->setTextAlignment(alignment(column));
  }
  setFont(widgets::textFont(widgets::TextSize::small));
  horizontalHeader()->setFont(font());
  horizontalHeader()->setMinimumSectionSize(4 * widgets::kGrid);
  verticalHeader()->hide();
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setStretchLastSection(true);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);
  setWordWrap(false);
}

Qt::Alignment ReviewTable::alignment(int column) const {
  return (words_.contains(column) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
}

void ReviewTable::setEmptyText(const QString& text) {
  empty_text_ = text;
  viewport()->update();
}

void ReviewTable::setRow(int row, const QStringList& cells, const QString& spoken) {
  for (int column = 0; column < cells.size(); ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setToolTip(spoken);
    item->setTextAlignment(alignment(column));
    setItem(row, column, item);
  }
  item(row, 0)->setData(Qt::AccessibleTextRole, spoken);
}

void ReviewTable::paintEvent(QPaintEvent* event) {
  QTableWidget::paintEvent(event);
  if (rowCount() > 0 || empty_text_.isEmpty()) return;
  QPainter painter(viewport());
  painter.setPen(widgets::theme().muted);
  constexpr int kSpace = 2 * widgets::kGrid;
  painter.drawText(viewport()->rect().adjusted(kSpace, kSpace, -kSpace, -kSpace),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, empty_text_);
}

TouchTable::TouchTable(QWidget* parent)
    : ReviewTable(
          {tr("Start\ns"), tr("Length\ns"), tr("Force\nN"), tr("Stiffness\nN/mm"), tr("Settled\ns"), tr("Depth\nmm")},
          {}, tr("Touches"), parent) {
  setObjectName(QStringLiteral("touch_table"));
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) {
    if (row < 0 || static_cast<std::size_t>(row) >= touches_.size()) return;
    const exports::Touch& touch = touches_[static_cast<std::size_t>(row)];
    emit touchChosen(touch.start_s, touch.end_s);
  });
}

void TouchTable::setTouches(const std::vector<exports::Touch>& touches) {
  touches_.clear();
  setRowCount(0);
  touches_ = touches;
  setRowCount(static_cast<int>(touches.size()));
  for (int i = 0; i < rowCount(); ++i) {
    const exports::Touch& t = touches_[static_cast<std::size_t>(i)];
    const QString spoken =
        tr("Touch %1 at %2: peak force %3, peak indentation %4, stiffness %5 of %6 asked, settled "
           "after %7")
            .arg(i + 1)
            .arg(quantityText(t.start_s, 2, tr("s")), quantityText(t.peak_force_N, 2, tr("N")),
                 quantityText(t.peak_indentation_mm, 2, tr("mm")), quantityText(t.stiffness_N_per_mm, 3, tr("N/mm")),
                 quantityText(t.target_N_per_mm, 3, tr("N/mm")), quantityText(t.settling_s, 2, tr("s")));
    setRow(i,
           {numberText(t.start_s, 2), numberText(t.end_s - t.start_s, 2), numberText(t.peak_force_N, 2),
            numberText(t.stiffness_N_per_mm, 3), numberText(t.settling_s, 2), numberText(t.peak_indentation_mm, 2)},
           spoken);
  }
}

const exports::Touch* TouchTable::chosen() const {
  const int row = currentRow();
  return row >= 0 && static_cast<std::size_t>(row) < touches_.size() ? &touches_[static_cast<std::size_t>(row)]
                                                                     : nullptr;
}

FiguresTable::FiguresTable(QWidget* parent)
    : ReviewTable(
          {tr("Between A and B"), tr("At A"), tr("At B"), tr("B − A"), tr("Slope\nper s"), tr("Mean"), tr("RMS")}, {0},
          tr("Figures between A and B"), parent) {
  setObjectName(QStringLiteral("figures_table"));
  setEmptyText(tr("Put the cursor somewhere and press [ for A, elsewhere and press ] for B."));
}

void FiguresTable::clearFigures() {
  setRowCount(0);
  horizontalHeaderItem(0)->setText(tr("Between A and B"));
}

void FiguresTable::setFigures(const std::vector<StretchFigures>& figures, double b_after_a_s) {
  horizontalHeaderItem(0)->setText(tr("Δt %1 s").arg(numberText(b_after_a_s, 3)));
  setRowCount(static_cast<int>(figures.size()));
  for (int i = 0; i < rowCount(); ++i) {
    const StretchFigures& f = figures[static_cast<std::size_t>(i)];
    const ReviewQuantity& q = kReviewQuantities[static_cast<std::size_t>(i)];
    const QString unit = QString::fromUtf8(q.unit);
    const QString name = QCoreApplication::translate("Review", q.word) + QStringLiteral(", ") + unit;
    const int digits = q.decimals + 1;
    setRow(i,
           {name, numberText(f.at_a, digits), numberText(f.at_b, digits), numberText(f.difference, digits),
            numberText(f.slope_per_s, digits), numberText(f.mean, digits), numberText(f.rms, digits)},
           tr("%1: difference %2, mean %3").arg(name, numberText(f.difference, digits), numberText(f.mean, digits)));
  }
}

NoteTable::NoteTable(QWidget* parent)
    : ReviewTable({tr("s"), tr("Kind"), tr("Note")}, {1, 2}, tr("Notes and events"), parent) {
  setObjectName(QStringLiteral("note_table"));
  setEmptyText(tr("No notes. N writes one at the cursor."));
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) {
    if (row >= 0 && static_cast<std::size_t>(row) < notes_.size()) {
      emit noteChosen(notes_[static_cast<std::size_t>(row)].time_s);
    }
  });
}

void NoteTable::setNotes(const std::vector<NoteLine>& notes) {
  notes_.clear();
  setRowCount(0);
  notes_ = notes;
  setRowCount(static_cast<int>(notes.size()));
  for (int i = 0; i < rowCount(); ++i) {
    const NoteLine& note = notes_[static_cast<std::size_t>(i)];
    setRow(i, {numberText(note.time_s, 2), note.kind, note.text},
           tr("%1 at %2 s: %3").arg(note.kind, numberText(note.time_s, 2), note.text));
  }
}

void NoteTable::showAt(double time_s, const QString& text) {
  const auto found =
      std::ranges::find_if(notes_, [&](const NoteLine& each) { return each.time_s == time_s && each.text == text; });
  if (found == notes_.end()) return;
  const QSignalBlocker quiet(this);
  setCurrentCell(static_cast<int>(found - notes_.begin()), 0);
}

}  // namespace fyd::console
