#include "widgets/status/part_list.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <numeric>

#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kIcon = 16;

QColor healthColour(PartView::Health health) {
  switch (health) {
    case PartView::Health::well: return theme().muted;
    case PartView::Health::doubtful:
    case PartView::Health::missing: return theme().warning;
  }
  return theme().muted;
}

QString briefFigures(const PartView& part) {
  return part.health == PartView::Health::well ? part.figures.section(QStringLiteral(" · "), 0, 0) : part.figures;
}

/// Where its figures begin, from its left edge.
int figuresLeft(const PartView& part) {
  return kIcon + kGrid / 2 + QFontMetrics(textFont(TextSize::small, true)).horizontalAdvance(part.name) + kGrid / 2 + 2;
}

}  // namespace

PartList::PartList(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setAccessibleName(tr("Parts and link"));
  setMouseTracking(true);
  connect(&Look::instance(), &Look::changed, this, qOverload<>(&QWidget::update));
}

QSize PartList::sizeHint() const { return {300, QFontMetrics(textFont(TextSize::normal)).height() + kGrid / 2}; }

void PartList::setParts(const std::vector<PartView>& parts) {
  if (parts == parts_) return;
  parts_ = parts;
  for (std::vector<int>* needs : {&needs_, &brief_needs_}) needs->resize(parts_.size());
  QStringList words;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const PartView& part = parts_[i];
    words << part.name + QLatin1Char(' ') + part.figures;
    const auto need = [&](const QString& figures) {
      return figuresLeft(part) + QFontMetrics(textFont(TextSize::small)).horizontalAdvance(figures) + 2 * kGrid;
    };
    needs_[i] = std::max(needs_[i], need(part.figures));
    brief_needs_[i] = std::max(brief_needs_[i], need(briefFigures(part)));
  }
  setAccessibleDescription(words.join(QStringLiteral("; ")));
  update();
}

bool PartList::brief() const { return std::accumulate(needs_.begin(), needs_.end(), 0) > width(); }

QString PartList::shownFigures(const PartView& part) const { return brief() ? briefFigures(part) : part.figures; }

std::vector<QRect> PartList::places() const {
  // The largest width each has needed plus an equal share of the rest, so that none moves when a figure changes its
  // width. Where there is too little room, the short ones have what they need and the long ones share what is left.
  const int count = std::max(1, static_cast<int>(parts_.size()));
  const std::vector<int>& needs = brief() ? brief_needs_ : needs_;
  const int needed = std::accumulate(needs.begin(), needs.end(), 0);
  std::vector<int> columns = needs;
  if (needed <= width()) {
    for (int& column : columns) column += (width() - needed) / count;
  } else {
    std::vector<int> rising = needs;
    std::ranges::sort(rising);
    int left = width();
    int longest = 0;
    for (std::size_t i = 0; i < rising.size(); ++i) {
      longest = left / static_cast<int>(rising.size() - i);
      if (rising[i] > longest) break;
      left -= rising[i];
    }
    for (int& column : columns) column = std::min(column, longest);
  }
  std::vector<QRect> out;
  int edge = 0;
  for (const int column : columns) {
    out.emplace_back(edge, 0, column - kGrid, height());
    edge += column;
  }
  return out;
}

void PartList::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const std::vector<QRect> where = places();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const PartView& part = parts_[i];
    const QRect& rect = where[i];
    const bool well = part.health == PartView::Health::well;
    const QColor colour = healthColour(part.health);
    const int middle = rect.center().y();
    paintIcon(painter, QRect(rect.left(), middle - kIcon / 2 + 1, kIcon, kIcon),
              well ? part.icon : QStringLiteral("warning"), colour);
    const int name_x = rect.left() + kIcon + kGrid / 2;
    QFont name_font = textFont(TextSize::small, true);
    name_font.setUnderline(static_cast<int>(i) == hovered_);
    painter.setFont(name_font);
    painter.setPen(theme().text);
    painter.drawText(QRect(name_x, rect.top(), rect.right() - name_x, rect.height()), Qt::AlignVCenter, part.name);
    const int x = rect.left() + figuresLeft(part);
    painter.setFont(textFont(TextSize::small));
    painter.setPen(well ? theme().muted : colour);
    const int room = rect.right() - x;
    painter.drawText(QRect(x, rect.top(), room, rect.height()), Qt::AlignVCenter,
                     QFontMetrics(painter.font()).elidedText(shownFigures(part), Qt::ElideRight, room));
  }
}

QRect PartList::place(const QString& name) const {
  const std::vector<QRect> where = places();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].name == name) return where[i];
  }
  return {};
}

int PartList::openingPartAt(const QPoint& where) const {
  const std::vector<QRect> all = places();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].opens && all[i].contains(where)) return static_cast<int>(i);
  }
  return -1;
}

void PartList::hover(int part) {
  if (part == hovered_) return;
  hovered_ = part;
  setCursor(part >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void PartList::mouseMoveEvent(QMouseEvent* event) { hover(openingPartAt(event->position().toPoint())); }

void PartList::leaveEvent(QEvent* /*event*/) { hover(-1); }

void PartList::mouseReleaseEvent(QMouseEvent* event) {
  const int part = openingPartAt(event->position().toPoint());
  if (event->button() == Qt::LeftButton && part >= 0) emit opened(parts_[static_cast<std::size_t>(part)].name);
}

bool PartList::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const std::vector<QRect> where = places();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (where[i].contains(help->pos())) {
      const PartView& part = parts_[i];
      QToolTip::showText(help->globalPos(),
                         part.name + QStringLiteral(": ") + part.figures +
                             (part.detail.isEmpty() ? QString() : QLatin1Char('\n') + part.detail),
                         this);
    }
  }
  return true;
}

QString rateAndAge(double rate_hz, double age_ms) {
  QStringList words;
  if (rate_hz >= 0.5) words << PartList::tr("%1 Hz").arg(numberText(rate_hz, 0));
  if (std::isfinite(age_ms)) words << ageText(age_ms);
  return words.isEmpty() ? kNoValue : words.join(QStringLiteral(" · "));
}

}  // namespace fyd::widgets
