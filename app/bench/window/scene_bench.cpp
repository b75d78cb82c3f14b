// The view of a scene: pictures a second of 1 k to 1 M triangles while it is turned and while only the haptic point
// moves, the processor load of its thread, and how late a thread of 1 kHz wakes beside it.
#include <QApplication>
#include <QEventLoop>
#include <QMouseEvent>
#include <QTimer>
#include <atomic>
#include <cmath>
#include <ctime>
#include <numbers>
#include <thread>

#include "app/bench/window/bench_parts.h"
#include "widgets/scene/scene_view.h"

namespace fyd::console::bench {
namespace {

constexpr QSize kView(800, 600);
constexpr std::size_t kSizes[] = {1'000, 10'000, 100'000, 1'000'000};

scene::TriangleSoup bumpyPlane(std::size_t triangles) {
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 2.0)));
  scene::TriangleSoup out;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = 100.0 * i / n - 50.0, y = 100.0 * j / n - 50.0, w = std::numbers::pi / 10.0;
      out.vertices.push_back({x, y, 2.0 * std::sin(w * x) * std::sin(w * y)});
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      out.triangles.push_back({a, b, d});
      out.triangles.push_back({a, d, c});
    }
  }
  return out;
}

/// The times at which a view painted something new.
class Painted : public QObject {
 public:
  explicit Painted(widgets::SceneView& view) : view_(view) { view.installEventFilter(this); }
  bool turning = false;
  std::vector<double> between_ms;
  std::vector<double> blocks;
  std::vector<double> processor_ms;  ///< of the thread that casts

  bool eventFilter(QObject*, QEvent* event) override {
    const widgets::ScenePicture* picture = view_.picture();
    if (event->type() != QEvent::Paint || picture == nullptr) return false;
    if (turning && picture->shot.camera == last_) return false;  // the same camera painted again
    last_ = picture->shot.camera;
    const double now = now_ms();
    if (last_ms_ > 0.0) between_ms.push_back(now - last_ms_);
    last_ms_ = now;
    blocks.push_back(picture->fineness.block);
    processor_ms.push_back(picture->took_ms);
    return false;
  }
  void forget() {
    between_ms.clear();
    blocks.clear();
    processor_ms.clear();
    last_ms_ = 0.0;
  }

 private:
  widgets::SceneView& view_;
  widgets::SceneCamera last_;
  double last_ms_ = 0.0;
};

void pass(double ms) {
  QEventLoop loop;
  QTimer::singleShot(static_cast<int>(ms), Qt::PreciseTimer, &loop, &QEventLoop::quit);
  loop.exec();
}

void settle(const widgets::SceneView& view) {
  const double until = now_ms() + 60'000.0;
  while (!view.settled() && now_ms() < until) pass(10.0);
}

double processCpu_ms() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

/// A thread that wakes a thousand times a second, of ordinary priority.
class HapticLoop {
 public:
  HapticLoop() : thread_([this] { run(); }) {}
  std::vector<double> stop() {
    end_ = true;
    thread_.join();
    return late_ms_;
  }

 private:
  void run() {
    timespec next{};
    clock_gettime(CLOCK_MONOTONIC, &next);
    while (!end_) {
      next.tv_nsec += 1'000'000;
      if (next.tv_nsec >= 1'000'000'000) {
        next.tv_nsec -= 1'000'000'000;
        ++next.tv_sec;
      }
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
      timespec now{};
      clock_gettime(CLOCK_MONOTONIC, &now);
      late_ms_.push_back(1e3 * static_cast<double>(now.tv_sec - next.tv_sec) +
                         1e-6 * static_cast<double>(now.tv_nsec - next.tv_nsec));
    }
  }
  std::atomic<bool> end_ = false;
  std::vector<double> late_ms_;
  std::thread thread_;
};

std::string rateWord(double seconds, const Painted& painted) {
  double block = 0.0;
  for (const double each : painted.blocks) block += each;
  block /= std::max<double>(1.0, static_cast<double>(painted.blocks.size()));
  return std::to_string(std::lround(static_cast<double>(painted.between_ms.size()) / seconds)) + " pictures/s, " +
         (block < 1.05 ? "a ray for each pixel"
                       : "a ray for " + QString::number(block, 'f', 1).toStdString() + " × as many pixels each way");
}

std::vector<Row> rowsOf(std::size_t triangles, double seconds) {
  const scene::TriangleSoup soup = bumpyPlane(triangles);
  const widgets::SceneBody body{.name = {}, .vertices_mm = soup.vertices, .triangles = soup.triangles};
  widgets::SceneView view;
  view.resize(kView);
  view.show();
  view.setBodies({&body, 1});
  widgets::SceneState state{.point_mm = {0, 0, -1}, .proxy_mm = {0, 0, 0}, .force_N = {0, 0, 1}};
  view.setState(state);
  settle(view);
  Painted painted(view);
  std::vector<Row> rows;
  const std::string name = "scene of " + std::to_string(soup.triangles.size()) + " triangles, ";
  const auto measure = [&](const std::string& what, const std::function<void()>& step) {
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, &view, step);
    timer.start(8);  // ms between two mouse events
    pass(500.0);
    painted.forget();
    const double cpu_ms = processCpu_ms(), wall_ms = now_ms(), own_ms = threadCpu_ms();
    pass(1e3 * seconds);
    const double took_ms = now_ms() - wall_ms;
    Row row{.what = name + what, .scale = scaleWord(), .unit = "ms between pictures", .aim = "p50 ≤ 16.7"};
    row.error = rateWord(1e-3 * took_ms, painted);
    rows.push_back(summarise(row, painted.between_ms));
    if (painted.turning) {
      Row cost{.what = name + what + ": casting, processor time alone", .scale = scaleWord(), .aim = "", .error = ""};
      rows.push_back(summarise(cost, painted.processor_ms));
    }
    const double own = (threadCpu_ms() - own_ms) / took_ms, all = (processCpu_ms() - cpu_ms) / took_ms;
    const double none = std::nan("");
    rows.push_back({.what = name + what + ": share of a core, all threads",
                    .scale = scaleWord(),
                    .p50 = 100.0 * all,
                    .p95 = none,
                    .worst = none,
                    .unit = "%",
                    .aim = "",
                    .error = "the window's thread " + std::to_string(std::lround(100.0 * own)) + " %"});
  };
  double phase = 0.0;
  measure("only the haptic point moves", [&] {
    phase += 0.05;
    state.point_mm.x = state.proxy_mm.x = 20.0 * std::sin(phase);
    view.setState(state);
  });
  painted.turning = true;
  QPointF at(400, 300);
  const auto send = [&](QEvent::Type type, Qt::MouseButton button) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  send(QEvent::MouseButtonPress, Qt::LeftButton);
  measure("turned", [&] {
    at.rx() += 2.0;
    send(QEvent::MouseMove, Qt::NoButton);
  });
  if (triangles == kSizes[std::size(kSizes) - 1]) {
    for (const bool beside : {false, true}) {
      HapticLoop loop;
      QTimer timer;
      timer.setTimerType(Qt::PreciseTimer);
      if (beside) {
        QObject::connect(&timer, &QTimer::timeout, &view, [&] {
          at.rx() += 2.0;
          send(QEvent::MouseMove, Qt::NoButton);
        });
        timer.start(8);
      }
      pass(1e3 * seconds);
      Row row{.what = std::string("a thread of 1 kHz, ordinary priority: wakes late, ") +
                      (beside ? "beside that scene turned" : "nothing drawn"),
              .scale = scaleWord(),
              .unit = "ms",
              .aim = "",
              .error = ""};
      rows.push_back(summarise(row, loop.stop()));
    }
  }
  return rows;
}

}  // namespace

std::vector<Row> sceneRows(const Settings& settings) {
  std::vector<Row> out;
  for (const std::size_t triangles : kSizes) {
    const std::vector<Row> rows = rowsOf(triangles, settings.seconds);
    out.insert(out.end(), rows.begin(), rows.end());
  }
  return out;
}

}  // namespace fyd::console::bench
