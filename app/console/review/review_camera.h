// The camera's picture at the cursor of a review, with the detector's result.
#pragma once

#include <QLabel>
#include <QWidget>

#include "core/recording/reader/recording.h"
#include "widgets/devices/camera_image.h"

namespace fyd::console {

class ReviewCamera : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewCamera(QWidget* parent = nullptr);
  /// To be called when another recording is shown: picture numbers start anew.
  void forget() { shown_ = 0; }
  /// @param recording nullptr: none
  void showAt(const recording::Recording* recording, double time_s);

 private:
  widgets::CameraImage* camera_ = nullptr;
  QLabel* words_ = nullptr;
  std::uint64_t shown_ = 0;  // number of the picture shown; 0: none
};

}  // namespace fyd::console
