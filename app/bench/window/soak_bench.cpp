// Hours of samples through the live curves, a second at a time with one redraw for each: memory growth, and the time
// until the newest sample is drawn.
#include <unistd.h>
#include <QApplication>
#include <QFile>

#include "app/bench/window/bench_parts.h"
#include "app/bench/window/bench_session.h"
#include "app/bench/window/spike.h"
#include "widgets/curves/curve_view.h"

namespace fyd::console::bench {
namespace {

double residentMB() {
  QFile file(QStringLiteral("/proc/self/statm"));
  if (!file.open(QIODevice::ReadOnly)) return std::numeric_limits<double>::quiet_NaN();
  const double pages = file.readAll().split(' ').value(1).toDouble();
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace

std::vector<Row> soakRows(const Settings& settings) {
  constexpr int kRate = 1000;
  constexpr int kFilled_s = 300;  // the ring is full by then: all memory is allocated
  constexpr int kPublishPeriod_s = 60;
  widgets::CurveView view;
  view.resize(1000, 900);
  for (const char* id : {"texture_signal", "stretch"}) {
    view.stack()->setShown(view.stack()->indexOf(QLatin1String(id)), true);
  }
  view.chooseSpan(kPublishPeriod_s);
  view.show();
  QApplication::processEvents();
  const int seconds = kFilled_s + static_cast<int>(3600.0 * settings.hours);
  std::vector<pipeline::TelemetrySample> chunk(kRate);
  std::vector<double> lag_ms;
  double filled_MB = 0.0;
  SpikeCount spikes;
  for (int second = 0; second < seconds; ++second) {
    for (int i = 0; i < kRate; ++i) {
      const std::int64_t index = static_cast<std::int64_t>(second) * kRate + i;
      chunk[static_cast<std::size_t>(i)] = busySample(index, instantAt(1.0 + 1e-3 * static_cast<double>(index)));
    }
    const double begun_ms = now_ms();
    view.append(chunk);
    view.redraw();
    QApplication::processEvents();  // the queued redraws
    QApplication::processEvents();  // the paint events that they cause
    if (second == kFilled_s) filled_MB = residentMB();
    if (second <= kFilled_s) continue;
    lag_ms.push_back(now_ms() - begun_ms);
    if (second % kPublishPeriod_s != 0) continue;  // so that each spike is checked once
    const SpikeCount found = countSpikes(view, kBusySpike_N);
    spikes.shown += found.shown;
    spikes.lost += found.lost;
  }
  const double grown_MB = residentMB() - filled_MB;
  const std::string hours = QString::number(settings.hours, 'g', 3).toStdString() + " h";
  Row lag{.what = "soak, " + hours + " of samples: a sample's wait for its picture",
          .scale = scaleWord(),
          .aim = "≤ 100",
          .error = std::to_string(spikes.lost) + " of " + std::to_string(spikes.shown) + " spikes lost"};
  return {summarise(lag, lag_ms),
          {.what = "soak, " + hours + " of samples: memory gained since the first five minutes",
           .scale = scaleWord(),
           .p50 = grown_MB,
           .p95 = grown_MB,
           .worst = grown_MB,
           .unit = "MB of " + QString::number(filled_MB, 'f', 0).toStdString(),
           .aim = "flat"}};
}

}  // namespace fyd::console::bench
