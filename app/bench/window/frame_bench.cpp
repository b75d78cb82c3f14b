// The window at full load, in real time.
#include <QApplication>
#include <QInputDevice>
#include <QKeyEvent>
#include <QTemporaryDir>
#include <QTimer>
#include <random>
#include <thread>

#include "app/bench/window/bench_parts.h"
#include "app/bench/window/bench_session.h"
#include "app/bench/window/spike.h"
#include "app/bench/window/timed_application.h"
#include "app/console/window/main_window.h"

namespace fyd::console::bench {
namespace {

constexpr double kAfter_s = 1.0;   // for the last key press to be handled
constexpr double kWarmUp_s = 3.0;  // the minute of samples that comes at once, and first-time initialisation

/// Force, indentation, stiffness with target and reach, duty, three accelerations, texture signal, reference and
/// measured stretch: twelve.
void showTwelve(widgets::CurveStack& stack) {
  for (const char* id : {"texture_signal", "stretch"}) stack.setShown(stack.indexOf(QLatin1String(id)), true);
}

/// Presses the key from a thread of its own, as the system would, at moments unrelated to the frames.
std::vector<double> pressStop(QObject* window, double seconds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> pause_s(0.05, 0.15);
  std::vector<double> pressed_ms;
  const double end_ms = now_ms() + 1e3 * seconds;
  while (now_ms() < end_ms) {
    std::this_thread::sleep_for(std::chrono::duration<double>(pause_s(random)));
    pressed_ms.push_back(now_ms());
    QCoreApplication::postEvent(window, new QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier));
  }
  return pressed_ms;
}

}  // namespace

std::vector<Row> frameRows(const Settings& settings) {
  auto made = std::make_unique<BusySession>();
  BusySession* session = made.get();
  QTemporaryDir folder;
  MainWindow window(std::move(made), folder.filePath(QStringLiteral("profile.toml")));
  window.resize(1600, 1000);
  window.show();
  window.start();
  widgets::CurveView* curves = window.operate()->curves();
  curves->chooseSpan(60.0);
  showTwelve(*curves->stack());

  auto* application = static_cast<TimedApplication*>(qApp);
  std::vector<double> age_ms;
  double newest_ms = 0.0;
  QObject::connect(curves, &widgets::CurveView::drawn, curves, [&] {
    newest_ms = session->newest_ms();
    application->curvesDrawn();
  });
  application->onPainted([&] { age_ms.push_back(now_ms() - newest_ms); });

  double cpu_ms = 0.0;
  double wall_ms = 0.0;
  std::vector<double> pressed_ms;
  std::jthread presser;
  (void)QInputDevice::primaryKeyboard();  // created on first use, which must be on this thread
  QTimer::singleShot(static_cast<int>(1e3 * kWarmUp_s), &window, [&] {
    application->forget();
    age_ms.clear();
    session->stopped_ms.clear();
    cpu_ms = threadCpu_ms();
    wall_ms = now_ms();
    presser = std::jthread([&] { pressed_ms = pressStop(&window, settings.seconds); });
    QTimer::singleShot(static_cast<int>(1e3 * (settings.seconds + kAfter_s)), &window, [&] {
      cpu_ms = threadCpu_ms() - cpu_ms;
      wall_ms = now_ms() - wall_ms;
      QApplication::exit();
    });
  });
  QApplication::exec();
  presser.join();

  std::vector<double> stop_ms;
  stop_ms.reserve(std::min(pressed_ms.size(), session->stopped_ms.size()));
  for (std::size_t i = 0; i < std::min(pressed_ms.size(), session->stopped_ms.size()); ++i) {
    stop_ms.push_back(session->stopped_ms[i] - pressed_ms[i]);
  }
  const double share = 100.0 * cpu_ms / wall_ms;
  const bool full = scaleWord() == "100 %";
  const SpikeCount spikes = countSpikes(*curves, kBusySpike_N);
  const std::string lost = std::to_string(spikes.lost) + " of " + std::to_string(spikes.shown) + " spikes lost";
  Row frame{.what = "window: frame, 12 curves × 60 s × 1 kHz, camera 30 fps",
            .scale = scaleWord(),
            .aim = full ? "p95 ≤ 16" : "p95 ≤ 33",
            .error = lost,
            .compared = "frame"};
  Row cpu{.what = "window: the same, processor time alone", .scale = scaleWord(), .aim = "", .error = lost};
  Row use{.what = "window: share of a core by its thread",
          .scale = scaleWord(),
          .p50 = share,
          .p95 = share,
          .worst = share,
          .unit = "%",
          .aim = "≤ 50"};
  Row stop{.what = "window: stop key to command", .scale = scaleWord(), .aim = "≤ one frame + 5"};
  Row age{.what = "window: age of the newest sample when painted", .scale = scaleWord(), .aim = "≤ 100"};
  stop.error = pressed_ms.size() == session->stopped_ms.size()
                   ? "0 of " + std::to_string(pressed_ms.size()) + " lost"
                   : std::to_string(session->stopped_ms.size()) + " of " + std::to_string(pressed_ms.size()) + " came";
  return {summarise(frame, application->wall_ms()), summarise(cpu, application->cpu_ms()), use,
          summarise(stop, stop_ms), summarise(age, age_ms)};
}

}  // namespace fyd::console::bench
