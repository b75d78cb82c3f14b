// A button that acts only after it was held for a while, by mouse or by key: so that motion starts
// only deliberately. Letting go early, leaving the button, losing the focus or Esc cancels it, also while the window was
// busy: time in which it heard nothing is not held. One press begins one hold, so coming back to the button with the
// mouse or key still down begins none. The progress is drawn in the button. What is to last only while the button is
// held ends with `letGo`.
#pragma once

#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>

namespace fyd::widgets {

class HoldButton : public QPushButton {
  Q_OBJECT
 public:
  static constexpr int kHold_ms = 600;
  /// At most so much of the hold passes from one look at it to the next.
  static constexpr int kLongestStep_ms = 50;

  explicit HoldButton(const QString& text, QWidget* parent = nullptr);
  /// 0 … 1
  [[nodiscard]] double progress() const;
  /// It has acted and is still held.
  [[nodiscard]] bool engaged() const { return engaged_; }
  /// As at a stop: ends the hold, and a press that has begun none begins none.
  void stop();

 signals:
  /// Once for each hold.
  void held();
  /// After `held`: released, left, hidden, disabled, stopped, or the focus is elsewhere.
  void letGo();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void begin();
  void cancel();
  void tick();

  QElapsedTimer since_tick_;
  qint64 held_ms_ = 0;
  QTimer timer_;
  bool holding_ = false;
  bool engaged_ = false;
  bool fresh_ = false;  ///< a press that has begun no hold yet
};

}  // namespace fyd::widgets
