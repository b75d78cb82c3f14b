// Ten million samples: pan and zoom from all of them down to a few, and whether a spike of one sample is on the screen.
#include <QApplication>
#include <cmath>
#include <random>

#include <qcustomplot.h>

#include "app/bench/window/bench_parts.h"
#include "app/bench/window/spike.h"
#include "widgets/curves/curve_buffer.h"
#include "widgets/curves/curve_strip.h"

namespace fyd::console::bench {
namespace {

constexpr std::size_t kSamples = 10'000'000;
constexpr float kSpike = 10.0F;
constexpr double kSpans_s[] = {0.05, 0.5, 5.0, 50.0, 500.0, 5000.0, 10000.0};

struct View {
  double from_s;
  double to_s;
  double spike_s;
  [[nodiscard]] double share() const { return (spike_s - from_s) / (to_s - from_s); }
};

float valueOf(std::size_t index, const std::vector<std::size_t>& spikes) {
  if (std::ranges::binary_search(spikes, index)) return kSpike;
  const double t_s = 1e-3 * static_cast<double>(index);
  return static_cast<float>(std::sin(0.7 * t_s) + 0.3 * std::sin(900.0 * t_s));
}

/// Each shows one spike somewhere.
std::vector<View> viewsOf(double span_s, int count, const std::vector<std::size_t>& spikes, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.001, 0.999);
  std::vector<View> out;
  for (int i = 0; i < count; ++i) {
    const double at_s = 1e-3 * static_cast<double>(spikes[random() % spikes.size()]);
    const double from_s = span_s >= 1e-3 * kSamples ? 0.0 : at_s - share(random) * span_s;
    out.push_back({from_s, from_s + span_s, at_s});
  }
  return out;
}

struct Result {
  std::vector<double> took_ms;
  int lost = 0;
};

std::string errorWord(const Result& result) {
  return std::to_string(result.lost) + " of " + std::to_string(result.took_ms.size()) + " spikes lost";
}

Result ours(const widgets::CurveBuffer& buffer, const std::vector<View>& views, widgets::CurveStrip& strip) {
  Result out;
  for (const View& view : views) {
    widgets::TimeWindow window(2e-3 * kSamples);
    window.show(view.from_s, view.to_s);
    const double begun_ms = now_ms();
    strip.draw(buffer, window);
    strip.plot()->repaint();  // draw leaves only this to be done later
    out.took_ms.push_back(now_ms() - begun_ms);
    if (!spikeSeen(*strip.plot(), view.share(), kSpike, widgets::theme().of(widgets::Quantity::force))) ++out.lost;
    QApplication::processEvents();
  }
  return out;
}

Result naive(QCustomPlot& plot, const std::vector<View>& views) {
  Result out;
  for (const View& view : views) {
    const double begun_ms = now_ms();
    plot.xAxis->setRange(view.from_s, view.to_s);
    plot.yAxis->setRange(-2.0, 11.0);
    plot.replot(QCustomPlot::rpImmediateRefresh);
    out.took_ms.push_back(now_ms() - begun_ms);
    if (!spikeSeen(plot, view.share(), kSpike, plot.graph()->pen().color())) ++out.lost;
    QApplication::processEvents();
  }
  return out;
}

std::string spanWord(double span_s) { return QString::number(span_s, 'g', 5).toStdString() + " s shown"; }

}  // namespace

std::vector<Row> zoomRows(const Settings& settings) {
  const int views = settings.seconds < 5.0 ? 5 : 40;
  const int naive_views = settings.seconds < 5.0 ? 2 : 8;
  std::mt19937 random(3);
  std::vector<std::size_t> spikes;
  spikes.reserve(100);
  for (int i = 0; i < 100; ++i) spikes.push_back(random() % kSamples);
  std::ranges::sort(spikes);
  widgets::CurveBuffer buffer(1, kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const float value[] = {valueOf(i, spikes)};
    (void)buffer.append(1e-3 * static_cast<double>(i), value);
  }
  widgets::CurveStrip strip(QStringLiteral("Force"), QStringLiteral("N"), {-2, 2},
                            {{.channel = 0, .quantity = widgets::Quantity::force}}, true);
  strip.resize(1000, 300);
  strip.show();
  QApplication::processEvents();

  std::vector<Row> rows;
  Result all;
  std::vector<std::vector<View>> shown;
  shown.reserve(std::size(kSpans_s));
  for (const double span_s : kSpans_s) {
    shown.push_back(viewsOf(span_s, views, spikes, random));
    const Result found = ours(buffer, shown.back(), strip);
    Row row{.what = "curve of 10 M samples: pan, " + spanWord(span_s),
            .scale = scaleWord(),
            .aim = "p95 ≤ 16",
            .error = errorWord(found),
            .compared = "pan, " + spanWord(span_s)};
    rows.push_back(summarise(row, found.took_ms));
    all.took_ms.insert(all.took_ms.end(), found.took_ms.begin(), found.took_ms.end());
    all.lost += found.lost;
  }
  // Zooming goes from one length to the next: the same draw, in another order.
  std::vector<View> zoom;
  for (int i = 0; i < views; ++i) {
    for (const auto& each : shown) zoom.push_back(each[static_cast<std::size_t>(i)]);
  }
  const Result zoomed = ours(buffer, zoom, strip);
  Row row{.what = "curve of 10 M samples: zoom through all of these",
          .scale = scaleWord(),
          .aim = "p95 ≤ 16",
          .error = errorWord(zoomed)};
  rows.push_back(summarise(row, zoomed.took_ms));

  QCustomPlot plot;
  plot.resize(1000, 300);
  plot.addGraph();
  QVector<QCPGraphData> points;
  points.reserve(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    points.append(QCPGraphData(1e-3 * static_cast<double>(i), valueOf(i, spikes)));
  }
  plot.graph()->data()->set(points, true);
  points = {};
  plot.show();
  QApplication::processEvents();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    shown[i].resize(static_cast<std::size_t>(naive_views));
    const Result found = naive(plot, shown[i]);
    Row baseline{.what = "baseline: the same in QCustomPlot alone, " + spanWord(kSpans_s[i]),
                 .scale = scaleWord(),
                 .aim = "",
                 .error = errorWord(found),
                 .compared = "pan, " + spanWord(kSpans_s[i])};
    rows.push_back(summarise(baseline, found.took_ms));
  }
  return rows;
}

}  // namespace fyd::console::bench
