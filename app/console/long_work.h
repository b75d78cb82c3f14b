// Long work of a page: on a thread of its own, with a bar that says what runs and how far it is, and cancels it.
#pragma once

#include <QPointer>

#include "app/console/background.h"
#include "core/session/progress.h"
#include "widgets/work_bar.h"

namespace fyd::console {

class LongWork : public QObject {
  Q_OBJECT
 public:
  /// Runs on a thread of its own; must hold what it needs, tell how far it is often, and end when told so.
  using Work = std::function<Background::Finish(const session::Progress&)>;

  explicit LongWork(widgets::WorkBars* bars, QObject* parent = nullptr);
  ~LongWork() override;

  /// @param words what it does, for its bar; work under way is dropped
  void run(const QString& words, Work work);
  /// Work under way ends soon, and its result is not told.
  void drop() { work_.cancel(); }
  [[nodiscard]] bool running() const { return work_.running(); }
  /// For the work's finish, when it came to an error: it was the operator who ended it.
  [[nodiscard]] bool cancelled() const { return cancelled_; }

 private:
  QPointer<widgets::WorkBar> bar_;
  bool cancelled_ = false;
  int number_ = 0;  // of the newest work
  Background work_;
};

}  // namespace fyd::console
