#include "app/console/review/review_camera.h"

#include <QVBoxLayout>

#include "app/console/shell/views.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

bool beforeTheFirst(const recording::Recording& recording, double time_s) {
  const auto first = recording.picture(0);
  return first && time_s < first->time_s;
}

}  // namespace

using widgets::numberText;

ReviewCamera::ReviewCamera(QWidget* parent)
    : QWidget(parent), camera_(new widgets::CameraImage(this)), words_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(widgets::kGrid);
  camera_->setEmptyText(tr("No picture at the cursor."));
  words_->setWordWrap(true);
  layout->addWidget(camera_);
  layout->addWidget(words_);
}

void ReviewCamera::showAt(const recording::Recording* recording, double time_s) {
  if (recording == nullptr || recording->info().frames == 0) {
    camera_->setPicture({});
    words_->setText(tr("No pictures were recorded."));
    return;
  }
  const auto picture = recording->pictureAt(time_s);
  if (!picture) {
    shown_ = 0;
    camera_->setPicture({});
    words_->setText(beforeTheFirst(*recording, time_s) ? tr("No picture was taken before the cursor.")
                                                       : widgets::coreText(picture.error().message));
    return;
  }
  if (picture->number == shown_) return;
  shown_ = picture->number;
  const cv::Rect& r = picture->region_px;
  camera_->setPicture({.picture = toImage(picture->whole),
                       .mask = {},
                       .region = QRect(r.x, r.y, r.width, r.height),
                       .finger = picture->finger});
  const sensing::FingerDetection& finger = picture->finger;
  words_->setText(finger.contact
                      ? tr("x %1 mm   y %2 mm   area %3 mm²")
                            .arg(numberText(finger.x_mm, 1), numberText(finger.y_mm, 1), numberText(finger.area_mm2, 1))
                      : widgets::coreText(sensing::toString(finger.reason)));
}

}  // namespace fyd::console
