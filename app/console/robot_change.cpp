#include "app/console/robot_change.h"

#include "widgets/core_text.h"

namespace fyd::console {

using widgets::Severity;

RobotChange::RobotChange(const PageContext& context, LinkDock& dock, QObject* parent)
    : QObject(parent), context_(context), dock_(dock) {
  connect(dock_.form(), &widgets::RobotForm::reconnectAsked, this,
          [this](const QString& robot, const QString& key_file) {
            reconnect({.robot = robot.toStdString(), .key_file = key_file.toStdString()});
          });
}

void RobotChange::showRobot() {
  const RobotWords now = context_.session.robot();
  dock_.form()->setRobot(QString::fromStdString(now.robot), QString::fromStdString(now.key_file));
  context_.tuning.startWithTarget(now.robot == "none");  // as a station starts then
}

void RobotChange::reconnect(const RobotWords& wanted) {
  context_.feed.pump();  // what the ending session still has to say, its state above all
  if (!dock_.mayReconnect()) return;
  emit beginning();
  Session& session = context_.session;
  const auto done = session.reconnect(wanted);
  dock_.restart(session.isOpen());
  context_.feed.restart();
  context_.tuning.restart();
  if (done) {
    showRobot();
    context_.tell(Severity::information, tr("Robot is now: %1.").arg(QString::fromStdString(wanted.robot)));
    return;
  }
  // The former robot's station is a new one as well, and starts with the robot's target.
  if (session.isOpen() && context_.tuning.targetIsByHand()) context_.tuning.targetByHand();
  const QString why = widgets::coreText(done.error().message);
  context_.tell(Severity::error, session.isOpen() ? tr("Robot not changed. %1.").arg(why)
                                                  : tr("The session is closed. %1. Choose another robot.").arg(why));
}

}  // namespace fyd::console
