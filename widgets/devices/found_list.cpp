#include "widgets/devices/found_list.h"

#include <QToolButton>

#include "widgets/basics/theme.h"
#include "widgets/devices/device_text.h"

namespace fyd::widgets {
namespace {

QString useWord(FoundRow::Use use) {
  switch (use) {
    case FoundRow::Use::touchpad: return FoundList::tr("Touchpad");
    case FoundRow::Use::motors: return FoundList::tr("Motors");
    case FoundRow::Use::camera: return FoundList::tr("Camera");
  }
  return {};
}

}  // namespace

FoundList::FoundList(QWidget* parent)
    : QFrame(parent),
      summary_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      look_(new QPushButton(tr("Look again"), this)),
      layout_(new QVBoxLayout(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Plugged in"));
  auto* title = new QLabel(tr("Plugged in"), this);
  title->setFont(textFont(TextSize::normal, true));
  summary_->setFont(textFont(TextSize::small));
  summary_->setProperty("role", "muted");
  summary_->setWordWrap(true);
  progress_->setTextVisible(false);
  progress_->setRange(0, 100);
  progress_->setFixedHeight(kGrid / 2);
  progress_->setAccessibleName(tr("Search for devices"));
  look_->setObjectName(QStringLiteral("look_again"));
  look_->setAutoDefault(false);
  look_->setToolTip(tr("Lists serial ports and cameras as \"fyd devices\" does. Nothing that is in use is disturbed."));
  layout_->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  layout_->setSpacing(kGrid);
  layout_->addWidget(title);
  layout_->addWidget(summary_);
  layout_->addWidget(progress_);
  layout_->addStretch(1);
  layout_->addWidget(look_);
  progress_->hide();
  connect(look_, &QPushButton::clicked, this, &FoundList::lookAsked);
}

void FoundList::showProgress(const QString& what, double part) {
  summary_->setText(what);
  progress_->setValue(static_cast<int>(100.0 * part));
  progress_->show();
  look_->setEnabled(false);
}

void FoundList::setFound(const std::vector<FoundRow>& rows) {
  progress_->hide();
  look_->setEnabled(true);
  delete body_;
  body_ = new QWidget(this);
  auto* list = new QVBoxLayout(body_);
  list->setContentsMargins(0, 0, 0, 0);
  list->setSpacing(kGrid);
  layout_->insertWidget(3, body_);
  count_ = 0;
  for (const FoundRow& row : rows) addRow(row);
  summary_->setText(count_ > 0
                        ? tr("What one is used as goes into the form; Connect takes it.")
                        : tr("No serial port and no camera. A touchpad on the network is not searched for: enter its "
                             "address. Simulated parts work without any."));
}

void FoundList::addRow(const FoundRow& row) {
  auto* entry = new QWidget(body_);
  auto* lines = new QVBoxLayout(entry);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(0);
  const auto add = [&](const QString& text, bool strong, const char* role) {
    if (text.isEmpty()) return;
    auto* label = new QLabel(text, entry);
    label->setFont(textFont(TextSize::small, strong));
    label->setProperty("role", role);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    lines->addWidget(label);
  };
  add(row.name.isEmpty() ? row.kind : tr("%1: %2").arg(row.kind, row.name), true, "");
  add(breakable(row.path), false, "muted");
  add(row.problem, false, "warning");
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid / 2);
  for (const FoundRow::Use use : row.uses) {
    auto* button = new QToolButton(entry);
    button->setText(useWord(use));
    button->setAccessibleName(tr("Use %1 as: %2").arg(row.path, useWord(use)));
    button->setToolTip(tr("Puts it into the form; nothing is connected yet."));
    connect(button, &QToolButton::clicked, this, [this, use, path = row.path] { emit useAsked(use, path); });
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  lines->addLayout(buttons);
  entry->setAccessibleName(row.kind + QLatin1Char(' ') + row.path);
  body_->layout()->addWidget(entry);
  ++count_;
}

}  // namespace fyd::widgets
