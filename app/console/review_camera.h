// The camera's picture at the cursor of a review, and what the detector made of it.
#pragma once

#include <QLabel>
#include <QWidget>

#include "core/session/recording.h"
#include "widgets/camera_image.h"

namespace fyd::console {

class ReviewCamera : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewCamera(QWidget* parent = nullptr);
  /// Another recording is shown: its pictures are counted anew.
  void forget() { shown_ = 0; }
  /// @param recording nullptr: none
  void showAt(const session::Recording* recording, double time_s);

 private:
  widgets::CameraImage* camera_;
  QLabel* words_;
  std::uint64_t shown_ = 0;  // number of the picture shown; 0: none
};

}  // namespace fyd::console
