#include "app/console/shell/background.h"

#include <spdlog/spdlog.h>

#include <exception>

#include <QCoreApplication>

#include "widgets/basics/core_text.h"

namespace fyd::console {

tl::unexpected<Error> thrown(const std::exception& problem) {
  spdlog::error("Work in the background was given up: {}", problem.what());
  return fail(verbatim(problem.what()));
}

Background::~Background() {
  for (auto& [number, thread] : threads_) thread.request_stop();
  threads_.clear();
}

void Background::run(Work work) {
  cancel();
  running_ = true;
  emit runningChanged(true);
  const int number = ++number_;
  threads_[number] = std::jthread([this, work = std::move(work), number](const std::stop_token& stop) {
    Finish done;
    try {
      done = work(stop);
    } catch (const std::exception& problem) {  // out of memory, or of a library: the session goes on
      done = [this, why = widgets::coreText(thrown(problem).value().message)] { emit failed(why); };
    }
    // The destructor waits for this thread, so `this` is valid; calls queued for it are dropped with it.
    QMetaObject::invokeMethod(
        this, [this, number, done = std::move(done)] { finish(number, done); }, Qt::QueuedConnection);
  });
}

void Background::stop() {
  if (running_) threads_[number_].request_stop();
}

void Background::wait() {
  if (!running_) return;
  threads_.at(number_).join();
  QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);  // the result, which it posted last
}

void Background::cancel() {
  if (!running_) return;
  stop();
  running_ = false;
  emit runningChanged(false);
}

void Background::finish(int number, const Finish& finish) {
  threads_.erase(number);  // its work is done
  if (number != number_ || !running_) return;
  running_ = false;
  emit runningChanged(false);
  if (finish) finish();
}

}  // namespace fyd::console
