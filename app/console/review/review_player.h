// The time cursor of a review: stops, plays at a speed, steps by sample or by picture.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/recording/reader/recording.h"

namespace fyd::console {

class ReviewPlayer : public QObject {
  Q_OBJECT
 public:
  static constexpr double kSlowest = 0.1;
  static constexpr double kFastest = 16.0;

  explicit ReviewPlayer(QObject* parent = nullptr);

  /// nullptr: none; must outlive this or be replaced first. The cursor goes to the start.
  void setRecording(const recording::Recording* recording);
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] bool playing() const { return timer_.isActive(); }
  [[nodiscard]] double speed() const { return speed_; }

 public slots:
  void goTo(double time_s);
  void togglePlaying();
  void stop();
  /// Clamped between kSlowest and kFastest.
  void setSpeed(double speed);
  /// @param samples > 0 forward
  void stepSamples(int samples);
  void stepPictures(int pictures);

 signals:
  void moved(double time_s);
  void playingChanged(bool playing);

 private:
  void advance();
  [[nodiscard]] double duration() const;

  const recording::Recording* recording_ = nullptr;
  double time_s_ = 0.0;
  double speed_ = 1.0;
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace fyd::console
