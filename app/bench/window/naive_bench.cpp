// The baseline: twelve curves of a minute drawn by QCustomPlot with its default settings and without decimation.
#include <QApplication>
#include <QVBoxLayout>
#include <cmath>

#include <qcustomplot.h>

#include "app/bench/window/bench_parts.h"
#include "app/bench/window/bench_session.h"

namespace fyd::console::bench {

std::vector<Row> naiveFrameRows(const Settings& settings) {
  constexpr int kGraphsOf[] = {1, 1, 3, 1, 3, 1, 2};  // as the window's strips
  constexpr int kSamples = 60'000;
  constexpr int kNew = 33;  // samples of a frame
  QWidget window;
  window.resize(1000, 900);  // the size of the curves in a window of 1600 × 1000
  auto* layout = new QVBoxLayout(&window);
  std::vector<QCustomPlot*> plots;
  for (const int graphs : kGraphsOf) {
    auto* plot = new QCustomPlot(&window);
    for (int i = 0; i < graphs; ++i) plot->addGraph();
    layout->addWidget(plot);
    plots.push_back(plot);
  }
  window.show();
  QApplication::processEvents();
  int next = 0;
  const auto add = [&](int count) {
    for (int i = 0; i < count; ++i, ++next) {
      const double t_s = 1e-3 * next;
      int phase = 0;
      for (QCustomPlot* plot : plots) {
        for (int g = 0; g < plot->graphCount(); ++g) {
          plot->graph(g)->addData(t_s, std::sin(3.0 * t_s + ++phase) + 0.3 * std::sin(800.0 * t_s));
        }
      }
    }
  };
  add(kSamples);
  std::vector<double> took_ms;
  const double end_ms = now_ms() + 1e3 * settings.seconds;
  while (now_ms() < end_ms || took_ms.size() < 5) {
    const double begun_ms = now_ms();
    add(kNew);
    const double to_s = 1e-3 * next;
    for (QCustomPlot* plot : plots) {
      for (int g = 0; g < plot->graphCount(); ++g) plot->graph(g)->data()->removeBefore(to_s - 60.0);
      plot->xAxis->setRange(to_s - 60.0, to_s);
      plot->yAxis->setRange(-1.5, 1.5);
      plot->replot(QCustomPlot::rpImmediateRefresh);
    }
    took_ms.push_back(now_ms() - begun_ms);
    QApplication::processEvents();
  }
  Row row{.what = "baseline: frame, 12 curves × 60 s × 1 kHz in QCustomPlot alone, no window, no camera",
          .scale = scaleWord(),
          .compared = "frame"};
  return {summarise(row, took_ms)};
}

}  // namespace fyd::console::bench
