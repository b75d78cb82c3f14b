#include "widgets/devices/part_choice.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QLineEdit>
#include <algorithm>

#include "widgets/basics/theme.h"
#include "widgets/basics/wheel_guard.h"
#include "widgets/devices/device_text.h"

namespace fyd::widgets {

PartChoice::PartChoice(const QString& name, const QString& id, std::vector<SourceKind> kinds, QWidget* parent)
    : QWidget(parent),
      kinds_(std::move(kinds)),
      entries_(kinds_.size()),
      kind_(new QComboBox(this)),
      entry_(new QComboBox(this)),
      browse_(new QToolButton(this)),
      problem_(new QLabel(this)) {
  auto* title = new QLabel(name, this);
  title->setFont(textFont(TextSize::small, true));
  kind_->setObjectName(id + QStringLiteral("_kind"));
  kind_->setAccessibleName(name);
  for (const SourceKind& each : kinds_) kind_->addItem(each.label);
  entry_->setObjectName(id + QStringLiteral("_entry"));
  entry_->setEditable(true);
  entry_->setInsertPolicy(QComboBox::NoInsert);
  for (QComboBox* each : {kind_, entry_}) {
    each->setMinimumContentsLength(16);
    each->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    guardFromWheel(each);
  }
  browse_->setText(tr("…"));
  browse_->setObjectName(id + QStringLiteral("_browse"));
  problem_->setFont(textFont(TextSize::small));
  problem_->setProperty("role", "warning");
  problem_->setWordWrap(true);
  problem_->hide();

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid / 2);
  grid->setColumnStretch(0, 1);
  grid->addWidget(title, 0, 0, 1, 2);
  grid->addWidget(kind_, 1, 0, 1, 2);
  grid->addWidget(entry_, 2, 0);
  grid->addWidget(browse_, 2, 1);
  grid->addWidget(problem_, 3, 0, 1, 2);

  connect(kind_, &QComboBox::currentIndexChanged, this, &PartChoice::takeKind);
  connect(entry_, &QComboBox::editTextChanged, this, [this] {
    setProblem({});
    emit changed();
  });
  connect(browse_, &QToolButton::clicked, this, &PartChoice::browse);
  showKind();
}

const SourceKind& PartChoice::chosen() const {
  return kinds_[static_cast<std::size_t>(std::max(0, kind_->currentIndex()))];
}

void PartChoice::setWord(const QString& word) {
  const auto kind = std::ranges::find_if(kinds_, [&](const SourceKind& each) { return each.fits(word); });
  if (kind == kinds_.end()) return;
  kind_->setCurrentIndex(static_cast<int>(kind - kinds_.begin()));
  if (kind->entry != SourceKind::Entry::none) entry_->setEditText(word.mid(kind->prefix.size()));
}

QString PartChoice::word() const {
  const SourceKind& kind = chosen();
  return kind.entry == SourceKind::Entry::none ? kind.prefix : kind.prefix + asEntered(entry_->currentText());
}

QString PartChoice::missing() const {
  const SourceKind& kind = chosen();
  const bool entered = kind.entry == SourceKind::Entry::none || !asEntered(entry_->currentText()).isEmpty();
  return entered ? QString() : kind.missing;
}

void PartChoice::offer(const QStringList& found) {
  found_ = found;
  const QString entered = entry_->currentText();
  const QSignalBlocker quiet(entry_);  // nothing was entered: what is wrong with the part still is
  showKind();
  entry_->setEditText(entered);
}

void PartChoice::setProblem(const QString& why) {
  problem_->setText(why);
  problem_->setVisible(!why.isEmpty());
}

void PartChoice::takeFocus() {
  QWidget* to = entry_->isVisibleTo(this) ? entry_ : kind_;
  to->setFocus(Qt::OtherFocusReason);
}

/// Each kind has its own entry: who looks at another kind and comes back finds what was typed.
void PartChoice::takeKind() {
  entries_[shown_] = entry_->currentText();
  shown_ = static_cast<std::size_t>(std::max(0, kind_->currentIndex()));
  showKind();
  QString entry = entries_[shown_];
  if (entry.isEmpty() && chosen().entry == SourceKind::Entry::found && !found_.isEmpty()) entry = found_.front();
  {
    const QSignalBlocker quiet(entry_);
    entry_->setEditText(entry);
  }
  setProblem({});
  emit changed();
}

void PartChoice::showKind() {
  const SourceKind& kind = chosen();
  const QSignalBlocker quiet(entry_);
  entry_->clear();
  if (kind.entry == SourceKind::Entry::found) entry_->addItems(found_);
  entry_->setCurrentIndex(-1);
  entry_->lineEdit()->setPlaceholderText(kind.example);
  entry_->setAccessibleName(tr("%1: %2").arg(kind_->accessibleName(), kind.label));
  entry_->setVisible(kind.entry != SourceKind::Entry::none);
  browse_->setVisible(kind.entry == SourceKind::Entry::file || kind.entry == SourceKind::Entry::folder);
  browse_->setAccessibleName(tr("%1: choose the file").arg(kind_->accessibleName()));
}

void PartChoice::browse() {
  const SourceKind& kind = chosen();
  auto* dialog = new QFileDialog(this, kind.label, asEntered(entry_->currentText()), kind.file_filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(kind.entry == SourceKind::Entry::folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
  dialog->setModal(false);  // nothing is modal while a device can move
  connect(dialog, &QFileDialog::fileSelected, entry_, &QComboBox::setEditText);
  dialog->show();
}

}  // namespace fyd::widgets
