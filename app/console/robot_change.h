// Another robot while the window stays open: from the link's panel to the session, and back when it fails. A scene is
// read on a thread of its own while the present session goes on; what is wrong with it costs nothing.
#pragma once

#include <QObject>

#include "app/console/background.h"
#include "app/console/link_dock.h"
#include "app/console/page.h"

namespace fyd::console {

class RobotChange : public QObject {
  Q_OBJECT
 public:
  RobotChange(const PageContext& context, LinkDock& dock, QObject* parent = nullptr);
  /// The present robot in the form, and where the target comes from with it.
  void showRobot();

 signals:
  void beginning();  ///< the present session ends now

 private:
  void reconnect(const RobotWords& wanted);
  void readScene(const RobotWords& wanted);
  void openScene(const RobotWords& wanted);
  [[nodiscard]] bool mayBegin();
  void done(const RobotWords& wanted, const Result<void>& outcome);

  PageContext context_;
  LinkDock& dock_;
  Background reading_;
  Background opening_;
};

}  // namespace fyd::console
