// Another robot while the window stays open: from the link's panel to the session, and back when it fails.
#pragma once

#include <QObject>

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
  PageContext context_;
  LinkDock& dock_;
};

}  // namespace fyd::console
