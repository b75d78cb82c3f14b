// A device test that runs as long as the operator holds a button. Nobody can press a simulated cloth by hand: its own
// finger does, to three depths one after the other.
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "app/console/shell/session.h"
#include "widgets/basics/hold_button.h"

namespace fyd::console {

class HeldMotion : public QObject {
  Q_OBJECT
 public:
  HeldMotion(Session& session, widgets::HoldButton* button, QObject* parent);
  /// @return an error when it may not run now
  [[nodiscard]] Result<void> start(device::DeviceTest test, double stretch_deg);
  /// Switches the motors off; nothing when they are off.
  void end();
  [[nodiscard]] bool active() const { return timer_.isActive(); }
  /// As it was when it was last read.
  [[nodiscard]] const station::DeviceTestStatus& status() const { return status_; }
  void readStatus() { status_ = session_.deviceTestStatus(); }

 signals:
  void ended();

 private:
  void keep();

  Session& session_;
  widgets::HoldButton* button_ = nullptr;
  QTimer timer_;
  station::DeviceTestStatus status_;
  bool pressing_ = false;  // the simulated finger presses while the button is held
  QElapsedTimer pressing_since_;
};

}  // namespace fyd::console
