#include "app/console/window/help_dock.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QTextBlock>
#include <QTextTable>
#include <QTimer>
#include <QVBoxLayout>

#include "app/console/window/manual.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/undragged.h"

namespace fyd::console {

using widgets::kGrid;

namespace {
const QString kContents = QStringLiteral("README.md");
constexpr int kPageWidth = 54 * kGrid;  // px: a table of four columns fits without breaking words

/// A page that scales its images to its width.
class ManualPage : public widgets::Undragged<QTextBrowser> {
 public:
  using Undragged::Undragged;
  QSize sizeHint() const override { return {kPageWidth, kPageWidth}; }
  QVariant loadResource(int type, const QUrl& name) override {
    QVariant found = QTextBrowser::loadResource(type, name);
    // In 32 bits: a palette's picture is scaled to its palette's colours, in a pattern of dots.
    const QImage image =
        type == QTextDocument::ImageResource
            ? QImage::fromData(found.toByteArray()).convertToFormat(QImage::Format_ARGB32_Premultiplied)
            : QImage();
    const int room = std::max(kPageWidth, viewport()->width()) - 2 * kGrid;
    if (image.width() <= room) return found;
    QImage fitting = image.scaledToWidth(qRound(room * devicePixelRatioF()), Qt::SmoothTransformation);
    fitting.setDevicePixelRatio(devicePixelRatioF());
    return fitting;
  }
};

/// Links are underlined, because their colour alone hardly differs from the text's.
void underlineLinks(QTextDocument& page) {
  QTextCharFormat underlined;
  underlined.setFontUnderline(true);
  for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      if (!part.fragment().charFormat().isAnchor()) continue;
      QTextCursor link(&page);
      link.setPosition(part.fragment().position());
      link.setPosition(part.fragment().position() + part.fragment().length(), QTextCursor::KeepAnchor);
      link.mergeCharFormat(underlined);
    }
  }
}
}  // namespace

HelpDock::HelpDock(QWidget* parent) : HelpDock(new QWidget, parent) {}

HelpDock::HelpDock(QWidget* body, QWidget* parent)
    : SideDock(tr("Manual"), QStringLiteral("help_close"), tr("Close the manual"), body, parent),
      page_(new ManualPage(body)),
      field_(new QLineEdit(body)),
      found_(new QListWidget(body)),
      back_(new QToolButton(body)) {
  build(*body);
  connect(page_, &QTextBrowser::anchorClicked, this, &HelpDock::follow);
  connect(field_, &QLineEdit::textChanged, this, &HelpDock::search);
  connect(field_, &QLineEdit::returnPressed, this, [this] {
    if (found_->count() > 0) goToFound(found_->item(0));
  });
  connect(found_, &QListWidget::itemActivated, this, &HelpDock::goToFound);
  connect(found_, &QListWidget::itemClicked, this, &HelpDock::goToFound);
  connect(back_, &QToolButton::clicked, this, [this] {
    if (!former_.isEmpty()) load(former_.takeLast());
  });
  // The loaded page keeps the former theme's colours, so it is loaded again.
  connect(&widgets::Look::instance(), &widgets::Look::changed, this, [this] {
    if (!topic_.isEmpty()) load(topic_);
  });
}

void HelpDock::build(QWidget& body) {
  page_->setOpenLinks(false);
  page_->setAccessibleName(tr("Page of the manual"));
  page_->setFrameShape(QFrame::NoFrame);
  field_->setPlaceholderText(tr("Search the manual"));
  field_->setAccessibleName(field_->placeholderText());
  field_->setClearButtonEnabled(true);
  found_->setAccessibleName(tr("Found in the manual"));
  found_->setMaximumHeight(24 * kGrid);
  found_->hide();
  back_->setText(tr("Back"));
  back_->setObjectName(QStringLiteral("help_back"));
  auto* contents = new QToolButton(&body);
  contents->setText(tr("Contents"));
  contents->setObjectName(QStringLiteral("help_contents"));
  connect(contents, &QToolButton::clicked, this, [this] { showTopic(kContents); });
  auto* bar = new QHBoxLayout;
  bar->addWidget(back_);
  bar->addWidget(contents);
  bar->addWidget(field_, 1);
  auto* layout = new QVBoxLayout(&body);
  layout->setContentsMargins(0, kGrid / 2, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addLayout(bar);
  layout->addWidget(found_);
  layout->addWidget(page_, 1);
}

void HelpDock::showTopic(const QString& topic) {
  const bool opens = topic_.isEmpty() || isHidden();
  if (!topic_.isEmpty() && topic != topic_) former_ << topic_;
  load(topic);
  show();
  raise();
  // Scrolls again once the panel has its final width, because lines then break differently.
  if (opens) QTimer::singleShot(0, this, [this] { scrollTo(manualHeading(topic_)); });
}

void HelpDock::load(const QString& topic) {
  const QString page = topic.section(QLatin1Char('#'), 0, 0);
  page_->setSource(manualPage(page), QTextDocument::MarkdownResource);
  for (QTextFrame* frame : page_->document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat lines = table->format();
    lines.setBorderCollapse(true);
    lines.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    lines.setBorderBrush(widgets::theme().line);
    lines.setCellPadding(0.5 * kGrid);
    lines.setCellSpacing(0);
    table->setFormat(lines);
  }
  underlineLinks(*page_->document());
  topic_ = topic;
  back_->setEnabled(!former_.isEmpty());
  scrollTo(manualHeading(topic));
}

void HelpDock::scrollTo(int heading) {
  for (QTextBlock block = page_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || heading-- != 0) continue;
    QTextCursor cursor(page_->document());
    cursor.movePosition(QTextCursor::End);  // so that coming back to the heading puts it on top
    page_->setTextCursor(cursor);
    cursor.setPosition(block.position());
    page_->setTextCursor(cursor);
    return;
  }
}

void HelpDock::follow(const QUrl& link) {
  if (link.scheme().startsWith(QLatin1String("http"))) {
    QDesktopServices::openUrl(link);
    return;
  }
  const QString page = link.fileName().isEmpty() ? topic_.section(QLatin1Char('#'), 0, 0) : link.fileName();
  if (!page.endsWith(QLatin1String(".md"))) return;  // a file of the sources, not of the manual
  showTopic(link.hasFragment() ? page + QLatin1Char('#') + link.fragment() : page);
}

void HelpDock::search(const QString& words) {
  found_->clear();
  for (const ManualSection& each : searchManual(words)) {
    auto* item = new QListWidgetItem(each.heading + QStringLiteral("  ·  ") + each.title, found_);
    item->setData(Qt::UserRole, each.topic);
  }
  if (found_->count() == 0 && !words.trimmed().isEmpty()) {
    auto* none = new QListWidgetItem(tr("Nothing in the manual has these words."), found_);
    none->setFlags(Qt::NoItemFlags);
  }
  found_->setVisible(found_->count() > 0);
}

void HelpDock::goToFound(const QListWidgetItem* item) {
  const QString topic = item->data(Qt::UserRole).toString();
  if (topic.isEmpty()) return;
  showTopic(topic);
  page_->find(field_->text().section(QLatin1Char(' '), 0, 0));
}

}  // namespace fyd::console
