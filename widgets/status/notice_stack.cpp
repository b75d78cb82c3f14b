#include "widgets/status/notice_stack.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kWidth = 33 * kGrid;  // the left column's
constexpr int kSlide_ms = 160;

QColor colourOf(Severity severity) {
  switch (severity) {
    case Severity::information: return theme().muted;
    case Severity::warning: return theme().warning;
    case Severity::error: return theme().danger;
  }
  return theme().muted;
}

class NoticeCard : public QFrame {
 public:
  NoticeCard(Severity severity, const QString& text, QWidget* parent)
      : QFrame(parent), severity_(severity), text_(text) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
    symbol_ = new QLabel(this);
    label_ = new QLabel(text, this);
    label_->setWordWrap(true);
    label_->setTextInteractionFlags(Qt::NoTextInteraction);
    auto* close = new QToolButton(this);
    close->setIcon(icon(QStringLiteral("cross")));
    close->setIconSize({14, 14});
    close->setProperty("flat", true);
    close->setFixedSize(24, 24);
    close->setToolTip(NoticeStack::tr("Read"));
    close->setAccessibleName(NoticeStack::tr("Dismiss: %1").arg(text));
    close->setObjectName(QStringLiteral("notice_close"));
    layout->addWidget(symbol_, 0, Qt::AlignTop);
    layout->addWidget(label_, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    close_ = close;
    setAccessibleName(severityWord(severity) + QStringLiteral(": ") + text);
    setFixedWidth(kWidth);
    connect(&Look::instance(), &Look::changed, this, [this] { dress(); });
    dress();
  }
  void again() { label_->setText(NoticeStack::tr("%1 (%2 times)").arg(text_).arg(++times_)); }
  [[nodiscard]] const QString& text() const { return text_; }
  [[nodiscard]] QToolButton* closeButton() const { return close_; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().line, 1));
    painter.setBrush(theme().raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(severity_));
    painter.drawRoundedRect(QRectF(0, 0, 5, height()), 2, 2);
  }

 private:
  void dress() {
    const QString symbol = severity_ == Severity::information ? QStringLiteral("info") : QStringLiteral("warning");
    symbol_->setPixmap(icon(symbol, colourOf(severity_)).pixmap(QSize(20, 20), devicePixelRatioF()));
  }
  Severity severity_;
  QString text_;
  int times_ = 1;
  QLabel* symbol_;
  QLabel* label_;
  QToolButton* close_;
};

}  // namespace

QString severityWord(Severity severity) {
  switch (severity) {
    case Severity::information: return NoticeStack::tr("Notice");
    case Severity::warning: return NoticeStack::tr("Warning");
    case Severity::error: return NoticeStack::tr("Error");
  }
  return {};
}

NoticeStack::NoticeStack(QWidget* over)
    : QWidget(over), layout_(new QVBoxLayout(this)), slide_(new QPropertyAnimation(this, "pos", this)) {
  setAccessibleName(tr("Notices"));
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(kGrid);
  slide_->setDuration(kSlide_ms);
  over->installEventFilter(this);
  hide();
}

QString NoticeStack::text(int index) const {
  return static_cast<NoticeCard*>(layout_->itemAt(index)->widget())->text();
}

void NoticeStack::post(Severity severity, const QString& text) {
  for (int i = 0; i < layout_->count(); ++i) {
    auto* shown = static_cast<NoticeCard*>(layout_->itemAt(i)->widget());
    if (shown->text() == text) {
      shown->again();
      place();
      return;
    }
  }
  while (layout_->count() >= kMost) dismiss(layout_->itemAt(0)->widget());
  auto* card = new NoticeCard(severity, text, this);
  connect(card->closeButton(), &QToolButton::clicked, this, [this, card] { dismiss(card); });
  layout_->addWidget(card);
  card->show();
  place();
  slide_->stop();
  const QPoint home = pos();
  slide_->setStartValue(home - QPoint(3 * kGrid, 0));
  slide_->setEndValue(home);
  slide_->start();
}

void NoticeStack::dismiss(QWidget* notice) {
  layout_->removeWidget(notice);
  notice->hide();
  notice->deleteLater();
  place();
}

void NoticeStack::dismissAll() {
  while (layout_->count() > 0) dismiss(layout_->itemAt(0)->widget());
}

void NoticeStack::place() {
  slide_->stop();
  if (layout_->count() == 0) {
    hide();
    return;
  }
  int height = kGrid * (layout_->count() - 1);
  for (int i = 0; i < layout_->count(); ++i) {
    QWidget* card = layout_->itemAt(i)->widget();
    height += std::max(card->heightForWidth(kWidth), card->minimumSizeHint().height());
  }
  const QRect area = parentWidget()->rect();
  setGeometry(kGrid, area.bottom() - height - kGrid, kWidth, height);
  show();
  raise();
}

bool NoticeStack::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

}  // namespace fyd::widgets
