#include "widgets/status/notice_stack.h"

#include <QPainter>
#include <QPushButton>
#include <QTextLayout>
#include <algorithm>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kLines = 2;
constexpr int kEdge = 5;  // px, width of the coloured edge

QColor colourOf(Severity severity) {
  switch (severity) {
    case Severity::information: return theme().muted;
    case Severity::warning: return theme().warning;
    case Severity::error: return theme().danger;
  }
  return theme().muted;
}

/// As many of the words as `lines` lines of `width` hold, the last of them elided.
QString fitted(const QString& words, const QFont& font, int width, int lines) {
  QTextLayout layout(words, font);
  layout.beginLayout();
  QString out;
  for (int i = 0; i < lines; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(width);
    const bool last = i + 1 == lines;
    const QString rest = words.mid(line.textStart());
    out += last ? QFontMetrics(font).elidedText(rest, Qt::ElideRight, width)
                : words.mid(line.textStart(), line.textLength());
  }
  layout.endLayout();
  return out;
}

}  // namespace

QString severityWord(Severity severity) {
  switch (severity) {
    case Severity::information: return NoticeStack::tr("Notice");
    case Severity::warning: return NoticeStack::tr("Warning");
    case Severity::error: return NoticeStack::tr("Error");
  }
  return {};
}

NoticeStack::NoticeStack(QWidget* parent)
    : QFrame(parent),
      symbol_(new QLabel(this)),
      label_(new QLabel(this)),
      actions_(new QHBoxLayout),
      more_(new QToolButton(this)),
      close_(new QToolButton(this)) {
  setObjectName(QStringLiteral("notices"));
  label_->setFont(textFont(TextSize::small));
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  more_->setObjectName(QStringLiteral("notice_more"));
  more_->setFont(textFont(TextSize::small));
  more_->setToolTip(tr("Show the next unread notice"));
  close_->setObjectName(QStringLiteral("notice_close"));
  close_->setText(tr("Read"));
  close_->setIcon(icon(QStringLiteral("check")));
  close_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  close_->setFont(textFont(TextSize::small));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, 0, kGrid, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(symbol_);
  layout->addWidget(label_, 1);
  layout->addLayout(actions_);
  layout->addWidget(more_);
  layout->addWidget(close_);
  setFixedHeight(std::max(kLines * QFontMetrics(label_->font()).lineSpacing() + kGrid, 5 * kGrid));
  connect(more_, &QToolButton::clicked, this, &NoticeStack::showNext);
  connect(close_, &QToolButton::clicked, this, &NoticeStack::dismissShown);
  connect(&Look::instance(), &Look::changed, this, &NoticeStack::refresh);
  refresh();
}

QString NoticeStack::shownText() const { return unread_.empty() ? QString() : unread_[shown_].notice.text; }

void NoticeStack::post(Notice notice) {
  const auto same = [&](const Unread& each) { return each.notice.text == notice.text; };
  if (const auto found = std::ranges::find_if(unread_, same); found != unread_.end()) {
    ++found->times;
    std::rotate(found, found + 1, unread_.end());  // the newest again
  } else {
    if (count() >= kMost) dropOne();
    unread_.push_back({.notice = std::move(notice)});
  }
  shown_ = unread_.size() - 1;
  refresh();
}

/// The oldest that tells of nothing wrong, or else the oldest.
void NoticeStack::dropOne() {
  const auto harmless =
      std::ranges::find(unread_, Severity::information, [](const Unread& each) { return each.notice.severity; });
  unread_.erase(harmless != unread_.end() ? harmless : unread_.begin());
}

void NoticeStack::withdraw(const QString& cause) {
  if (std::erase_if(unread_, [&](const Unread& each) { return !cause.isEmpty() && each.notice.cause == cause; }) == 0) {
    return;
  }
  shown_ = unread_.empty() ? 0 : unread_.size() - 1;
  refresh();
}

bool NoticeStack::shows(const QString& cause) const {
  return std::ranges::any_of(unread_, [&](const Unread& each) { return each.notice.cause == cause; });
}

void NoticeStack::dismissShown() {
  if (unread_.empty()) return;
  unread_.erase(unread_.begin() + static_cast<std::ptrdiff_t>(shown_));
  shown_ = unread_.empty() ? 0 : unread_.size() - 1;
  refresh();
}

void NoticeStack::showNext() {
  shown_ = (shown_ + unread_.size() - 1) % std::max<std::size_t>(1, unread_.size());
  refresh();
}

void NoticeStack::dismissAll() {
  unread_.clear();
  shown_ = 0;
  refresh();
}

void NoticeStack::refresh() {
  while (QLayoutItem* item = actions_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  const bool any = !unread_.empty();
  symbol_->setVisible(any);
  close_->setVisible(any);
  more_->setVisible(unread_.size() > 1);
  if (any) {
    const Notice& notice = unread_[shown_].notice;
    const QString symbol =
        notice.severity == Severity::information ? QStringLiteral("info") : QStringLiteral("warning");
    symbol_->setPixmap(icon(symbol, colourOf(notice.severity)).pixmap(QSize(20, 20), devicePixelRatioF()));
    for (const NoticeAction& action : notice.actions) {
      auto* button = new QPushButton(action.text, this);
      button->setObjectName(action.name);
      button->setAutoDefault(false);
      connect(button, &QPushButton::clicked, this, [run = action.run] { run(); });
      actions_->addWidget(button);
      button->show();  // at once, so that the text gets the width that is left
    }
    more_->setText(tr("%1 more").arg(unread_.size() - 1));
    close_->setAccessibleName(tr("Dismiss: %1").arg(notice.text));
    setAccessibleName(severityWord(notice.severity) + QStringLiteral(": ") + notice.text);
  } else {
    setAccessibleName(tr("Notices"));
  }
  fitText();
  update();
}

void NoticeStack::fitText() {
  layout()->activate();
  QString words = tr("No notices. Everything that was said is in the log (Ctrl+L).");
  if (!unread_.empty()) {
    const Unread& shown = unread_[shown_];
    words = shown.times > 1 ? tr("%1 (%2 times)").arg(shown.notice.text).arg(shown.times) : shown.notice.text;
  }
  label_->setProperty("role", unread_.empty() ? "muted" : "");
  restyle(*label_);
  label_->setText(fitted(words, label_->font(), std::max(1, label_->width()), kLines));
  label_->setToolTip(words);
}

void NoticeStack::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fitText();
}

void NoticeStack::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  if (unread_.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme().line, 1));
  painter.setBrush(theme().raised);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colourOf(unread_[shown_].notice.severity));
  painter.drawRoundedRect(QRectF(0, 0, kEdge, height()), 2, 2);
}

}  // namespace fyd::widgets
