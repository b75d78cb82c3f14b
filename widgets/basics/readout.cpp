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

void Readout::describe() {
  QStringList parts;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    parts << (entries_[i].label.isEmpty() ? QString() : entries_[i].label + QLatin1Char(' ')) + texts_[i] +
                 QLatin1Char(' ') + unit_;
  }
  if (!note_.isEmpty()) parts << note_;
  setAccessibleDescription(parts.join(QStringLiteral(", ")));
}

int Readout::contentHeight() const {
  const int lines = static_cast<int>(entries_.size());
  if (large_) return lineHeight(TextSize::small) * (1 + lines) + lineHeight(TextSize::number);
  return lineHeight(TextSize::small) * 2 + lineHeight(TextSize::normal) * lines;
}

QSize Readout::sizeHint() const {
  const int number = QFontMetrics(textFont(TextSize::number, true)).horizontalAdvance(QStringLiteral("−0.00"));
  const int unit = QFontMetrics(textFont(TextSize::normal)).horizontalAdvance(QStringLiteral(" N/mm"));
  return {number + unit + 2 * kGrid, contentHeight() + kGrid};
}

QSize Readout::minimumSizeHint() const { return {sizeHint().width(), lineHeight(TextSize::number)}; }

void Readout::paintEntry(QPainter& painter, std::size_t entry, int y, const QFont& number_font) const {
  const Entry& e = entries_[entry];
  const QFontMetrics number(number_font);
  const QFontMetrics unit(textFont(TextSize::small));
  const int baseline = y + number.ascent();
  const bool none = texts_[entry] == kNoValue;
  int x = 0;
  if (!e.label.isEmpty()) {
    QPen pen(theme().of(e.quantity), 2);
    if (e.dashed) pen.setDashPattern({2.5, 1.5});
    painter.setPen(pen);
    painter.drawLine(QPointF(0, baseline - number.ascent() / 2.5), QPointF(kSwatch, baseline - number.ascent() / 2.5));
    painter.setFont(textFont(TextSize::small));
    painter.setPen(theme().muted);
    painter.drawText(kSwatch + kGrid / 2, baseline, e.label);
    x = kSwatch;
  }
  const int unit_width = unit.horizontalAdvance(QStringLiteral("N/mm")) + kGrid / 2;
  painter.setFont(number_font);
  painter.setPen(none ? theme().muted : theme().of(e.quantity));
  painter.drawText(QRect(x, y, width() - unit_width - x, number.height()), Qt::AlignRight | Qt::AlignTop,
                   texts_[entry]);
  painter.setFont(textFont(TextSize::small));
  painter.setPen(theme().muted);
  painter.drawText(width() - unit_width + kGrid / 2, baseline, unit_);
}

void Readout::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int small = lineHeight(TextSize::small);
  // In a low strip the name moves into the number's line instead of pushing the last line out.
  const bool low = height() < contentHeight();
  int y = std::max(0, (height() - contentHeight() + (low ? small : 0)) / 2);
  painter.setFont(textFont(TextSize::small));
  painter.setPen(theme().muted);
  painter.drawText(QRect(0, y, width(), small), Qt::AlignLeft | Qt::AlignTop,
                   low ? title_.section(QLatin1Char(','), 0, 0) : title_);
  if (!low) y += small;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const QFont font = large_ && i == 0 ? textFont(low ? TextSize::title : TextSize::number, true)
                                        : textFont(large_ ? TextSize::small : TextSize::normal, !large_);
    paintEntry(painter, i, y, font);
    y += QFontMetrics(font).height();
  }
  if (!note_.isEmpty()) {
    painter.setFont(textFont(TextSize::small));
    painter.setPen(theme().warning);
    painter.drawText(QRect(0, y, width(), small), Qt::AlignRight | Qt::AlignTop,
                     QFontMetrics(painter.font()).elidedText(note_, Qt::ElideRight, width()));
  }
}

}  // namespace fyd::widgets
