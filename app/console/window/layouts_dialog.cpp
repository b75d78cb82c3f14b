#include "app/console/window/layouts_dialog.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;

LayoutsDialog::LayoutsDialog(WindowMemory& memory, std::function<Layout()> present, QWidget* window)
    : QDialog(window),
      memory_(memory),
      present_(std::move(present)),
      field_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      save_(new QPushButton(tr("Save layout"), this)),
      use_(new QPushButton(tr("Use"), this)),
      delete_(new QPushButton(tr("Delete"), this)),
      standard_(new QPushButton(tr("Standard layout"), this)),
      words_(new QLabel(this)) {
  setWindowTitle(tr("Layouts"));
  setModal(false);  // nothing is modal while a device can move
  build();
  connect(field_, &QLineEdit::textChanged, this, &LayoutsDialog::refresh);
  connect(field_, &QLineEdit::returnPressed, this, &LayoutsDialog::save);
  connect(list_, &QListWidget::itemSelectionChanged, this, &LayoutsDialog::refresh);
  connect(list_, &QListWidget::itemActivated, this, &LayoutsDialog::use);
  connect(save_, &QPushButton::clicked, this, &LayoutsDialog::save);
  connect(use_, &QPushButton::clicked, this, &LayoutsDialog::use);
  connect(delete_, &QPushButton::clicked, this, &LayoutsDialog::remove);
  connect(standard_, &QPushButton::clicked, this, &LayoutsDialog::standardAsked);
}

void LayoutsDialog::build() {
  field_->setPlaceholderText(tr("Name of the present layout"));
  field_->setAccessibleName(field_->placeholderText());
  field_->setMaxLength(WindowMemory::kLongestName);
  list_->setAccessibleName(tr("Saved layouts"));
  words_->setProperty("role", "muted");
  words_->setWordWrap(true);
  auto* top = new QHBoxLayout;
  top->addWidget(field_, 1);
  top->addWidget(save_);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(use_);
  bottom->addWidget(delete_);
  bottom->addStretch(1);
  bottom->addWidget(standard_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addLayout(top);
  layout->addWidget(list_, 1);
  layout->addWidget(words_);
  layout->addLayout(bottom);
  for (QPushButton* each : {save_, use_, delete_, standard_}) each->setAutoDefault(false);
  resize(52 * kGrid, 40 * kGrid);
}

void LayoutsDialog::open() {
  list_->clear();
  list_->addItems(memory_.layoutNames());
  field_->clear();
  words_->setText(
      list_->count() == 0
          ? tr("No layout is saved yet. Move the panels and choose the curves as you like them, then write a name.")
          : tr("Enter or a double click goes back to a layout."));
  refresh();
  show();
  raise();
  activateWindow();
  field_->setFocus();
}

void LayoutsDialog::refresh() {
  const bool any = !list_->selectedItems().isEmpty();
  save_->setEnabled(!field_->text().trimmed().isEmpty());
  use_->setEnabled(any);
  delete_->setEnabled(any);
}

void LayoutsDialog::save() {
  const QString name = field_->text().trimmed();
  if (name.isEmpty()) return;
  const bool kept = memory_.keepLayout(name, present_());
  open();
  words_->setText(kept ? tr("%1 is saved.").arg(name)
                       : tr("%1 is not saved: the file of the window's settings cannot be written.").arg(name));
}

void LayoutsDialog::use() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  if (const auto layout = memory_.namedLayout(item->text())) emit chosen(*layout);
}

void LayoutsDialog::remove() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  const QString name = item->text();
  const bool forgotten = memory_.forgetLayout(name);
  open();
  words_->setText(  // what could not be written Qt remembers until the window is closed
      forgotten
          ? tr("%1 is deleted.").arg(name)
          : tr("%1 comes back at the next start: the file of the window's settings cannot be written.").arg(name));
}

}  // namespace fyd::console
