#include "app/console/background.h"

namespace fyd::console {

Background::~Background() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void Background::run(Work work) {
  cancel();
  running_ = true;
  emit runningChanged(true);
  thread_ = std::jthread([this, work = std::move(work), number = number_](const std::stop_token& stop) {
    Finish done = work(stop);
    // The destructor waits for this thread, so that `this` lives; what is queued for it goes with it.
    QMetaObject::invokeMethod(
        this, [this, number, done = std::move(done)] { finish(number, done); }, Qt::QueuedConnection);
  });
}

void Background::cancel() {
  ++number_;
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  if (!running_) return;
  running_ = false;
  emit runningChanged(false);
}

void Background::finish(int number, const Finish& finish) {
  if (number != number_) return;
  running_ = false;
  emit runningChanged(false);
  if (finish) finish();
}

}  // namespace fyd::console
