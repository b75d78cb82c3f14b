#include "widgets/curves/curve_strip.h"

#include <QRubberBand>
#include <QVBoxLayout>

#include "widgets/basics/number_ticker.h"
#include "widgets/curves/curve_line.h"
#include "widgets/curves/curve_plot.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

QPen penOf(const Trace& trace) {
  QColor colour = trace.quantity == Quantity::none ? theme().text : theme().of(trace.quantity);
  if (trace.stroke == Stroke::faint) colour.setAlphaF(0.45F);
  const Qt::PenStyle style = trace.stroke == Stroke::dashed   ? Qt::DashLine
                             : trace.stroke == Stroke::dotted ? Qt::DotLine
                                                              : Qt::SolidLine;
  return {colour, 1, style};
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
      with_time_scale_(with_time_scale),
      band_(new QRubberBand(QRubberBand::Rectangle, plot_)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setAccessibleName(tr("%1 over time, %2").arg(name, unit));
  plot_->setAccessibleName(accessibleName());
  plot_->setMinimumHeight(40);
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
  setTimeScale(with_time_scale_);
  plot_->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(tr("s"))));
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker));
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
  mark_words_->position->setType(QCPItemPosition::ptAxisRectRatio);
  mark_words_->position->setCoords(1.0, 0.0);
  mark_words_->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
  mark_words_->setPadding(QMargins(4, 0, 4, 0));
  mark_words_->setVisible(false);
  connect(&Look::instance(), &Look::changed, this, &CurveStrip::dress);
  dress();
}

QCustomPlot* CurveStrip::plot() const { return plot_; }

void CurveStrip::setTimeScale(bool shown) {
  with_time_scale_ = shown;
  plot_->axisRect()->setMargins(QMargins(kCurveLeft_px, 4, kCurveRight_px, shown ? kTimeScale_px : 4));
  plot_->xAxis->setTickLabels(shown);
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
  const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
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
  mark_words_->setFont(textFont(TextSize::small));
  mark_words_->setColor(t.text);
  mark_words_->setBrush(QBrush(t.panel));
  for (QCPItemStraightLine* line : limit_lines_) line->setPen(QPen(t.danger, 1, Qt::DashDotLine));
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    plot_->graph(static_cast<int>(i))->setPen(penOf(traces_[i]));
  }
}

void CurveStrip::fill(QCPGraph* graph, const Trace& trace, const CurveSource& source, const TimeWindow& window) {
  // A column for each pixel of the screen, of which a scaled display has more than the layout.
  const auto width =
      std::max<std::size_t>(1, static_cast<std::size_t>(plot_->axisRect()->width() * plot_->devicePixelRatioF()));
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
    const double full = std::max(std::abs(baseRange().lower), std::abs(baseRange().upper));
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      for (QCPGraphData& point : *plot_->graph(static_cast<int>(i))->data()) {
        point.value = laneCentre(i) + 0.5 * point.value / full;
      }
    }
    scale_text_->setText(tr("each ±%1 %2").arg(full).arg(unit_));
    if (!fixed_range_) shown = {-0.5, static_cast<double>(traces_.size()) - 0.5};
  }
  const double margin =
      fixed_range_ || chosen_range_ ? 0.0 : 0.04 * (shown.upper - shown.lower);  // the line at the end stays visible
  if (time_itself_) static_cast<NumberTicker*>(plot_->xAxis->ticker().data())->setShown(window.to_s());
  drawMarks(window);
  plot_->xAxis->setRange(-window.span_s(), 0.0);
  plot_->yAxis->setRange(shown.lower - margin, shown.upper + margin);
  plot_->update();
}

void CurveStrip::drawMarks(const TimeWindow& window) {
  while (mark_lines_.size() < marks_.size()) {
    mark_lines_.push_back(new QCPItemStraightLine(plot_));
    auto* name = new QCPItemText(plot_);
    name->position->setTypeX(QCPItemPosition::ptPlotCoords);
    name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    name->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);  // the name is drawn at the top
    name->setPadding(QMargins(3, 0, 3, 0));
    name->setFont(textFont(TextSize::small));
    mark_names_.push_back(name);
  }
  for (std::size_t i = 0; i < mark_lines_.size(); ++i) {
    const bool shown = i < marks_.size() && marks_[i].time_s >= window.from_s() && marks_[i].time_s <= window.to_s();
    mark_lines_[i]->setVisible(shown);
    mark_names_[i]->setVisible(shown && !marks_[i].name.isEmpty());
    if (!shown) continue;
    const double x = marks_[i].time_s - window.to_s();
    const QColor colour = marks_[i].strong ? theme().text : theme().muted;
    mark_lines_[i]->point1->setCoords(x, 0.0);
    mark_lines_[i]->point2->setCoords(x, 1.0);
    mark_lines_[i]->setPen(QPen(colour, 1));
    mark_names_[i]->position->setCoords(x, 1.0);
    mark_names_[i]->setText(marks_[i].name);
    mark_names_[i]->setColor(colour);
    mark_names_[i]->setBrush(QBrush(theme().panel));
  }
}

Range CurveStrip::shownRange() const { return fixed_range_ && !lanes_ ? *fixed_range_ : baseRange(); }

}  // namespace fyd::widgets
