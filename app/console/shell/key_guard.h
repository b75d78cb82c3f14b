// Esc stops from everywhere: from a field, an open list, a menu, a dialog, in a drag. It is handled before any widget and
// then passed on, so that it also closes what it usually closes. The stop button stops in a drag, too. The space bar goes
// to the control that has the focus before it goes to the window's shortcut; one that is held down presses nothing anew.
// No dialog is the desktop's own, because its keys do not come here.
#pragma once

#include <QApplication>
#include <QPointer>
#include <QWidget>

class QKeyEvent;
class QMouseEvent;

namespace fyd::console {

/// The application in which a KeyGuard lives: it lets it hear before every event filter, of which a drag's takes all keys
/// and clicks.
class Application : public QApplication {
  Q_OBJECT
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  /// A key or a button of the mouse goes down.
  void pressed(QObject* receiver, QEvent* event);
};

class KeyGuard : public QObject {
  Q_OBJECT
 public:
  /// Watches the whole Application for as long as it lives.
  explicit KeyGuard(QObject* parent = nullptr);
  /// The button that stops, also where its press does not come to it.
  void setStopButton(const QWidget* button) { stop_button_ = button; }

 signals:
  void stopPressed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void hear(QObject* receiver, QEvent* event);
  [[nodiscard]] bool pressesStop(const QObject* receiver, const QMouseEvent& press) const;
  [[nodiscard]] bool isRepeat(const QKeyEvent& press) const;

  QPointer<const QWidget> stop_button_;
  quint64 space_released_ = 0;  ///< the system's time of it; 0: not yet, or not told
};

}  // namespace fyd::console
