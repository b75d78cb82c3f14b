#include "app/console/shell/long_work.h"

namespace fyd::console {

LongWork::LongWork(widgets::ProgressBars* bars, QObject* parent) : QObject(parent), bar_(bars->add()) {
  connect(bar_, &widgets::ProgressBar::cancelAsked, this, [this] {
    cancelled_ = true;
    work_.stop();
  });
  connect(&work_, &Background::runningChanged, this, [this](bool running) {
    if (!running && bar_) bar_->end();
  });
}

LongWork::~LongWork() {
  drop();  // ends the bar
  delete bar_;
}

void LongWork::run(const QString& words, Work work) {
  drop();
  cancelled_ = false;
  if (bar_) bar_->begin(words);
  work_.run([this, number = ++number_, work = std::move(work)](const std::stop_token& stop) {
    int told_percent = 0;
    return work([&](double share) {
      // At most one update per percent, to save work of the window's thread.
      if (const int percent = static_cast<int>(100.0 * share); percent > told_percent) {
        told_percent = percent;
        const auto show = [this, number, share] {
          if (number == number_ && bar_) bar_->setDone(share);
        };
        QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
      }
      return !stop.stop_requested();
    });
  });
}

}  // namespace fyd::console
