// In the state bar: whether a recording runs, for how long, how large it is, how long the disk lasts, what was lost.
// A press opens the form; it neither starts nor ends a recording by itself.
#pragma once

#include <QPushButton>

#include "widgets/status/recording_view.h"

namespace fyd::widgets {

class RecordButton : public QPushButton {
  Q_OBJECT
 public:
  explicit RecordButton(QWidget* parent = nullptr);
  void setRecording(const RecordingView& view);
  /// The first line only, in a narrow bar; the tool tip has both.
  void setCompact(bool compact);

 private:
  void refresh();
  RecordingView view_;
  bool compact_ = false;
  QString accessible_;  ///< both lines
};

}  // namespace fyd::widgets
