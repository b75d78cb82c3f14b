#include "widgets/tuning/tuning_preset_list.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

TuningPresetList::TuningPresetList(QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      list_(new QListWidget(this)),
      name_(new QLineEdit(this)),
      save_(new QPushButton(tr("Save"), this)),
      load_(new QPushButton(tr("Load"), this)),
      rename_(new QPushButton(tr("Rename"), this)),
      remove_(new QPushButton(tr("Delete"), this)) {
  words_->setWordWrap(true);
  words_->setObjectName(QStringLiteral("preset_words"));
  list_->setObjectName(QStringLiteral("preset_names"));
  list_->setAccessibleName(tr("Presets"));
  name_->setObjectName(QStringLiteral("preset_name"));
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Name of the preset"));
  save_->setObjectName(QStringLiteral("preset_save"));
  load_->setObjectName(QStringLiteral("preset_load"));
  rename_->setObjectName(QStringLiteral("preset_rename"));
  remove_->setObjectName(QStringLiteral("preset_remove"));
  save_->setIcon(icon(QStringLiteral("save")));
  save_->setToolTip(tr("Keep the present values of all live parameters under this name (Enter)"));
  load_->setToolTip(tr("Use the chosen preset's values; one step to undo (Enter on the list)"));
  rename_->setToolTip(tr("Give the chosen preset the name above"));
  remove_->setToolTip(tr("Delete the chosen preset; undo brings it back"));
  auto* above = new QHBoxLayout;
  above->setSpacing(kGrid);
  above->addWidget(name_, 1);
  above->addWidget(save_);
  auto* below = new QHBoxLayout;
  below->setSpacing(kGrid);
  for (QPushButton* button : {load_, rename_, remove_}) below->addWidget(button);
  below->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(words_);
  layout->addLayout(above);
  layout->addWidget(list_, 1);
  layout->addLayout(below);
  for (QPushButton* button : {save_, load_, rename_, remove_}) button->setAutoDefault(false);
  connect(save_, &QPushButton::clicked, this, [this] { emit saveAsked(name_->text()); });
  connect(name_, &QLineEdit::returnPressed, save_, &QPushButton::click);
  connect(name_, &QLineEdit::textChanged, this, [this] { setProblem({}); });
  connect(load_, &QPushButton::clicked, this, [this] { emit loadAsked(chosen()); });
  connect(list_, &QListWidget::itemActivated, load_, &QPushButton::click);
  connect(rename_, &QPushButton::clicked, this, [this] { emit renameAsked(chosen(), name_->text()); });
  connect(remove_, &QPushButton::clicked, this, [this] { emit removeAsked(chosen()); });
  connect(list_, &QListWidget::itemSelectionChanged, this, &TuningPresetList::refresh);
  refresh();
}

QString TuningPresetList::chosen() const {
  const auto items = list_->selectedItems();
  return items.isEmpty() ? QString() : items.front()->text();
}

void TuningPresetList::setNames(const QStringList& names) {
  const QString former = chosen();
  list_->clear();
  list_->addItems(names);
  const auto again = list_->findItems(former, Qt::MatchExactly);
  if (!former.isEmpty() && !again.isEmpty()) list_->setCurrentItem(again.front());
  refresh();
}

void TuningPresetList::setProblem(const QString& why) {
  problem_ = why;
  name_->setProperty("refused", !why.isEmpty());
  restyle(*name_);
  refresh();
}

void TuningPresetList::refresh() {
  const bool any = !chosen().isEmpty();
  save_->setEnabled(!name_->text().isEmpty());
  load_->setEnabled(any);
  remove_->setEnabled(any);
  rename_->setEnabled(any && !name_->text().isEmpty() && name_->text() != chosen());
  words_->setProperty("role", problem_.isEmpty() ? "muted" : "warning");
  restyle(*words_);
  words_->setText(!problem_.isEmpty()   ? problem_
                  : list_->count() == 0 ? tr("No preset yet. Tune what you like to keep, write a name and press Save.")
                                        : tr("Loading one changes all its values at once; undo takes it back."));
}

}  // namespace fyd::widgets
