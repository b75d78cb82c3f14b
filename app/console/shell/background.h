// Long work (finding touches, figures, replays, exports) on its own thread; its result is delivered on the window's.
#pragma once

#include <QObject>
#include <exception>
#include <functional>
#include <map>
#include <stop_token>
#include <thread>

#include "core/base/error.h"

namespace fyd::console {

/// What was thrown, as an error in the library's words; it is logged.
[[nodiscard]] tl::unexpected<Error> thrown(const std::exception& problem);

/// A result as `compute` returns it; what it throws (out of memory, or of a library) is its error. For work whose finish
/// tells errors.
template <class Compute>
[[nodiscard]] auto guarded(Compute&& compute) -> decltype(compute()) {
  try {
    return compute();
  } catch (const std::exception& problem) {
    return thrown(problem);
  }
}

class Background : public QObject {
  Q_OBJECT
 public:
  /// Runs on the window's thread when the work is done.
  using Finish = std::function<void()>;
  /// Runs on its own thread; must own its data, and end soon once asked to stop. What it throws is logged and told by
  /// `failed`; it has no result then (see also `guarded`).
  using Work = std::function<Finish(const std::stop_token&)>;

  using QObject::QObject;
  ~Background() override;  ///< waits for work under way

  /// Starts `work`; work under way is cancelled.
  void run(Work work);
  /// Asks work under way to stop; its result is still delivered.
  void stop();
  /// Waits for work under way, and delivers its result.
  void wait();
  /// Asks work under way to stop and drops its result; never waits.
  void cancel();
  [[nodiscard]] bool running() const { return running_; }

 signals:
  void runningChanged(bool running);
  void failed(const QString& why);  ///< the work threw; in the library's words

 private:
  void finish(int number, const Finish& finish);

  std::map<int, std::jthread> threads_;  // by number; those cancelled stay until they have ended
  bool running_ = false;
  int number_ = 0;  // of the newest work
};

}  // namespace fyd::console
