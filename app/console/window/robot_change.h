// Changes the robot while the window stays open: from the link panel to the session, and back when it fails. A scene is
// read on its own thread while the present session continues, so errors in it do not interrupt the session.
#pragma once

#include <QObject>

#include "app/console/shell/background.h"
#include "app/console/shell/page.h"
#include "app/console/window/link_dock.h"

namespace fyd::console {

class RobotChange : public QObject {
  Q_OBJECT
 public:
  RobotChange(const PageContext& context, LinkDock& dock, QObject* parent = nullptr);
  /// Shows the present robot in the form, and the source of the target with it.
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
