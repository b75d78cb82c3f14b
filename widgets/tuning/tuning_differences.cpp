#include "widgets/tuning/tuning_differences.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/basics/core_text.h"
#include "widgets/basics/theme.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::widgets {
namespace {

constexpr int kId = Qt::UserRole;  // the parameter's id in each cell

}  // namespace

TuningDifferences::TuningDifferences(TuningModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      words_(new QLabel(this)),
      table_(new QTableWidget(0, 3, this)),
      revert_(new QPushButton(tr("Back to saved"), this)),
      revert_all_(new QPushButton(tr("All back to saved"), this)) {
  words_->setWordWrap(true);
  words_->setProperty("role", "muted");
  table_->setObjectName(QStringLiteral("differences_table"));
  table_->setAccessibleName(tr("What differs from the saved profile"));
  table_->setHorizontalHeaderLabels({tr("Parameter"), tr("A: saved"), tr("B: current")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  revert_->setObjectName(QStringLiteral("revert_selected"));
  revert_->setToolTip(tr("The selected parameters take their saved values again"));
  revert_all_->setObjectName(QStringLiteral("revert_all"));
  revert_all_->setToolTip(tr("Every parameter takes its saved value again; one step to undo"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  buttons->addWidget(revert_);
  buttons->addWidget(revert_all_);
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(words_);
  layout->addWidget(table_, 1);
  layout->addLayout(buttons);
  connect(revert_, &QPushButton::clicked, this, [this] {
    std::vector<Setting> settings;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows()) {
      const std::string id = table_->item(index.row(), 0)->data(kId).toString().toStdString();
      if (const TunedParameter* p = model_.find(id)) settings.push_back({.id = id, .value = p->saved});
    }
    if (const auto ok = model_.changeAll(tr("back to the saved values"), settings); !ok) {
      emit refused(coreText(ok.error().message));
    }
  });
  connect(revert_all_, &QPushButton::clicked, this, [this] {
    if (const auto ok = model_.revertAll(); !ok) emit refused(coreText(ok.error().message));
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { revert_->setEnabled(table_->selectionModel()->hasSelection() && !model_.feelingSaved()); });
  connect(&model_, &TuningModel::changed, this, &TuningDifferences::refresh);
  connect(&model_, &TuningModel::feelingSavedChanged, this, &TuningDifferences::refresh);
  refresh();
}

void TuningDifferences::refresh() {
  // In place: a selection survives while the list of what differs stays the same.
  int row = 0;
  for (const TunedParameter& p : model_.parameters()) {
    if (!p.changed()) continue;
    if (row == table_->rowCount()) table_->insertRow(row);
    const QString unit = unitText(p.info);
    const auto text = [&](double value) {
      const QString number = valueText(p.info, value);
      return unit.isEmpty() ? number : tr("%1 %2").arg(number, unit);
    };
    const QString id = QString::fromUtf8(p.info.id.data(), static_cast<qsizetype>(p.info.id.size()));
    const QStringList cells = {tunedName(p.info), text(p.saved), text(p.value)};
    for (int column = 0; column < cells.size(); ++column) {
      QTableWidgetItem* item = table_->item(row, column);
      if (item == nullptr) table_->setItem(row, column, item = new QTableWidgetItem);
      item->setText(cells[column]);
      item->setToolTip(tr("Parameter %1").arg(id));
      item->setData(kId, id);
    }
    ++row;
  }
  table_->setRowCount(row);
  const bool free = !model_.feelingSaved();
  words_->setText(row == 0 ? tr("Nothing differs from the saved profile. Change a value at the left and it is listed "
                                "here; A and B then switch between saved and current while you feel.")
                  : free   ? tr("The current values (B) are felt.")
                           : tr("The saved values (A) are felt. Go back to B to change anything."));
  revert_->setEnabled(free && table_->selectionModel()->hasSelection());
  revert_all_->setEnabled(free && row > 0);
}

}  // namespace fyd::widgets
