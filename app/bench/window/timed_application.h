// An application that measures the work of its thread in each period of the camera, however often curves are drawn: all
// events that begin in it count.
#pragma once

#include <QApplication>
#include <QEvent>
#include <QThread>
#include <functional>
#include <vector>

#include "app/bench/window/bench_parts.h"

namespace fyd::console::bench {

class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
    if (depth_++ > 0) {
      const bool done = QApplication::notify(receiver, event);
      --depth_;
      return done;
    }
    const bool paints = event->type() == QEvent::UpdateRequest;
    const double wall = now_ms();
    const double cpu = threadCpu_ms();
    endPeriods(wall);
    const bool done = QApplication::notify(receiver, event);
    busy_wall_ms_ += now_ms() - wall;
    busy_cpu_ms_ += threadCpu_ms() - cpu;
    --depth_;
    // The strips are drawn by events queued after `drawn`; the painting after those shows them.
    if (paints && drawn_) {
      drawn_ = false;
      if (painted_) painted_();
    }
    return done;
  }

  void curvesDrawn() { drawn_ = true; }
  void onPainted(std::function<void()> run) { painted_ = std::move(run); }
  void forget() {
    wall_ms_.clear();
    cpu_ms_.clear();
  }
  [[nodiscard]] const std::vector<double>& wall_ms() const { return wall_ms_; }
  [[nodiscard]] const std::vector<double>& cpu_ms() const { return cpu_ms_; }

 private:
  static constexpr double kPeriod_ms = 1e3 / 30.0;  // of the camera

  /// Keeps what is complete once an event begins in a later period; one without an event has no work.
  void endPeriods(double now) {
    for (; now >= period_end_ms_; period_end_ms_ += kPeriod_ms) {
      wall_ms_.push_back(busy_wall_ms_);
      cpu_ms_.push_back(busy_cpu_ms_);
      busy_wall_ms_ = busy_cpu_ms_ = 0.0;
    }
  }

  int depth_ = 0;
  bool drawn_ = false;
  double period_end_ms_ = now_ms();
  double busy_wall_ms_ = 0.0;
  double busy_cpu_ms_ = 0.0;
  std::vector<double> wall_ms_;
  std::vector<double> cpu_ms_;
  std::function<void()> painted_;
};

}  // namespace fyd::console::bench
