#include "app/console/window/robot_change.h"

#include "widgets/basics/core_text.h"

namespace fyd::console {

using widgets::Severity;

RobotChange::RobotChange(const PageContext& context, LinkDock& dock, QObject* parent)
    : QObject(parent), context_(context), dock_(dock) {
  connect(dock_.form(), &widgets::RobotForm::reconnectAsked, this,
          [this](const QString& robot, const QString& key_file) {
            reconnect({.robot = robot.toStdString(), .key_file = key_file.toStdString()});
          });
  connect(dock_.form(), &widgets::RobotForm::cancelAsked, this, [this] {
    reading_.cancel();
    dock_.showWork({}, false);
  });
}

void RobotChange::showRobot() {
  const RobotWords now = context_.session.robot();
  dock_.form()->setRobot(QString::fromStdString(now.robot), QString::fromStdString(now.key_file));
  context_.tuning.startWithTarget(now.robot == "none");  // as the station starts then
}

bool RobotChange::mayBegin() {
  context_.feed.pump();  // takes the last data of the ending session, above all its state
  if (!dock_.mayReconnect()) return false;
  emit beginning();
  return true;
}

void RobotChange::reconnect(const RobotWords& wanted) {
  if (wanted.robot.starts_with("scene:")) return readScene(wanted);
  if (mayBegin()) done(wanted, context_.session.reconnect(wanted));
}

void RobotChange::readScene(const RobotWords& wanted) {
  dock_.showWork(tr("Reading the scene. The present session goes on until it is read."), true);
  reading_.run([this, wanted](const std::stop_token&) -> Background::Finish {
    return [this, wanted, read = context_.session.checkRobot(wanted)] {
      dock_.showWork({}, false);
      if (!read) {
        context_.tell(Severity::error, tr("Robot not changed. %1.").arg(widgets::coreText(read.error().message)));
      } else if (mayBegin()) {
        openScene(wanted);
      } else {
        context_.tell(Severity::warning, tr("Robot not changed: something can move again. Press Esc, then Reconnect."));
      }
    };
  });
}

void RobotChange::openScene(const RobotWords& wanted) {
  dock_.showWork(tr("The scene takes the robot's place."), false);
  opening_.run([this, wanted, work = context_.session.leaveFor(wanted)](const std::stop_token&) -> Background::Finish {
    return [this, wanted, arrive = work()] {
      dock_.showWork({}, false);
      done(wanted, arrive());
    };
  });
}

void RobotChange::done(const RobotWords& wanted, const Result<void>& outcome) {
  Session& session = context_.session;
  dock_.restart(session.isOpen());
  context_.feed.restart();
  context_.tuning.restart();
  if (outcome) {
    showRobot();
    context_.tell(Severity::information, tr("Robot is now: %1.").arg(QString::fromStdString(wanted.robot)));
    return;
  }
  // The former robot's station is a new one as well, and starts with the robot's target.
  if (session.isOpen() && context_.tuning.targetIsByHand()) context_.tuning.targetByHand();
  const QString why = widgets::coreText(outcome.error().message);
  context_.tell(Severity::error, session.isOpen() ? tr("Robot not changed. %1.").arg(why)
                                                  : tr("The session is closed. %1. Choose another robot.").arg(why));
}

}  // namespace fyd::console
