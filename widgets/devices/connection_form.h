// Choice of the session's touchpad, motors and camera, and the way to the robot's. Nothing changes before "Connect" is
// pressed, and only while nothing can move.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPointer>
#include <QPushButton>

#include "widgets/devices/part_choice.h"

namespace fyd::widgets {

/// Words as the options --touchpad, --motors, --camera and --robot have them.
struct ChosenDevices {
  QString touchpad;
  QString motors;
  QString camera;
};

class ConnectionForm : public QFrame {
  Q_OBJECT
 public:
  explicit ConnectionForm(QWidget* parent = nullptr);

  void setDevices(const ChosenDevices& devices);
  [[nodiscard]] ChosenDevices devices() const;
  /// @param robot in words; it is changed in a panel of its own
  void setRobot(const QString& robot);
  /// What a search found.
  void offer(const QStringList& serial_ports, const QStringList& cameras);
  /// Why the devices may not be changed now, and what to do; empty: they may.
  void setHindrance(const QString& why);
  /// A non-empty text replaces the hint; the button then cancels the work, where that is possible.
  void setWork(const QString& words, bool can_be_cancelled);
  /// A touchpad of one's own is what is wanted: the form asks for its address.
  void askForOwn();

  /// Hint and buttons, to be placed where nothing moves them: the form above changes its height with what is chosen.
  [[nodiscard]] QWidget* foot() const { return foot_; }
  [[nodiscard]] PartChoice* touchpad() const { return touchpad_; }
  [[nodiscard]] PartChoice* motors() const { return motors_; }
  [[nodiscard]] PartChoice* camera() const { return camera_; }
  [[nodiscard]] QPushButton* connectButton() const { return connect_; }
  [[nodiscard]] QPushButton* robotButton() const { return robot_; }
  [[nodiscard]] QString hint() const { return hint_->text(); }

 signals:
  void connectAsked();
  void cancelAsked();
  void robotAsked();

 private:
  void refresh();
  void allowConnect(bool on);
  [[nodiscard]] QString missing() const;
  void touchpadChanged();

  QString hindrance_;
  QString work_;
  bool can_be_cancelled_ = false;
  PartChoice* touchpad_ = nullptr;
  PartChoice* motors_ = nullptr;
  PartChoice* camera_ = nullptr;
  QFrame* foot_ = nullptr;
  QPushButton* robot_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* connect_ = nullptr;
  QPointer<QWidget> fallen_to_;  ///< what got the focus when `connect_` was disabled
};

}  // namespace fyd::widgets
