// The link's panel beside the Operate place: how the link is doing, and which robot there is to be.
#pragma once

#include "app/console/side_dock.h"
#include "core/pipeline/safety.h"
#include "widgets/link_panel.h"
#include "widgets/robot_form.h"

namespace fyd::console {

class LinkDock : public SideDock {
  Q_OBJECT
 public:
  explicit LinkDock(QWidget* parent = nullptr);

  /// The robot may be changed only while the motors are off.
  void showState(pipeline::SafetyState state);
  /// The haptic loop says nothing: whether something can move is not known.
  void showSilence(bool silent);
  /// The session began anew; what it does is known with its first sample. @param open false: there is none now, and
  /// nothing can move
  void restart(bool open);

  [[nodiscard]] bool mayReconnect() const;
  [[nodiscard]] widgets::LinkPanel* panel() const { return panel_; }
  [[nodiscard]] widgets::RobotForm* form() const { return form_; }

 private:
  LinkDock(widgets::LinkPanel* panel, widgets::RobotForm* form, QWidget* parent);
  void refresh() { form_->setAllowed(mayReconnect()); }

  bool can_move_ = true;  // until the first sample says otherwise
  bool silent_ = false;
  bool closed_ = false;
  widgets::LinkPanel* panel_;
  widgets::RobotForm* form_;
};

}  // namespace fyd::console
