// Esc stops from everywhere: from a field, an open list, a menu, a dialog. It is handled before any widget and then
// passed on, so that it also closes what it usually closes. The space bar goes to the control that has the focus before
// it goes to the window's shortcut; one that is held down presses nothing anew. No dialog is the desktop's own, because
// its keys do not come here.
#pragma once

#include <QObject>

class QKeyEvent;

namespace fyd::console {

class KeyGuard : public QObject {
  Q_OBJECT
 public:
  /// Watches the whole application for as long as it lives.
  explicit KeyGuard(QObject* parent = nullptr);

 signals:
  void stopPressed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] bool isRepeat(const QKeyEvent& press) const;

  quint64 space_released_ = 0;  ///< the system's time of it; 0: not yet, or not told
};

}  // namespace fyd::console
