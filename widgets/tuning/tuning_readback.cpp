#include "widgets/tuning/tuning_readback.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

TuningReadback::TuningReadback(QWidget* parent) : QWidget(parent), table_(new QTableWidget(0, 4, this)) {
  auto* words = new QLabel(tr("What was asked, and what the part that holds it says of it. A value counts as confirmed "
                              "only when that part has said so."),
                           this);
  words->setWordWrap(true);
  words->setProperty("role", "muted");
  table_->setObjectName(QStringLiteral("readback_table"));
  table_->setAccessibleName(tr("Read back"));
  table_->setHorizontalHeaderLabels({tr("Setting"), tr("Asked"), tr("Read back"), tr("State")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setTabKeyNavigation(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(words);
  layout->addWidget(table_, 1);
}

void TuningReadback::setLines(const std::vector<ReadbackLine>& lines) {
  if (lines == lines_) return;
  lines_ = lines;
  table_->setRowCount(static_cast<int>(lines.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const ReadbackLine& line = lines[static_cast<std::size_t>(row)];
    const bool confirmed = line.state == ReadbackLine::State::confirmed;
    const bool differs = line.state == ReadbackLine::State::differs;
    const QString state = confirmed ? tr("confirmed") : differs ? tr("differs") : tr("cannot be read back");
    const QStringList cells = {line.what, line.asked, line.said, state};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      if (column == 3 && (confirmed || differs)) {
        item->setIcon(icon(confirmed ? QStringLiteral("check") : QStringLiteral("warning"),
                           confirmed ? theme().live : theme().warning));
      }
      table_->setItem(row, column, item);
    }
  }
}

}  // namespace fyd::widgets
