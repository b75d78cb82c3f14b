// Long work of a page: on its own thread, with a progress bar that can cancel it.
#pragma once

#include <QPointer>

#include "app/console/shell/background.h"
#include "core/recording/progress.h"
#include "widgets/basics/progress_bar.h"

namespace fyd::console {

class LongWork : public QObject {
  Q_OBJECT
 public:
  /// Runs on its own thread; must own its data, report progress often, and end when cancelled.
  using Work = std::function<Background::Finish(const recording::Progress&)>;

  explicit LongWork(widgets::ProgressBars* bars, QObject* parent = nullptr);
  ~LongWork() override;

  /// @param words what it does, for its bar; work under way is dropped
  void run(const QString& words, Work work);
  /// Cancels work under way and drops its result.
  void drop() { work_.cancel(); }
  [[nodiscard]] bool running() const { return work_.running(); }
  /// For the work's finish after an error: whether the operator cancelled it.
  [[nodiscard]] bool cancelled() const { return cancelled_; }

 private:
  QPointer<widgets::ProgressBar> bar_;
  bool cancelled_ = false;
  int number_ = 0;  // of the newest work
  Background work_;
};

}  // namespace fyd::console
