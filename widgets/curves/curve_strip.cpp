#include "widgets/curves/curve_strip.h"

#include <QRubberBand>
#include <QVBoxLayout>

#include "widgets/basics/number_text.h"
#include "widgets/basics/plot_labels.h"
#include "widgets/curves/axis_scale.h"
#include "widgets/curves/curve_line.h"
#include "widgets/curves/curve_plot.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr int kLineWidth = 1;        // of the curves' pens
constexpr int kLeastHeight_px = 24;  // one line of text
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

QColor colourOf(const Trace& trace) {
  return trace.quantity == Quantity::none ? theme().text : theme().of(trace.quantity);
}

QColor colourOf(const TimeMark& mark) { return mark.strong ? theme().text : theme().muted; }

QPen penOf(const Trace& trace) {
  QColor colour = colourOf(trace);
  if (trace.stroke == Stroke::faint) colour.setAlphaF(0.45F);
  const Qt::PenStyle style = trace.stroke == Stroke::dashed   ? Qt::DashLine
                             : trace.stroke == Stroke::dotted ? Qt::DotLine
                                                              : Qt::SolidLine;
  return {colour, kLineWidth, style};
}

}  // namespace

CurveStrip::CurveStrip(const QString& name, const QString& unit, Range least, std::vector<Trace> traces,
                       bool with_time_scale, QWidget* parent)
    : QWidget(parent),
      plot_(new CurvePlot(this)),
      traces_(std::move(traces)),
      range_(least),
      unit_(unit),
      mark_words_(new QCPItemText(plot_)),
      time_scale_(std::make_unique<LevelScale>(*plot_)),
      labels_(new PlotLabels(*plot_)),
      band_(new QRubberBand(QRubberBand::Rectangle, plot_)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setAccessibleName(tr("%1 over time, %2").arg(name, unit));
  plot_->setAccessibleName(accessibleName());
  plot_->setMinimumHeight(kLeastHeight_px);
  plot_->setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setInteractions({});
  plot_->installEventFilter(this);
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setToolTip(
      tr("Drag to look back, wheel to zoom, drag with the right button to zoom into a box,\n"
         "Ctrl and wheel to stretch this curve, double-click or F to follow again."));
  QCPAxisRect* rect = plot_->axisRect();
  rect->setAutoMargins(QCP::msNone);
  setTimeScale(with_time_scale);
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(*plot_->yAxis)));
  plot_->yAxis->ticker()->setTickCount(3);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setNumberFormat(QStringLiteral("gb"));
    axis->setNumberPrecision(4);
  }
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    auto* graph = new CurveLine(plot_->xAxis, plot_->yAxis);  // the plot owns it
    graph->setAdaptiveSampling(false);                        // the columns already are what the pixels can show
  }
  lanes_ = !traces_.front().lane.isEmpty();
  if (lanes_) buildLanes();
  mark_words_->setLayer(QStringLiteral("overlay"));  // above the curve, which is made after it
  mark_words_->position->setType(QCPItemPosition::ptAxisRectRatio);
  mark_words_->position->setCoords(1.0, 0.0);
  mark_words_->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
  mark_words_->setPadding(QMargins(4, 0, 4, 0));
  mark_words_->setVisible(false);
  connect(&Look::instance(), &Look::changed, this, &CurveStrip::dress);
  dress();
}

CurveStrip::~CurveStrip() = default;

QCustomPlot* CurveStrip::plot() const { return plot_; }

void CurveStrip::setTimeScale(bool shown) {
  plot_->axisRect()->setMargins(QMargins(kCurveLeft_px, 4, kCurveRight_px, shown ? kTimeScale_px : 4));
  plot_->setMinimumHeight(kLeastHeight_px + (shown ? kTimeScale_px : 0));
  time_scale_->setVisible(shown);
  plot_->axesChanged();
}

void CurveStrip::setCursorValues(double time_s, std::vector<double> values) {
  cursor_s_ = time_s;
  cursor_values_ = std::move(values);
}

void CurveStrip::setMarkWords(const QString& words) {
  if (words == mark_words_->text()) return;
  mark_words_->setText(words);
  mark_words_->setVisible(!words.isEmpty());
  setAccessibleDescription(words);
}

QString CurveStrip::markWords() const { return mark_words_->text(); }

void CurveStrip::chooseRange(std::optional<Range> range) {
  chosen_range_ = range;
  fixed_range_.reset();
}

void CurveStrip::setLimits(const std::vector<double>& limits) {
  if (lanes_) return;
  while (limit_lines_.size() < limits.size()) limit_lines_.push_back(new QCPItemStraightLine(plot_));
  for (std::size_t i = 0; i < limit_lines_.size(); ++i) {
    const bool shown = i < limits.size() && std::isfinite(limits[i]);
    limit_lines_[i]->setVisible(shown);
    if (!shown) continue;
    limit_lines_[i]->point1->setCoords(0.0, limits[i]);
    limit_lines_[i]->point2->setCoords(1.0, limits[i]);
    limit_lines_[i]->setPen(QPen(theme().danger, 1, Qt::DashDotLine));
  }
}

std::vector<double> CurveStrip::limits() const {
  std::vector<double> out;
  for (const QCPItemStraightLine* line : limit_lines_) {
    if (line->visible()) out.push_back(line->point1->value());
  }
  return out;
}

void CurveStrip::buildLanes() {
  // Three signals around zero would hide each other in one lane.
  const QSharedPointer<NameTicker> names(new NameTicker(*plot_->yAxis));
  for (std::size_t i = 0; i < traces_.size(); ++i) names->addTick(laneCentre(i), traces_[i].lane);
  plot_->yAxis->setTicker(names);
  scale_text_ = new QCPItemText(plot_);
  scale_text_->position->setType(QCPItemPosition::ptAxisRectRatio);
  scale_text_->position->setCoords(0.0, 0.0);
  scale_text_->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  scale_text_->setPadding(QMargins(4, 0, 4, 0));
}

double CurveStrip::laneCentre(std::size_t trace) const { return static_cast<double>(traces_.size() - 1 - trace); }

void CurveStrip::dress() {
  const Theme& t = theme();
  plot_->setPlotBackground(t.panel);
  QColor grid = t.line;
  grid.setAlphaF(0.6F);
  styleAxes({plot_->xAxis, plot_->yAxis});
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->grid()->setPen(QPen(grid, 0));  // width 0: one pixel
  if (scale_text_ != nullptr) {
    scale_text_->setFont(textFont(TextSize::small));
    scale_text_->setColor(t.muted);
    scale_text_->setBrush(QBrush(t.panel));
  }
  time_scale_->dress();
  mark_words_->setFont(textFont(TextSize::small));
  mark_words_->setColor(t.text);
  mark_words_->setBrush(QBrush(t.panel));
  for (QCPItemStraightLine* line : limit_lines_) line->setPen(QPen(t.danger, 1, Qt::DashDotLine));
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    plot_->graph(static_cast<int>(i))->setPen(penOf(traces_[i]));
  }
  plot_->axesChanged();
}

// One for each width of a line, in which no more can be seen.
std::size_t CurveStrip::columns() const {
  const double scale = plot_->devicePixelRatioF();
  const double pixels = plot_->axisRect()->width() * scale;
  return std::max<std::size_t>(1, static_cast<std::size_t>(pixels / lineWidth_px(kLineWidth, scale)));
}

void CurveStrip::fill(QCPGraph* graph, const Trace& trace, const CurveSource& source, const TimeWindow& window) {
  const std::size_t width = columns();
  source.decimate(trace.channel, window.from_s(), window.to_s(), width, columns_);
  const double last_x = -0.75 * window.span_s() / static_cast<double>(width);
  QVector<QCPGraphData> points;
  points.reserve(static_cast<qsizetype>(columns_.size()) * 2);
  double last = kNaN;
  for (const CurveColumn& column : columns_) {
    if (column.empty) continue;  // zoomed in beyond the samples: the line goes on to the next one
    // The first and the last column extend beyond the plot: their middle is moved inside so that their values are
    // drawn.
    const double x = std::clamp(column.time_s - window.to_s(), -window.span_s(), last_x);
    if (!std::isnan(column.minimum)) {
      double first = column.minimum;
      double second = column.maximum;
      drawn_.lower = std::min(drawn_.lower, first);
      drawn_.upper = std::max(drawn_.upper, second);
      if (std::abs(last - second) < std::abs(last - first)) std::swap(first, second);
      // Dashed lines of many short pieces are slow to draw; a horizontal line needs only its ends.
      const bool level = first == second && first == last && points.size() >= 2 && points.constLast().value == last &&
                         points.at(points.size() - 2).value == last;
      if (level) {
        points.last().key = x;
      } else {
        points.append(QCPGraphData(x, first));
        if (second != first) points.append(QCPGraphData(x, second));
      }
      last = second;
    }
    if (column.gap) {
      points.append(QCPGraphData(x, kNaN));
      last = kNaN;
    }
  }
  graph->data()->set(points, true);
}

void CurveStrip::draw(const CurveSource& source, const TimeWindow& window) {
  drawn_ = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < traces_.size(); ++i) fill(plot_->graph(static_cast<int>(i)), traces_[i], source, window);
  if (drawn_.lower <= drawn_.upper) range_.fit(drawn_.lower, drawn_.upper);
  Range shown = fixed_range_.value_or(baseRange());
  if (lanes_) {
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      for (QCPGraphData& point : *plot_->graph(static_cast<int>(i))->data()) point.value = heightOf(i, point.value);
    }
    scale_text_->setText(tr("each ±%1 %2").arg(plainNumber(laneHeight())).arg(unit_));
    if (!fixed_range_) shown = {-0.5, static_cast<double>(traces_.size()) - 0.5};
  }
  const double margin =
      fixed_range_ || chosen_range_ ? 0.0 : 0.04 * (shown.upper - shown.lower);  // the line at the end stays visible
  drawMarks(window);
  drawLabels(window);
  // Back from now the same numbers stand at the axis all the time.
  if (!window.following() || !drew_live_) plot_->axesChanged();
  drew_live_ = window.following();
  time_scale_->showTime(window);
  plot_->yAxis->setRange(shown.lower - margin, shown.upper + margin);
  plot_->update();
}

double CurveStrip::laneHeight() const { return std::max(std::abs(baseRange().lower), std::abs(baseRange().upper)); }

double CurveStrip::heightOf(std::size_t trace, double value) const {
  return lanes_ ? laneCentre(trace) + 0.5 * value / laneHeight() : value;
}

void CurveStrip::drawLabels(const TimeWindow& window) {
  std::vector<PlotLabel> labels;
  for (const TimeMark& mark : marks_) {
    if (mark.name.isEmpty()) continue;
    labels.push_back({.at = mark.time_s - window.to_s(),
                      .height = -std::numeric_limits<double>::infinity(),
                      .text = mark.name,
                      .colour = colourOf(mark)});
  }
  for (std::size_t i = 0; i < cursor_values_.size(); ++i) {
    if (!std::isfinite(cursor_values_[i])) continue;
    const QString value = quantityText(cursor_values_[i], traces_[i].decimals, unit_);
    labels.push_back({.at = cursor_s_ - window.to_s(),
                      .height = heightOf(i, cursor_values_[i]),
                      .text = traces_[i].word.isEmpty() ? value : traces_[i].word + QLatin1Char(' ') + value,
                      .colour = colourOf(traces_[i])});
  }
  labels_->show(std::move(labels));
}

void CurveStrip::drawMarks(const TimeWindow& window) {
  while (mark_lines_.size() < marks_.size()) mark_lines_.push_back(new QCPItemStraightLine(plot_));
  for (std::size_t i = 0; i < mark_lines_.size(); ++i) {
    const bool shown = i < marks_.size() && marks_[i].time_s >= window.from_s() && marks_[i].time_s <= window.to_s();
    mark_lines_[i]->setVisible(shown);
    if (!shown) continue;
    const double x = marks_[i].time_s - window.to_s();
    mark_lines_[i]->point1->setCoords(x, 0.0);
    mark_lines_[i]->point2->setCoords(x, 1.0);
    mark_lines_[i]->setPen(QPen(colourOf(marks_[i]), 1));
  }
}

Range CurveStrip::shownRange() const { return fixed_range_ && !lanes_ ? *fixed_range_ : baseRange(); }

}  // namespace fyd::widgets
