#include "widgets/tuning/tuning_proposal.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

TuningProposal::TuningProposal(QWidget* parent)
    : QWidget(parent),
      source_(new QComboBox(this)),
      start_(new QPushButton(tr("Auto-tune"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      progress_(new QProgressBar(this)),
      words_(new QLabel(this)),
      table_(new QTableWidget(0, 3, this)),
      accept_(new QPushButton(tr("Accept"), this)),
      discard_(new QPushButton(tr("Discard"), this)) {
  source_->setObjectName(QStringLiteral("auto_tune_source"));
  source_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  source_->setAccessibleName(tr("What the cloth is identified from"));
  start_->setObjectName(QStringLiteral("auto_tune_start"));
  start_->setToolTip(tr("Identify cloth and sensors and propose gains; nothing is changed (Ctrl+U)"));
  cancel_->setObjectName(QStringLiteral("auto_tune_cancel"));
  accept_->setObjectName(QStringLiteral("auto_tune_accept"));
  accept_->setToolTip(tr("Use the proposed values; one step to undo"));
  discard_->setObjectName(QStringLiteral("auto_tune_discard"));
  progress_->setObjectName(QStringLiteral("auto_tune_progress"));
  progress_->setAccessibleName(tr("Progress of auto-tune"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(kGrid / 2);
  words_->setWordWrap(true);
  words_->setObjectName(QStringLiteral("auto_tune_words"));
  table_->setObjectName(QStringLiteral("proposal_table"));
  table_->setAccessibleName(tr("Proposed values"));
  table_->setHorizontalHeaderLabels({tr("Parameter"), tr("Present"), tr("Proposed")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setTabKeyNavigation(false);
  auto* above = new QHBoxLayout;
  above->setSpacing(kGrid);
  above->addWidget(source_, 1);
  above->addWidget(start_);
  above->addWidget(cancel_);
  auto* below = new QHBoxLayout;
  below->setSpacing(kGrid);
  below->addWidget(accept_);
  below->addWidget(discard_);
  below->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addLayout(above);
  layout->addWidget(progress_);
  layout->addWidget(words_);
  layout->addWidget(table_, 1);
  layout->addLayout(below);
  for (QPushButton* button : {start_, cancel_, accept_, discard_}) button->setAutoDefault(false);
  connect(start_, &QPushButton::clicked, this, [this] { emit startAsked(source()); });
  connect(cancel_, &QPushButton::clicked, this, &TuningProposal::cancelAsked);
  connect(accept_, &QPushButton::clicked, this, &TuningProposal::acceptAsked);
  connect(discard_, &QPushButton::clicked, this, &TuningProposal::discardAsked);
  showRunning(false);
  clear(purpose());
}

QString TuningProposal::purpose() {
  return tr("Finds out how cloth and sensors answer and proposes gains. Nothing changes until you accept.");
}

void TuningProposal::setSources(const QStringList& names) {
  source_->clear();
  source_->addItems(names);
}

void TuningProposal::showRunning(bool running) {
  start_->setEnabled(!running);
  source_->setEnabled(!running);
  cancel_->setEnabled(running);
  progress_->setValue(0);
  progress_->setVisible(running);
  if (running) clear(tr("Running …"));
}

void TuningProposal::showProgress(double done) { progress_->setValue(static_cast<int>(1000.0 * done)); }

void TuningProposal::showProposal(const std::vector<ProposalLine>& lines, const QString& identified) {
  words_->setText(identified);
  table_->setRowCount(static_cast<int>(lines.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const ProposalLine& line = lines[static_cast<std::size_t>(row)];
    const auto text = [&](double value) {
      return line.unit.isEmpty() ? plainNumber(value) : tr("%1 %2").arg(plainNumber(value), line.unit);
    };
    const QStringList cells = {line.id, text(line.present), text(line.proposed)};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      if (column == 2 && line.present != line.proposed) item->setFont(textFont(TextSize::normal, true));
      table_->setItem(row, column, item);
    }
  }
  accept_->setEnabled(true);
  discard_->setEnabled(true);
}

void TuningProposal::clear(const QString& words) {
  words_->setText(words);
  table_->setRowCount(0);
  accept_->setEnabled(false);
  discard_->setEnabled(false);
}

}  // namespace fyd::widgets
