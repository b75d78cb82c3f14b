// Finds the touches in a recording's file, on its own thread.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/console/shell/long_work.h"
#include "core/export/touches.h"

namespace fyd::console {

class TouchSearch : public QObject {
  Q_OBJECT
 public:
  /// Called on the window's thread.
  using Found = std::function<void(const Result<std::vector<exports::Touch>>&)>;
  explicit TouchSearch(widgets::ProgressBars* bars, QObject* parent = nullptr) : QObject(parent), work_(bars) {}

  /// A search under way is dropped.
  void look(const QString& path, Found found);
  void drop() { work_.drop(); }
  /// Whether a search without result was cancelled by the operator.
  [[nodiscard]] bool cancelled() const { return work_.cancelled(); }

 private:
  LongWork work_;
};

}  // namespace fyd::console
