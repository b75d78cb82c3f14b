#include "widgets/curves/axis_scale.h"

#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/words.h"
#include "widgets/curves/plot_style.h"
#include "widgets/curves/time_window.h"

namespace fyd::widgets {
namespace {

constexpr int kApart_px = 6;      // least distance of two numbers beside each other
constexpr int kEdge_px = 4;       // from the plot's left end to the title
constexpr int kBelow_px = 5;      // the words stand on the numbers' line
constexpr int kRoom_px = 40;      // least distance of two ticks on a level axis
constexpr int kMostTicks = 6;     // on a level axis
constexpr int kMostDecimals = 6;  // beyond: powers of ten
constexpr double kMost = 1e6;     // larger numbers are written with powers of ten

/// Half of what a label covers along its axis.
double halfOf(const QCPAxis& axis, const QString& label) {
  const QFontMetrics metrics(axis.tickLabelFont());
  return 0.5 * (axis.orientation() == Qt::Horizontal ? metrics.horizontalAdvance(label) : metrics.ascent());
}

bool fits(const QCPAxis& axis, const QVector<double>& ticks, const QVector<QString>& labels, qsizetype first,
          qsizetype stride) {
  const int apart_px = axis.orientation() == Qt::Horizontal ? kApart_px : 1;
  double end = -std::numeric_limits<double>::infinity();
  // Along the pixels, which count downwards on an upright axis.
  std::vector<std::pair<double, double>> places;
  for (qsizetype i = first; i < ticks.size(); i += stride) {
    if (labels[i].isEmpty()) continue;
    const double at = axis.coordToPixel(ticks[i]);
    places.emplace_back(at - halfOf(axis, labels[i]), at + halfOf(axis, labels[i]));
  }
  std::ranges::sort(places);
  for (const auto& [from, to] : places) {
    if (from < end + apart_px) return false;
    end = to;
  }
  return true;
}

/// Least number of decimals that write this step exactly: 0 for 2, 1 for 2.5; more than kMostDecimals when none do.
int decimalsOf(double step) {
  int decimals = 0;
  double scaled = step;
  while (decimals <= kMostDecimals && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled) {
    scaled *= 10.0;
    ++decimals;
  }
  return decimals;
}

}  // namespace

void keepLabelsWithRoom(const QCPAxis& axis, const QVector<double>& ticks, QVector<QString>& labels, int before_px,
                        int after_px) {
  const bool level = axis.orientation() == Qt::Horizontal;
  const QRect viewport = axis.axisRect()->parentPlot()->viewport();
  const double least = level ? before_px : 0;
  const double most = level ? viewport.width() - after_px : viewport.height();
  for (qsizetype i = 0; i < labels.size(); ++i) {
    const double at = axis.coordToPixel(ticks[i]);
    if (at - halfOf(axis, labels[i]) < least || at + halfOf(axis, labels[i]) > most) labels[i].clear();
  }
  for (qsizetype stride = 1; stride <= labels.size(); ++stride) {
    // The zero stays, where there is one.
    const auto zero = std::ranges::min_element(ticks, {}, [](double tick) { return std::abs(tick); });
    const qsizetype first = (zero - ticks.begin()) % stride;
    if (!fits(axis, ticks, labels, first, stride)) continue;
    for (qsizetype i = 0; i < labels.size(); ++i) {
      if (i % stride != first) labels[i].clear();
    }
    return;
  }
}

void NumberTicker::generate(const QCPRange& range, const QLocale& locale, QChar format, int precision,
                            QVector<double>& ticks, QVector<double>* sub_ticks, QVector<QString>* labels) {
  const bool level = axis_->orientation() == Qt::Horizontal;
  if (level) setTickCount(std::clamp(axis_->axisRect()->width() / kRoom_px, 1, kMostTicks));
  QCPAxisTicker::generate(range, locale, format, precision, ticks, sub_ticks, labels);
  if (labels == nullptr) return;
  const int decimals = decimalsOf(getTickStep(range));
  for (qsizetype i = 0; i < ticks.size(); ++i) {
    const double number = ticks[i] + at_zero_;
    if (std::abs(number) < kMost && decimals <= kMostDecimals) {
      (*labels)[i] = numberText(number, decimals) + unit_;
    } else if (at_zero_ != 0.0) {
      (*labels)[i] = plainNumber(number) + unit_;  // the label that there is counts from the axis' own zero
    } else {
      (*labels)[i] = (*labels)[i].replace(QLatin1Char('-'), QChar(0x2212)) + unit_;
    }
  }
  keepLabelsWithRoom(*axis_, ticks, *labels, before_px_, after_px_);
}

void NameTicker::generate(const QCPRange& range, const QLocale& locale, QChar format, int precision,
                          QVector<double>& ticks, QVector<double>* sub_ticks, QVector<QString>* labels) {
  QCPAxisTickerText::generate(range, locale, format, precision, ticks, sub_ticks, labels);
  if (labels != nullptr) keepLabelsWithRoom(*axis_, ticks, *labels);
}

LevelScale::LevelScale(QCustomPlot& plot)
    : plot_(&plot),
      numbers_(new NumberTicker(*plot.xAxis)),
      title_(new QCPItemText(&plot)),
      end_(new QCPItemText(&plot)) {
  plot.xAxis->setTicker(numbers_);
  for (QCPItemText* text : {title_, end_}) {
    const bool left = text == title_;
    text->setClipToAxisRect(false);
    text->position->setType(QCPItemPosition::ptViewportRatio);
    text->position->setCoords(left ? 0.0 : 1.0, 1.0);
    text->setPositionAlignment((left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
    text->setPadding({left ? kEdge_px : 0, 0, left ? 0 : 1, kBelow_px});
    text->setVisible(false);
  }
  dress();
}

void LevelScale::setVisible(bool visible) {
  visible_ = visible;
  plot_->xAxis->setTickLabels(visible);
  arrange();
}

void LevelScale::setTitle(const QString& title) { setTexts(title, {}); }

void LevelScale::showTime(const TimeWindow& window) {
  const bool live = window.following();
  numbers_->setShown(live ? 0.0 : window.to_s());
  numbers_->setUnit(live ? QStringLiteral(" ") + tr("s") : QString());
  setTexts(live ? QString() : tr("session time, s"), live ? tr("now") : QString());
  plot_->xAxis->setRange(-window.span_s(), 0.0);
}

void LevelScale::setTexts(const QString& title, const QString& end) {
  if (title == title_->text() && end == end_->text()) return;
  title_->setText(title);
  end_->setText(end);
  arrange();
}

void LevelScale::dress() {
  for (QCPItemText* text : {title_, end_}) {
    text->setFont(textFont(TextSize::small));
    text->setColor(theme().muted);
  }
  arrange();
}

void LevelScale::arrange() {
  const QFontMetrics metrics(title_->font());
  for (QCPItemText* text : {title_, end_}) text->setVisible(visible_ && !text->text().isEmpty());
  const auto room = [&](const QCPItemText& text) {
    return text.text().isEmpty() ? 0 : metrics.horizontalAdvance(text.text()) + kApart_px + kEdge_px;
  };
  numbers_->setEnds(room(*title_), room(*end_));
}

}  // namespace fyd::widgets
