// A control in a panel that scrolls, past which the wheel goes until the control has the focus.
#pragma once

#include <QEvent>
#include <QWidget>

namespace fyd::widgets {

/// The wheel scrolls the panel; it changes a value only where the operator has put the focus, by a click or a key: by
/// the wheel alone the focus does not come either.
inline void guardFromWheel(QWidget* control) {
  class Guard : public QObject {
   public:
    using QObject::QObject;

   protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
      if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
      event->ignore();
      return true;
    }
  };
  control->setFocusPolicy(Qt::StrongFocus);
  control->installEventFilter(new Guard(control));
}

}  // namespace fyd::widgets
