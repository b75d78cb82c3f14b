#include "widgets/status/log_view.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/basics/theme.h"

namespace fyd::widgets {

LogView::LogView(QWidget* parent)
    : QWidget(parent),
      model_(new QStandardItemModel(0, 3, this)),
      filter_(new QSortFilterProxyModel(this)),
      search_(new QLineEdit(this)),
      table_(new QTableView(this)) {
  setAccessibleName(tr("Log"));
  model_->setHorizontalHeaderLabels({tr("Time"), tr("Kind"), tr("What happened")});
  filter_->setSourceModel(model_);
  filter_->setFilterKeyColumn(-1);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  search_->setPlaceholderText(tr("Search the log"));
  search_->setAccessibleName(tr("Search the log"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, filter_, &QSortFilterProxyModel::setFilterFixedString);
  table_->setModel(filter_);
  table_->setAccessibleName(tr("Log"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(3 * kGrid);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setColumnWidth(0, 12 * kGrid);
  table_->setColumnWidth(1, 12 * kGrid);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(search_);
  layout->addWidget(table_);
}

void LogView::add(const QString& when, Severity severity, const QString& text) {
  model_->appendRow({new QStandardItem(when), new QStandardItem(severityWord(severity)), new QStandardItem(text)});
  if (model_->rowCount() > kMost) model_->removeRows(0, model_->rowCount() - kMost);
  table_->scrollToBottom();
}

}  // namespace fyd::widgets
