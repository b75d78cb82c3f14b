// The camera's picture with what the detector made of it: region of interest, finger mask, centroid.
// Without a picture it says what was looked for. In simulation, a press on the picture moves the simulated finger.
#pragma once

#include <functional>

#include <QImage>
#include <QRect>
#include <QString>
#include <QWidget>

#include "core/sensing/finger_types.h"

namespace fyd::widgets {

struct CameraPicture {
  QImage picture;  ///< null before the first
  QImage mask;     ///< Grayscale8, the region's size: 255 the finger, 128 other dark places, 0 cloth; may be null
  QRect region;    ///< of interest, px of the picture
  sensing::FingerDetection finger;
};

/// Converts a place in the picture, px, to touchpad coordinates, mm; for the mouse.
using PictureToTouchpad = std::function<QPointF(QPointF)>;

class CameraImage : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kDepthStep_mm = 0.25;
  static constexpr double kMaximumDepth_mm = 12.0;

  explicit CameraImage(QWidget* parent = nullptr);

  void setPicture(const CameraPicture& picture);
  [[nodiscard]] const QImage& picture() const { return shown_.picture; }
  void showMask(bool on);
  /// The text of a session that has sent no picture until now.
  [[nodiscard]] static QString noneYet() { return tr("No picture yet."); }
  /// Text shown in place of a picture: what was looked for, what to do.
  void setEmptyText(const QString& text);
  [[nodiscard]] const QString& emptyText() const { return empty_text_; }
  /// Lets the mouse move the simulated finger; an empty function ends it.
  void setTouchable(PictureToTouchpad to_touchpad);
  [[nodiscard]] bool touchable() const { return static_cast<bool>(to_touchpad_); }
  [[nodiscard]] double depth_mm() const { return depth_mm_; }
  [[nodiscard]] QSize sizeHint() const override { return {280, 210}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

 signals:
  void fingerMoved(double x_mm, double y_mm, double indentation_mm);
  void fingerReleased();
  void depthChanged(double indentation_mm);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QRectF target() const;
  void touch();
  void release();
  void changeDepth(double by_mm);
  void paintFinger(QPainter& painter, const QRectF& area) const;
  void refreshTint();

  CameraPicture shown_;
  QImage tint_;  ///< the mask, coloured and translucent
  bool mask_on_ = true;
  QString empty_text_;
  PictureToTouchpad to_touchpad_;
  double depth_mm_ = 4.0;
  bool touching_ = false;
  QPointF mouse_;  ///< where the finger presses, px of the widget
  QPointF hand_;   ///< where the mouse is; differs after the depth was changed
};

}  // namespace fyd::widgets
