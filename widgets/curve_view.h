// The curves of a session, one below the other on one time axis, each with its numeral:
// force, indentation, stiffness (target dashed, measured), vibration duty, the robot's three accelerations.
//
// Samples may come at any rate; pictures are drawn at most 30 times a second, numerals 8 times.
#pragma once

#include <QButtonGroup>
#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <span>
#include <vector>

#include "core/pipeline/telemetry.h"
#include "widgets/curve_buffer.h"
#include "widgets/curve_strip.h"
#include "widgets/readout.h"
#include "widgets/recent_value.h"
#include "widgets/time_window.h"

namespace fyd::widgets {

class CurveView : public QWidget {
  Q_OBJECT
 public:
  explicit CurveView(QWidget* parent = nullptr);

  void append(std::span<const pipeline::TelemetrySample> samples);
  [[nodiscard]] bool following() const { return window_.following(); }
  [[nodiscard]] const TimeWindow& timeWindow() const { return window_; }
  [[nodiscard]] const CurveBuffer& buffer() const { return buffer_; }
  [[nodiscard]] CurveStrip* strip(std::size_t index) const { return strips_[index]; }
  [[nodiscard]] std::size_t stripCount() const { return strips_.size(); }
  [[nodiscard]] Readout* readout(std::size_t index) const { return readouts_[index]; }
  [[nodiscard]] QString followText() const { return follow_label_->text(); }

 public slots:
  void follow();
  void pause();
  void togglePause();
  void chooseSpan(double span_s);

 signals:
  void followingChanged(bool following);

 private:
  void addStrip(const QString& title, const QString& unit, Range least, std::vector<Trace> traces,
                std::vector<Readout::Entry> entries, bool large, bool last);
  void buildBar(class QVBoxLayout* layout);
  void redraw();
  void refreshNumerals();
  void sayFollowing();

  CurveBuffer buffer_;
  TimeWindow window_;
  std::vector<CurveStrip*> strips_;
  std::vector<Readout*> readouts_;
  std::vector<RecentValue> recent_;  ///< one per channel
  pipeline::TelemetrySample newest_;
  Instant origin_{};
  bool any_ = false;
  bool dirty_ = true;
  bool was_following_ = true;
  QElapsedTimer since_sample_;
  QTimer redraw_timer_;
  QTimer numeral_timer_;
  QToolButton* follow_button_ = nullptr;
  QLabel* follow_label_ = nullptr;
  QButtonGroup* spans_ = nullptr;
};

}  // namespace fyd::widgets
