// Looks for the touches of a recording's file on a thread of its own.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/console/long_work.h"
#include "core/session/touches.h"

namespace fyd::console {

class TouchSearch : public QObject {
  Q_OBJECT
 public:
  /// Told on the window's thread.
  using Found = std::function<void(const Result<std::vector<session::Touch>>&)>;
  explicit TouchSearch(widgets::WorkBars* bars, QObject* parent = nullptr) : QObject(parent), work_(bars) {}

  /// A search under way is dropped.
  void look(const QString& path, Found found);
  void drop() { work_.drop(); }
  /// When nothing was found: it was the operator who ended the search.
  [[nodiscard]] bool cancelled() const { return work_.cancelled(); }

 private:
  LongWork work_;
};

}  // namespace fyd::console
