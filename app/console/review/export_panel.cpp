#include "app/console/review/export_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::numberText;

ExportPanel::ExportPanel(ReviewExports* exports, QWidget* parent)
    : QWidget(parent),
      exports_(exports),
      open_(&QDesktopServices::openUrl),
      format_(new QComboBox(this)),
      whole_(new QRadioButton(tr("The whole session"), this)),
      stretch_(new QRadioButton(this)),
      write_(new QPushButton(tr("Write"), this)),
      written_(new QListWidget(this)),
      folder_(new QPushButton(tr("Show in folder"), this)),
      copy_(new QPushButton(tr("Copy path"), this)),
      words_(new QLabel(this)) {
  build();
  connect(format_, &QComboBox::currentIndexChanged, this, &ExportPanel::showChoice);
  connect(write_, &QPushButton::clicked, this, &ExportPanel::write);
  connect(folder_, &QPushButton::clicked, this, &ExportPanel::showFolder);
  connect(copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(chosenPath()); });
  connect(exports_, &ReviewExports::written, this, [this](const QString& path) {
    auto* item = new QListWidgetItem(QFileInfo(path).fileName());
    item->setData(Qt::UserRole, path);
    item->setToolTip(path);
    written_->insertItem(0, item);
    written_->setCurrentRow(0);
    words_->clear();
    showChoice();
  });
  connect(exports_, &ReviewExports::failed, words_, &QLabel::setText);
  showChoice();
}

void ExportPanel::build() {
  format_->setObjectName(QStringLiteral("export_format"));
  format_->setAccessibleName(tr("Format of the file"));
  // The ending says what is written, and only tables, pictures and messages can be a part of the session.
  const auto add = [this](const QString& name, const char* ending) { format_->addItem(name, QLatin1String(ending)); };
  add(tr("CSV table"), "csv");
  add(tr("MATLAB"), "mat");
  add(tr("MCAP, for robotics viewers"), "mcap");
  add(tr("Video without loss"), "mkv");
  add(tr("Small video"), "avi");
  add(tr("Report as web page"), "html");
  add(tr("Report as PDF"), "pdf");
  whole_->setChecked(true);
  written_->setAccessibleName(tr("Files written"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(widgets::kGrid);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(folder_);
  buttons->addWidget(copy_);
  buttons->addStretch(1);
  for (QWidget* each : {static_cast<QWidget*>(format_), static_cast<QWidget*>(whole_), static_cast<QWidget*>(stretch_),
                        static_cast<QWidget*>(write_), static_cast<QWidget*>(words_)}) {
    layout->addWidget(each);
  }
  layout->addWidget(written_, 1);
  layout->addLayout(buttons);
}

void ExportPanel::setMarks(double a_s, double b_s) {
  marked_ = std::isfinite(a_s) && std::isfinite(b_s);
  if (marked_) std::tie(from_s_, to_s_) = std::minmax(a_s, b_s);
  showChoice();
}

void ExportPanel::clear() {
  written_->clear();
  words_->clear();
  whole_->setChecked(true);
  setMarks(std::nan(""), std::nan(""));
}

void ExportPanel::showChoice() {
  const QString ending = format_->currentData().toString();
  const bool report = ending == QStringLiteral("html") || ending == QStringLiteral("pdf");
  stretch_->setText(report    ? tr("From A to B: a report is of the whole session")
                    : marked_ ? tr("From A to B: %1 s to %2 s").arg(numberText(from_s_, 3), numberText(to_s_, 3))
                              : tr("From A to B: set them with [ and ]"));
  stretch_->setEnabled(marked_ && !report);
  if (!stretch_->isEnabled()) whole_->setChecked(true);
  for (QPushButton* button : {folder_, copy_}) button->setEnabled(written_->count() > 0);
}

void ExportPanel::write() {
  words_->clear();
  const QString ending = format_->currentData().toString();
  if (stretch_->isChecked()) {
    exports_->exportStretch(ending, from_s_, to_s_);
  } else {
    exports_->exportAs(ending);
  }
}

QString ExportPanel::chosenPath() const {
  const QListWidgetItem* item = written_->currentItem() != nullptr ? written_->currentItem() : written_->item(0);
  return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
}

void ExportPanel::showFolder() {
  const QString folder = QFileInfo(chosenPath()).absolutePath();
  words_->setText(
      open_(QUrl::fromLocalFile(folder))
          ? QString()
          : tr("This computer opens no folder from here: %1. Copy path takes the file's path along.").arg(folder));
}

}  // namespace fyd::console
