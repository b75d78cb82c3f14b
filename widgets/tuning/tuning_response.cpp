#include "widgets/tuning/tuning_response.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr double kBand_percent = 5.0;  // within which the loop counts as settled
constexpr double kLeastSpan_s = 1.0;
constexpr int kMostTicks = 5;
constexpr int kTick_px = 50;  // width of a number with margin

QString marginText(double factor) {
  return quantityText(factor, 2, QStringLiteral("×"));  // "—" for infinite: no gain, no loop
}

}  // namespace

TuningResponse::TuningResponse(QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), ground_(new QLabel(this)), busy_(new QProgressBar(this)) {
  setAccessibleName(tr("Step response"));
  auto* title = new QLabel(tr("Step response"), this);
  title->setFont(textFont(TextSize::normal, true));
  plot_->setMinimumSize(160, 120);
  plot_->setFocusPolicy(Qt::ClickFocus);
  plot_->setAccessibleName(tr("Step response"));
  plot_->xAxis->setLabel(tr("time (s)"));
  plot_->yAxis->setLabel(tr("% of target"));
  upper_ = plot_->addGraph();
  lower_ = plot_->addGraph();
  target_ = plot_->addGraph();
  for (QCPGraph*& graph : graphs_) graph = plot_->addGraph();
  plot_->yAxis->ticker()->setTickCount(kMostTicks);
  connect(plot_, &QCustomPlot::beforeReplot, this,
          [this] { plot_->xAxis->ticker()->setTickCount(std::clamp(plot_->width() / kTick_px, 2, kMostTicks)); });
  busy_->setRange(0, 0);
  busy_->setTextVisible(false);
  busy_->setFixedHeight(kGrid / 2);
  busy_->setAccessibleName(tr("Step response is being computed"));
  QSizePolicy keeps_its_place = busy_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);
  busy_->setSizePolicy(keeps_its_place);
  busy_->hide();
  ground_->setWordWrap(true);
  ground_->setProperty("role", "muted");
  ground_->setFont(textFont(TextSize::small));
  auto* figures = new QGridLayout;
  figures->setHorizontalSpacing(kGrid);
  figures->setVerticalSpacing(0);
  buildFigures(figures);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(title);
  auto* beside = new QHBoxLayout;
  beside->setSpacing(kGrid);
  beside->addWidget(plot_, 1);
  auto* column = new QVBoxLayout;
  column->addLayout(figures);
  column->addStretch(1);
  beside->addLayout(column);
  layout->addLayout(beside, 1);
  layout->addWidget(busy_);
  layout->addWidget(ground_);
  connect(&Look::instance(), &Look::changed, this, &TuningResponse::dress);
  dress();
  for (const Which which : {current, saved, proposed}) display(which);
}

void TuningResponse::buildFigures(QGridLayout* grid) {
  const std::array<QString, kCount> names = {tr("B: current"), tr("A: saved"), tr("proposed")};
  const std::array<QString, kCount> lines = {tr("solid"), tr("dashed"), tr("dotted")};
  const std::array<QString, kFigures> labels = {tr("Rise time"),    tr("Settling time"), tr("Overshoot"),
                                                tr("Steady error"), tr("Gain margin"),   tr("Phase margin"),
                                                tr("Verdict")};
  grid->setColumnStretch(0, 1);
  for (std::size_t line = 0; line < kFigures; ++line) {
    auto* label = new QLabel(labels[line], this);
    label->setFont(textFont(TextSize::small));
    label->setProperty("role", "muted");
    grid->addWidget(label, static_cast<int>(line) + 1, 0);
  }
  for (int column = 0; column < kCount; ++column) {
    const auto at = static_cast<std::size_t>(column);
    heads_[at] = new QLabel(names[at] + QLatin1Char('\n') + lines[at], this);
    heads_[at]->setAlignment(Qt::AlignRight);
    heads_[at]->setFont(textFont(TextSize::small, true));
    grid->addWidget(heads_[at], 0, column + 1, Qt::AlignRight);
    for (std::size_t line = 0; line < kFigures; ++line) {
      auto* cell = new QLabel(this);
      cell->setFont(textFont(TextSize::small));
      cell->setAccessibleDescription(tr("%1, %2").arg(labels[line], names[at]));
      grid->addWidget(cell, static_cast<int>(line) + 1, column + 1, Qt::AlignRight);
      cells_[at][line] = cell;
    }
  }
}

void TuningResponse::dress() {
  const Theme& t = theme();
  plot_->setBackground(QBrush(t.panel));
  styleAxes({plot_->xAxis, plot_->yAxis});
  target_->setPen(QPen(t.stiffness, 1, Qt::DashLine));
  for (QCPGraph* band : {upper_, lower_}) band->setPen(QPen(t.muted, 1, Qt::DotLine));
  graphs_[current]->setPen(QPen(t.stiffness, 2));
  graphs_[saved]->setPen(QPen(t.text, 1, Qt::DashLine));
  graphs_[proposed]->setPen(QPen(t.accent, 2, Qt::DotLine));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TuningResponse::setResponse(Which which, const ResponseView& view) {
  views_[which] = view;
  display(which);
}

void TuningResponse::clearResponse(Which which) { setResponse(which, {}); }

void TuningResponse::setPlotBackground(const QString& words) { ground_->setText(words); }

void TuningResponse::setBusy(bool busy) { busy_->setVisible(busy); }

void TuningResponse::takeFocus() { plot_->setFocus(Qt::OtherFocusReason); }

void TuningResponse::displayVerdict(Which which) {
  using control::LoopVerdict;
  const LoopVerdict verdict = views_[which].verdict;
  QLabel* cell = cells_[which][kFigures - 1];
  cell->setText(!has(which)                        ? kNoValue
                : verdict == LoopVerdict::unstable ? tr("unstable")
                : verdict == LoopVerdict::rings    ? tr("rings, then settles")
                : verdict == LoopVerdict::settles  ? tr("settles")
                                                   : tr("does not settle"));
  cell->setProperty("role", has(which) && verdict == LoopVerdict::unstable ? "warning" : "");
  restyle(*cell);
}

void TuningResponse::display(Which which) {
  const ResponseView& view = views_[which];
  const bool any = has(which);
  const auto seconds = [&](double value) { return any ? quantityText(value, 2, tr("s")) : kNoValue; };
  const auto percent = [&](double value) { return any ? quantityText(value, 1, QStringLiteral("%")) : kNoValue; };
  const std::array<QString, kFigures - 1> words = {
      seconds(view.rise_s),
      seconds(view.settling_s),
      percent(view.overshoot_percent),
      percent(view.steady_error_percent),
      any ? marginText(view.gain_margin) : kNoValue,
      any ? quantityText(view.phase_margin_deg, 0, QStringLiteral("°")) : kNoValue};
  for (std::size_t line = 0; line < words.size(); ++line) cells_[which][line]->setText(words[line]);
  displayVerdict(which);
  if (which == proposed) {
    heads_[proposed]->setVisible(any);
    for (QLabel* cell : cells_[proposed]) cell->setVisible(any);
  }

  QVector<QCPGraphData> course;
  for (const QPointF& point : view.course) course.append(QCPGraphData(point.x(), point.y()));
  graphs_[which]->data()->set(course, true);
  // Long enough for the slowest response; the y range holds all of it that lies outside the band.
  double span_s = kLeastSpan_s;
  double low = 100.0 - 2 * kBand_percent, high = 100.0 + 2 * kBand_percent;
  for (const ResponseView& each : views_) {
    if (each.course.empty()) continue;
    const double end_s = each.course.back().x();
    span_s = std::max(span_s, std::isfinite(each.settling_s) ? std::min(2.0 * each.settling_s, end_s) : end_s);
    for (const QPointF& point : each.course) {
      if (!std::isfinite(point.y())) continue;
      low = std::min(low, point.y());
      high = std::max(high, std::min(point.y(), 400.0));
    }
  }
  const auto level = [&](QCPGraph* graph, double percent_of_target) {
    graph->setData({0.0, span_s}, {percent_of_target, percent_of_target}, true);
  };
  level(target_, 100.0);
  level(upper_, 100.0 + kBand_percent);
  level(lower_, 100.0 - kBand_percent);
  plot_->xAxis->setRange(0.0, span_s);
  plot_->yAxis->setRange(low - 2.0, high + 2.0);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace fyd::widgets
