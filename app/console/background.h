// Long work (finding touches, figures, replays, exports) on a thread of its own; its result comes back to the window's.
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <stop_token>
#include <thread>

namespace fyd::console {

class Background : public QObject {
  Q_OBJECT
 public:
  /// Runs on the window's thread when the work is done.
  using Finish = std::function<void()>;
  /// Runs on a thread of its own; must hold what it needs, and end soon once asked to stop.
  using Work = std::function<Finish(const std::stop_token&)>;

  using QObject::QObject;
  ~Background() override;  ///< waits for work under way

  /// Starts `work`; work under way is cancelled.
  void run(Work work);
  /// Asks work under way to stop; what it came to is still told.
  void stop();
  /// Asks work under way to stop and drops its result; never waits.
  void cancel();
  [[nodiscard]] bool running() const { return running_; }

 signals:
  void runningChanged(bool running);

 private:
  void finish(int number, const Finish& finish);

  std::map<int, std::jthread> threads_;  // by number; those cancelled stay until they have ended
  bool running_ = false;
  int number_ = 0;  // of the newest work
};

}  // namespace fyd::console
