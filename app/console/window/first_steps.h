// The way from the first start to the first touch: simulated or mine? connect, calibrate, touch. Each step is ticked by
// the session's real state.
#pragma once

#include <QObject>
#include <functional>

#include "app/console/shell/page.h"
#include "app/console/window/window_memory.h"
#include "widgets/status/guide_strip.h"

namespace fyd::console {

class FirstSteps : public QObject {
  Q_OBJECT
 public:
  /// @param go shows a place
  FirstSteps(const PageContext& context, const WindowMemory& memory, std::function<void(const QString& place)> go,
             QObject* parent = nullptr);
  [[nodiscard]] widgets::GuideStrip* strip() const { return strip_; }
  /// Shows the way, from the step one is at.
  void show();

 signals:
  void ownAsked();  ///< a touchpad of one's own is to be connected

 private:
  enum Step : std::size_t { choose, connected, calibrate, touch, over };
  void hear(std::span<const pipeline::TelemetrySample> samples);
  void chooseSimulated();
  void refresh();
  void countCalibrated();
  [[nodiscard]] Step step() const;
  [[nodiscard]] QString advice(Step step) const;
  [[nodiscard]] std::vector<widgets::GuideStrip::Action> actions(Step step);

  PageContext context_;
  WindowMemory memory_;
  std::function<void(const QString& place)> go_;
  widgets::GuideStrip* strip_ = nullptr;
  QTimer counting_;  ///< looks at the calibration records while the way is shown
  bool chosen_ = false;
  bool answers_ = false;
  bool touched_ = false;
  bool calibrates_later_ = false;
  int calibrated_ = 0;  ///< parts with a record
};

}  // namespace fyd::console
