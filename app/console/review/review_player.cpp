#include "app/console/review/review_player.h"

#include <algorithm>
#include <cmath>

#include "app/console/review/review_source.h"

namespace fyd::console {
namespace {

constexpr int kTick_ms = 33;

}  // namespace

ReviewPlayer::ReviewPlayer(QObject* parent) : QObject(parent) {
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, &ReviewPlayer::advance);
}

double ReviewPlayer::duration() const { return recording_ == nullptr ? 0.0 : recording_->info().duration_s; }

void ReviewPlayer::setRecording(const recording::Recording* recording) {
  stop();
  recording_ = recording;
  goTo(0.0);
}

void ReviewPlayer::goTo(double time_s) {
  time_s_ = std::clamp(std::isfinite(time_s) ? time_s : 0.0, 0.0, duration());
  emit moved(time_s_);
}

void ReviewPlayer::togglePlaying() {
  if (playing()) {
    stop();
    return;
  }
  if (recording_ == nullptr || duration() <= 0.0) return;
  if (time_s_ >= duration()) goTo(0.0);
  since_.start();
  timer_.start();
  emit playingChanged(true);
}

void ReviewPlayer::stop() {
  if (!playing()) return;
  timer_.stop();
  emit playingChanged(false);
}

void ReviewPlayer::setSpeed(double speed) {
  if (std::isfinite(speed)) speed_ = std::clamp(speed, kSlowest, kFastest);
}

void ReviewPlayer::advance() {
  const double passed_s = 1e-3 * static_cast<double>(since_.restart());
  goTo(time_s_ + passed_s * speed_);
  if (time_s_ >= duration()) stop();
}

void ReviewPlayer::stepSamples(int samples) {
  if (recording_ == nullptr || recording_->info().committed_samples == 0) return;
  stop();
  // The row the cursor stands on is the last one at or before it.
  const auto next = recording_->rowAt(justAfter(time_s_));
  if (!next) return;
  const auto last = static_cast<std::int64_t>(recording_->info().committed_samples) - 1;
  const std::int64_t row = std::clamp<std::int64_t>(static_cast<std::int64_t>(*next) - 1 + samples, 0, last);
  pipeline::TelemetrySample sample;
  if (recording_->telemetry(static_cast<std::uint64_t>(row), {&sample, 1})) {
    goTo(recording::secondsInto(recording_->info(), sample.now));
  }
}

void ReviewPlayer::stepPictures(int pictures) {
  if (recording_ == nullptr || recording_->info().frames == 0) return;
  stop();
  // Bisection: the pictures' times increase.
  std::uint64_t low = 0;
  std::uint64_t high = recording_->info().frames;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    const auto picture = recording_->picture(middle);
    if (!picture) return;
    (picture->time_s > time_s_ ? high : low) = picture->time_s > time_s_ ? middle : middle + 1;
  }
  const auto last = static_cast<std::int64_t>(recording_->info().frames) - 1;
  const std::int64_t index = std::clamp<std::int64_t>(static_cast<std::int64_t>(low) - 1 + pictures, 0, last);
  if (const auto picture = recording_->picture(static_cast<std::uint64_t>(index))) goTo(picture->time_s);
}

}  // namespace fyd::console
