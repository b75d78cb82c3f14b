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
  enum class Size { full, line, sign };
  /// In a narrow bar its first line only, or its sign; the tool tip has both lines.
  void setSize(Size size);

 private:
  void refresh();
  RecordingView view_;
  Size size_ = Size::full;
  QString accessible_;  ///< both lines
};

}  // namespace fyd::widgets
