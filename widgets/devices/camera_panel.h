// The camera's picture, the finger's figures below it, and hints on using the mouse in it.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QLayout>
#include <QToolButton>

#include "widgets/devices/camera_image.h"

namespace fyd::widgets {

class CameraPanel : public QFrame {
  Q_OBJECT
 public:
  explicit CameraPanel(QWidget* parent = nullptr);
  void setPicture(const CameraPicture& picture);
  /// No new pictures arrive: the figures are blanked. @param text what was looked for, what to do
  void showMissing(const QString& text);
  void setTouchable(PictureToTouchpad to_touchpad);
  /// Below the words about the simulated finger.
  void addBelow(QWidget* widget) { layout()->addWidget(widget); }
  [[nodiscard]] CameraImage* image() const { return image_; }
  [[nodiscard]] QToolButton* maskButton() const { return mask_; }
  [[nodiscard]] QString figure(int row) const { return values_[row]->text(); }

 private:
  void sayHint();
  CameraImage* image_ = nullptr;
  QToolButton* mask_ = nullptr;
  QLabel* values_[3] = {};
  QLabel* reason_ = nullptr;
  QLabel* hint_ = nullptr;
};

}  // namespace fyd::widgets
