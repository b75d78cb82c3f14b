#include "app/console/window/command_palette.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;

CommandPalette::CommandPalette(const CommandRegistry& registry, QWidget* window)
    : QDialog(window), registry_(registry), field_(new QLineEdit(this)), list_(new QListWidget(this)) {
  setWindowTitle(tr("Find a command"));
  setModal(false);  // nothing is modal while a device can move
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->addWidget(field_);
  layout->addWidget(list_);
  field_->setPlaceholderText(tr("Type a few letters of a command"));
  field_->setAccessibleName(windowTitle());
  list_->setAccessibleName(tr("Commands found"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setIconSize({2 * kGrid, 2 * kGrid});
  field_->installEventFilter(this);
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(field_, &QLineEdit::returnPressed, this, &CommandPalette::run);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
  resize(48 * kGrid, 40 * kGrid);
}

void CommandPalette::open() {
  if (!isVisible()) former_focus_ = parentWidget()->focusWidget();
  field_->clear();
  filter({});
  show();
  raise();
  activateWindow();
  field_->setFocus();
}

void CommandPalette::filter(const QString& letters) {
  list_->clear();
  const QStringList words = letters.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (QAction* action : registry_.actions()) {
    if (!action->isVisible() || !action->isEnabled()) continue;  // belongs to another place or other devices
    const QString name = action->text().section(QLatin1Char('\t'), 0, 0);
    if (!std::ranges::all_of(words, [&](const QString& each) { return name.contains(each, Qt::CaseInsensitive); }))
      continue;
    const QString own = action->shortcut().toString(QKeySequence::NativeText);  // as the menus name them: Ctrl+Maj+L
    const QString keys = own.isEmpty() ? action->property("keys").toString() : own;
    QPixmap none(list_->iconSize());  // keeps the names in one column
    none.fill(Qt::transparent);
    auto* item = new QListWidgetItem(action->icon().isNull() ? QIcon(none) : action->icon(),
                                     keys.isEmpty() ? name : tr("%1   (%2)").arg(name, keys), list_);
    item->setData(Qt::UserRole, action->objectName());
  }
  list_->setCurrentRow(0);
}

void CommandPalette::run() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  const QString id = item->data(Qt::UserRole).toString();
  hide();
  registry_.action(id)->trigger();
}

void CommandPalette::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  parentWidget()->activateWindow();
  if (former_focus_) former_focus_->setFocus(Qt::PopupFocusReason);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step != 0 && list_->count() > 0) {
      list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace fyd::console
