#include "widgets/curves/live_trace.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "widgets/basics/theme.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr double kMark_px = 9.0;
constexpr double kLevel_px = 12.0;
constexpr double kRoom = 0.1;  // of the values' span, above and below

/// "Distance 1 · 2 · 3": the word that all begin with stands once, because an axis is short.
QString namesOf(QStringList names) {
  const QString first = names.value(0).section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ');
  const bool alike = std::ranges::all_of(names, [&](const QString& name) { return name.startsWith(first); });
  for (qsizetype i = 1; alike && i < names.size(); ++i) names[i].remove(0, first.size());
  return names.join(QStringLiteral(" · "));
}

}  // namespace

LiveTrace::LiveTrace(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName(QStringLiteral("live_trace"));
  setAccessibleName(tr("Live reading over the last 30 s, with the points taken"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setMinimumSize(160, 80);
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setInteractions({});
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setPlottingHints(QCP::phFastPolylines);
  plot_->axisRect()->setAutoMargins(QCP::msTop | QCP::msBottom);
  plot_->axisRect()->setMargins(QMargins(kReadingLeft_px, 4, 8, 4));
  plot_->xAxis->setTickLabels(false);
  plot_->yAxis->ticker()->setTickCount(3);
  plot_->yAxis->setNumberFormat(QStringLiteral("gb"));
  plot_->xAxis->setRange(-kPublishPeriod_s, 0.0);
  for (std::size_t i = 0; i < kMostSignals; ++i) traces_.push_back(plot_->addGraph());
  marks_ = plot_->addGraph();
  levels_ = plot_->addGraph();
  connect(&Look::instance(), &Look::changed, this, &LiveTrace::dress);
  dress();
}

void LiveTrace::dress() {
  const Theme& t = theme();
  plot_->setBackground(QBrush(t.panel));
  styleAxes({plot_->xAxis, plot_->yAxis});
  // The first signal is the one calibrated; the others differ by their dashes, not by colour alone.
  constexpr std::array kDashes = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  for (std::size_t i = 0; i < traces_.size(); ++i) traces_[i]->setPen(QPen(i == 0 ? t.text : t.muted, 1, kDashes[i]));
  marks_->setLineStyle(QCPGraph::lsNone);
  marks_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(t.accent, 2), QBrush(t.panel), kMark_px));
  levels_->setLineStyle(QCPGraph::lsNone);
  QPainterPath dash;
  dash.moveTo(-kLevel_px, 0.0);
  dash.lineTo(0.0, 0.0);
  levels_->setScatterStyle(QCPScatterStyle(dash, QPen(t.accent, 2)));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LiveTrace::restart(const QStringList& signals_shown, const QString& unit) {
  for (QCPGraph* trace : traces_) trace->data()->clear();
  marks_->data()->clear();
  level_readings_.clear();
  plot_->yAxis->setLabel(unit.isEmpty() ? QString() : namesOf(signals_shown) + QStringLiteral(", ") + unit);
  plot_->xAxis->setLabel(tr("the last %1 s").arg(kPublishPeriod_s));
  draw();
}

void LiveTrace::add(double time_s, const std::vector<double>& values) {
  now_s_ = time_s;
  for (std::size_t i = 0; i < std::min(values.size(), traces_.size()); ++i) {
    traces_[i]->addData(time_s, values[i]);
    traces_[i]->data()->removeBefore(time_s - kPublishPeriod_s);
  }
  marks_->data()->removeBefore(time_s - kPublishPeriod_s);
  if (!values.empty()) newest_ = values.front();
  draw();
}

void LiveTrace::mark() {
  if (std::isfinite(newest_) && shown() > 0) marks_->addData(now_s_, newest_);
  draw();
}

void LiveTrace::setLevels(const std::vector<double>& readings) {
  level_readings_ = readings;
  draw();
}

int LiveTrace::shown() const { return traces_.front()->dataCount(); }
int LiveTrace::marked() const { return marks_->dataCount(); }

void LiveTrace::draw() {
  levels_->data()->clear();
  for (const double reading : level_readings_) {
    if (std::isfinite(reading)) levels_->addData(now_s_, reading);
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto hold = [&](const QCPGraph* graph) {
    for (const QCPGraphData& each : *graph->data()) {
      if (!std::isfinite(each.value)) continue;
      low = std::min(low, each.value);
      high = std::max(high, each.value);
    }
  };
  for (const QCPGraph* trace : traces_) hold(trace);
  hold(levels_);
  if (low <= high) {
    // Noise of the last digits must not fill the height.
    const double room = std::max(kRoom * (high - low), 1e-3 * std::max(std::abs(low), std::abs(high)) + 1e-6);
    plot_->yAxis->setRange(low - room, high + room);
  }
  plot_->yAxis->setTickLabels(low <= high);
  plot_->xAxis->setRange(now_s_ - kPublishPeriod_s, now_s_);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace fyd::widgets
