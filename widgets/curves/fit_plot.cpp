#include "widgets/curves/fit_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "widgets/basics/theme.h"
#include "widgets/curves/axis_scale.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr QSize kLeastSize(160, 208);  // px, smallest readable size
constexpr double kPoint_px = 7.0;
constexpr double kOutlier_px = 11.0;

bool finite(const QPointF& point) { return std::isfinite(point.x()) && std::isfinite(point.y()); }

QVector<QCPGraphData> dataOf(const std::vector<QPointF>& points) {
  QVector<QCPGraphData> out;
  for (const QPointF& point : points) {
    if (finite(point)) out.append(QCPGraphData(point.x(), point.y()));
  }
  return out;
}

/// The range that holds all values, with room at both ends.
QCPRange rangeOf(const std::vector<double>& values, double least_span) {
  if (values.empty()) return {0.0, 1.0};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double room = std::max(0.08 * (*high - *low), 0.5 * least_span);
  return {*low - room, *high + room};
}

}  // namespace

FitPlot::FitPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)), empty_(new QLabel(this)) {
  setObjectName(QStringLiteral("fit_plot"));
  setAccessibleName(tr("Points, fit and residuals"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  layout->addWidget(empty_);
  empty_->setObjectName(QStringLiteral("fit_plot_empty"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setProperty("role", "muted");
  empty_->setFont(textFont(TextSize::title));
  for (QWidget* each : {static_cast<QWidget*>(empty_), static_cast<QWidget*>(plot_)}) each->setMinimumSize(kLeastSize);
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setInteractions({});
  plot_->plotLayout()->clear();
  above_ = new QCPAxisRect(plot_);
  below_ = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(0, 0, above_);
  plot_->plotLayout()->addElement(1, 0, below_);
  plot_->plotLayout()->setRowStretchFactor(0, 3);
  plot_->plotLayout()->setRowSpacing(0);
  for (QCPAxisRect* rect : {above_, below_}) {
    rect->setAutoMargins(QCP::msTop | QCP::msBottom | QCP::msRight);
    rect->setMargins(QMargins(kReadingLeft_px + kGrid, 4, 8, 4));  // a true minus is wide
    for (QCPAxis* axis : rect->axes()) {
      axis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(*axis)));
      axis->setNumberFormat(QStringLiteral("gb"));
      axis->setNumberPrecision(4);
      axis->ticker()->setTickCount(4);
    }
    rect->axis(QCPAxis::atBottom)->setLayer(QStringLiteral("axes"));
  }
  below_->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  former_ = addGraph(above_);
  curve_ = addGraph(above_);
  points_ = addGraph(above_);
  outliers_ = addGraph(above_);
  residuals_ = addGraph(below_);
  outlier_residuals_ = addGraph(below_);
  levels_ = addGraph(above_);
  intervals_ = new QCPErrorBars(above_->axis(QCPAxis::atBottom), above_->axis(QCPAxis::atLeft));
  intervals_->setDataPlottable(levels_);
  connect(&Look::instance(), &Look::changed, this, &FitPlot::dress);
  setFit({});
  dress();
}

QCPGraph* FitPlot::addGraph(QCPAxisRect* rect) {
  return plot_->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
}

void FitPlot::dress() {
  const Theme& t = theme();
  plot_->setBackground(QBrush(t.panel));
  for (QCPAxisRect* rect : {above_, below_}) {
    styleAxes(rect->axes());
    for (QCPAxis* axis : rect->axes()) axis->grid()->setZeroLinePen(QPen(t.muted, 1));
  }
  former_->setPen(QPen(t.muted, 1, Qt::DashLine));
  curve_->setPen(QPen(t.accent, 2));
  points_->setLineStyle(QCPGraph::lsNone);
  points_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, t.text, kPoint_px));
  outliers_->setLineStyle(QCPGraph::lsNone);
  outliers_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCross, QPen(t.warning, 2), Qt::NoBrush, kOutlier_px));
  residuals_->setLineStyle(QCPGraph::lsImpulse);
  residuals_->setPen(QPen(t.text, 1));
  residuals_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, t.text, kPoint_px));
  outlier_residuals_->setLineStyle(QCPGraph::lsNone);
  outlier_residuals_->setScatterStyle(outliers_->scatterStyle());
  levels_->setLineStyle(QCPGraph::lsNone);
  levels_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(t.accent, 1), t.panel, kPoint_px));
  intervals_->setPen(QPen(t.accent, 2));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void FitPlot::setFit(const FitView& view) {
  view_ = view;
  QVector<QCPGraphData> residuals, outliers, outlier_residuals;
  std::vector<double> xs, ys, rs;
  for (const std::vector<QPointF>* part : {&view_.points, &view_.curve, &view_.former_curve}) {
    for (const QPointF& point : *part) {
      if (!finite(point)) continue;
      xs.push_back(point.x());
      ys.push_back(point.y());
    }
  }
  QVector<QCPGraphData> levels;
  QVector<QCPErrorBarsData> intervals;
  for (const FitBar& bar : view_.bars) {
    if (!std::isfinite(bar.x) || !std::isfinite(bar.low) || !std::isfinite(bar.high)) continue;
    levels.append(QCPGraphData(bar.x, 0.5 * (bar.low + bar.high)));
    intervals.append(QCPErrorBarsData(0.5 * (bar.high - bar.low)));
    ys.insert(ys.end(), {bar.low, bar.high});
    xs.push_back(bar.x);
  }
  for (std::size_t i = 0; i < view_.points.size(); ++i) {
    const bool outlier = std::ranges::find(view_.outliers, i) != view_.outliers.end();
    const QPointF& point = view_.points[i];
    if (outlier && finite(point)) outliers.append(QCPGraphData(point.x(), point.y()));
    if (i >= view_.residuals.size() || !std::isfinite(view_.residuals[i]) || !finite(point)) continue;
    rs.push_back(view_.residuals[i]);
    residuals.append(QCPGraphData(point.x(), rs.back()));
    if (outlier) outlier_residuals.append(QCPGraphData(point.x(), rs.back()));
  }
  former_->data()->set(dataOf(view_.former_curve), false);
  curve_->data()->set(dataOf(view_.curve), false);
  points_->data()->set(dataOf(view_.points), false);
  outliers_->data()->set(outliers, false);
  residuals_->data()->set(residuals, false);
  outlier_residuals_->data()->set(outlier_residuals, false);
  levels_->data()->set(levels, true);
  intervals_->data()->clear();
  for (const QCPErrorBarsData& interval : intervals) intervals_->addData(interval.errorMinus);
  // Axes from 0 to 1 without a point could be mistaken for a measurement.
  empty_->setText(view_.empty_text);
  empty_->setVisible(xs.empty());
  plot_->setVisible(!xs.empty());
  below_->setVisible(!rs.empty());
  plot_->plotLayout()->setRowStretchFactor(1, rs.empty() ? 0.01 : 1.0);
  QCPAxis* x = above_->axis(QCPAxis::atBottom);
  x->setLabel(view_.x_title);
  x->setRange(rangeOf(xs, 1e-6));
  above_->axis(QCPAxis::atLeft)->setLabel(view_.y_title);
  above_->axis(QCPAxis::atLeft)->setRange(rangeOf(ys, 1e-6));
  below_->axis(QCPAxis::atBottom)->setRange(x->range());
  below_->axis(QCPAxis::atLeft)->setLabel(view_.residual_title);
  rs.push_back(0.0);
  below_->axis(QCPAxis::atLeft)->setRange(rangeOf(rs, 1e-9));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace fyd::widgets
