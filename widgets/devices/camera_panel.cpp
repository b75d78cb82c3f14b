#include "widgets/devices/camera_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/core_text.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

CameraPanel::CameraPanel(QWidget* parent)
    : QFrame(parent),
      image_(new CameraImage(this)),
      mask_(new QToolButton(this)),
      reason_(new QLabel(this)),
      hint_(new QLabel(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Camera"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(image_);

  mask_->setText(tr("Mask"));
  mask_->setObjectName(QStringLiteral("mask_button"));
  mask_->setIcon(icon(QStringLiteral("mask")));
  mask_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  mask_->setCheckable(true);
  mask_->setChecked(true);
  mask_->setToolTip(tr("Tint what the detector takes for the finger (M)"));
  connect(mask_, &QToolButton::toggled, image_, &CameraImage::showMask);
  auto* bar = new QHBoxLayout;
  reason_->setFont(textFont(TextSize::small));
  reason_->setProperty("role", "muted");
  bar->addWidget(reason_, 1);
  bar->addWidget(mask_);
  layout->addLayout(bar);

  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(0);
  const QString names[3] = {tr("x"), tr("y"), tr("area")};
  const QString long_names[3] = {tr("Finger x in millimetres"), tr("Finger y in millimetres"),
                                 tr("Finger area in square millimetres")};
  for (int i = 0; i < 3; ++i) {
    auto* name = new QLabel(names[i], this);
    name->setProperty("role", "muted");
    name->setFont(textFont(TextSize::small));
    values_[i] = new QLabel(kNoValue, this);
    values_[i]->setFont(textFont(TextSize::normal, true));
    values_[i]->setAlignment(Qt::AlignRight);
    values_[i]->setAccessibleName(long_names[i]);
    grid->addWidget(name, 0, i);
    grid->addWidget(values_[i], 1, i);
    grid->setColumnStretch(i, 1);
    name->setAlignment(Qt::AlignRight);
  }
  layout->addLayout(grid);
  hint_->setFont(textFont(TextSize::small));
  hint_->setProperty("role", "muted");
  hint_->setWordWrap(true);
  hint_->hide();
  layout->addWidget(hint_);
  connect(image_, &CameraImage::depthChanged, this, &CameraPanel::sayHint);
}

void CameraPanel::setPicture(const CameraPicture& picture) {
  hint_->setVisible(image_->touchable());
  image_->setPicture(picture);
  const sensing::FingerDetection& finger = picture.finger;
  const double none = std::numeric_limits<double>::quiet_NaN();
  values_[0]->setText(quantityText(finger.contact ? finger.x_mm : none, 1, tr("mm")));
  values_[1]->setText(quantityText(finger.contact ? finger.y_mm : none, 1, tr("mm")));
  values_[2]->setText(quantityText(finger.area_mm2, 1, QStringLiteral("mm²")));
  QString text = coreText(toString(finger.reason));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  reason_->setText(finger.reason == sensing::FingerReason::found ? tr("Finger found") : text);
}

void CameraPanel::showMissing(const QString& text) {
  image_->setPicture({});
  image_->setEmptyText(text);
  for (QLabel* value : values_) value->setText(kNoValue);
  reason_->setText(tr("No picture"));
  hint_->hide();
}

void CameraPanel::setTouchable(PictureToTouchpad to_touchpad) {
  image_->setTouchable(std::move(to_touchpad));
  hint_->setVisible(image_->touchable());
  sayHint();
}

void CameraPanel::sayHint() {
  hint_->setText(tr("Simulated: press on the picture, %1 deep; the wheel changes it.")
                     .arg(quantityText(image_->depth_mm(), 2, tr("mm"))));
  hint_->setToolTip(tr("Shift and drag changes the depth, too"));
}

}  // namespace fyd::widgets
