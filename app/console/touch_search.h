// Looks for the touches of a recording's file on a thread of its own.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/console/background.h"
#include "core/session/touches.h"

namespace fyd::console {

class TouchSearch : public QObject {
  Q_OBJECT
 public:
  /// Told on the window's thread.
  using Found = std::function<void(const Result<std::vector<session::Touch>>&)>;
  using QObject::QObject;

  /// A search under way is dropped.
  void look(const QString& path, Found found);
  void drop() { work_.cancel(); }

 private:
  Background work_;
};

}  // namespace fyd::console
