#include "widgets/basics/readout.h"

#include <QPainter>

#include "widgets/basics/number_text.h"

namespace fyd::widgets {
namespace {

constexpr int kSwatch = 16;  // px, the piece of curve before a small entry

int lineHeight(TextSize size) { return QFontMetrics(textFont(size)).height(); }

}  // namespace

Readout::Readout(QString title, QString unit, std::vector<Entry> entries, bool large, QWidget* parent)
    : QWidget(parent),
      title_(std::move(title)),
      unit_(std::move(unit)),
      entries_(std::move(entries)),
      texts_(entries_.size(), kNoValue),
      large_(large) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  setAccessibleName(tr("%1 in %2").arg(title_, unit_));
  connect(&Look::instance(), &Look::changed, this, qOverload<>(&QWidget::update));
  describe();
}

void Readout::setValue(std::size_t entry, double value) {
  const QString text = numberText(value, entries_[entry].decimals);
  if (text == texts_[entry]) return;
  texts_[entry] = text;
  describe();
  update();
}

void Readout::setNote(const QString& note) {
  if (note == note_) return;
  note_ = note;
  describe();
  update();
}

void Readout::setWhen(const QString& when) {
  if (when == when_) return;
  when_ = when;
  describe();
  update();
}

void Readout::describe() {
  QStringList parts;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    parts << (entries_[i].label.isEmpty() ? QString() : entries_[i].label + QLatin1Char(' ')) + texts_[i] +
                 QLatin1Char(' ') + unit_;
  }
  for (const QString& word : {when_, note_}) {
    if (!word.isEmpty()) parts << word;
  }
  setAccessibleDescription(parts.join(QStringLiteral(", ")));
}

int Readout::contentHeight() const {
  const int lines = static_cast<int>(entries_.size());
  if (large_) return lineHeight(TextSize::small) * (1 + lines) + lineHeight(TextSize::number);
  return lineHeight(TextSize::small) * 2 + lineHeight(TextSize::normal) * lines;
}

int Readout::columnWidth() {
  const int number = QFontMetrics(textFont(TextSize::number, true)).horizontalAdvance(QStringLiteral("−0.00"));
  const int unit = QFontMetrics(textFont(TextSize::normal)).horizontalAdvance(QStringLiteral(" N/mm"));
  return number + unit + 2 * kGrid;
}

QSize Readout::sizeHint() const { return {columnWidth(), contentHeight() + kGrid}; }

QSize Readout::minimumSizeHint() const { return {columnWidth(), lineHeight(TextSize::small)}; }

void Readout::paintHead(QPainter& painter, int width, int y, const QString& aside, const QColor& colour) const {
  painter.setFont(textFont(TextSize::small));
  const QFontMetrics metrics = painter.fontMetrics();
  const QString right = metrics.elidedText(aside, Qt::ElideRight, 2 * width / 3);
  const int taken = right.isEmpty() ? 0 : metrics.horizontalAdvance(right) + kGrid / 2;
  painter.setPen(theme().muted);
  painter.drawText(0, y + metrics.ascent(), metrics.elidedText(title_, Qt::ElideRight, width - taken));
  painter.setPen(colour);
  if (!right.isEmpty()) painter.drawText(width - taken + kGrid / 2, y + metrics.ascent(), right);
}

void Readout::paintEntry(QPainter& painter, std::size_t entry, int y, const QFont& number_font) const {
  const Entry& e = entries_[entry];
  const QFontMetrics number(number_font);
  const QFontMetrics small(textFont(TextSize::small));
  const int baseline = y + number.ascent();
  const bool none = texts_[entry] == kNoValue;
  const int right = width() - small.horizontalAdvance(QStringLiteral("N/mm")) - kGrid / 2;
  const int left = right - number.horizontalAdvance(texts_[entry]);
  if (!e.label.isEmpty()) {
    QPen pen(theme().of(e.quantity), 2);
    if (e.dashed) pen.setDashPattern({2.5, 1.5});
    painter.setPen(pen);
    painter.drawLine(QPointF(0, baseline - number.ascent() / 2.5), QPointF(kSwatch, baseline - number.ascent() / 2.5));
    painter.setFont(textFont(TextSize::small));
    painter.setPen(theme().muted);
    const int from = kSwatch + kGrid / 2;
    painter.drawText(from, baseline, small.elidedText(e.label, Qt::ElideRight, left - from - kGrid / 2));
  }
  painter.setFont(number_font);
  painter.setPen(none ? theme().muted : theme().of(e.quantity));
  painter.drawText(left, baseline, texts_[entry]);
  painter.setFont(textFont(TextSize::small));
  painter.setPen(theme().muted);
  painter.drawText(right + kGrid / 2, baseline, unit_);
}

void Readout::paintFlowing(QPainter& painter, std::size_t first, QRect room) const {
  painter.setFont(textFont(TextSize::small));
  const QFontMetrics metrics = painter.fontMetrics();
  int x = room.left();
  int y = room.top();
  for (std::size_t i = first; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    QString text = e.label.isEmpty() ? texts_[i] : e.label + QLatin1Char(' ') + texts_[i];
    if (i + 1 == entries_.size() && !unit_.isEmpty()) text += QLatin1Char(' ') + unit_;
    const int wide = metrics.horizontalAdvance(text);
    if (x > room.left() && x + wide > room.right() + 1) {
      x = room.left();
      y += metrics.height();
    }
    if (y + metrics.ascent() > room.bottom() + 1) return;
    painter.setPen(texts_[i] == kNoValue ? theme().muted : theme().of(e.quantity));
    painter.drawText(x, y + metrics.ascent(), metrics.elidedText(text, Qt::ElideRight, room.right() + 1 - x));
    x += wide + kGrid;
  }
}

// A low strip has a line or two: the name and what is said of the values in the first, the values below or beside it.
void Readout::paintLow(QPainter& painter) const {
  const int small = lineHeight(TextSize::small);
  const bool noted = !note_.isEmpty();
  if (height() < 2 * small) {
    const int half = width() / 2;
    const int y = (height() - small) / 2;
    paintHead(painter, half - kGrid / 2, y, {}, theme().muted);
    paintFlowing(painter, 0, QRect(half, y, width() - half, small));
    return;
  }
  const int title = lineHeight(TextSize::title);
  const bool number_fits = large_ && height() >= small + title + (entries_.size() > 1 ? small : 0);
  int y = number_fits || height() < 3 * small ? std::max(0, (height() - small - (number_fits ? title : small)) / 2) : 0;
  if (entries_.size() > 1) y = 0;
  paintHead(painter, width(), y, noted ? note_ : when_, noted ? theme().warning : theme().muted);
  y += small;
  if (number_fits) {
    paintEntry(painter, 0, y, textFont(TextSize::title, true));
    y += title;
  }
  paintFlowing(painter, number_fits ? 1 : 0, QRect(0, y, width(), height() - y));
}

void Readout::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (height() < contentHeight()) {
    paintLow(painter);
    return;
  }
  const int small = lineHeight(TextSize::small);
  int y = (height() - contentHeight()) / 2;
  paintHead(painter, width(), y, when_, theme().muted);
  y += small;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const QFont font = large_ && i == 0 ? textFont(TextSize::number, true)
                                        : textFont(large_ ? TextSize::small : TextSize::normal, !large_);
    paintEntry(painter, i, y, font);
    y += QFontMetrics(font).height();
  }
  if (!note_.isEmpty()) {
    painter.setFont(textFont(TextSize::small));
    painter.setPen(theme().warning);
    const QString note = painter.fontMetrics().elidedText(note_, Qt::ElideRight, width());
    painter.drawText(width() - painter.fontMetrics().horizontalAdvance(note), y + painter.fontMetrics().ascent(), note);
  }
}

}  // namespace fyd::widgets
