#include "core/replay/recorded_touchpad.h"

#include "core/recording/format/recording_format.h"

namespace fyd::replay {
namespace {

template <class T>
void move(Timed<T>& value, Duration by) {
  if (value.count > 0) value.taken += by;
}

}  // namespace

RecordedTouchpad::RecordedTouchpad(std::string path, std::unique_ptr<recording::Recording> recording,
                                   std::shared_ptr<PlaybackStart> start)
    : path_(std::move(path)), recording_(std::move(recording)), start_(std::move(start)) {}

Result<std::unique_ptr<device::Touchpad>> RecordedTouchpad::open(const std::string& path,
                                                                 std::shared_ptr<PlaybackStart> start) {
  auto recording = recording::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  if ((*recording)->info().committed_samples == 0) return fail("{}: the recording holds no step", path);
  std::unique_ptr<RecordedTouchpad> touchpad(new RecordedTouchpad(path, std::move(*recording), std::move(start)));
  if (auto read = touchpad->read(0); !read) return tl::unexpected(read.error());
  return touchpad;
}

Message RecordedTouchpad::description() const {
  return say("recording {}, {:.1f} s, played once; motors are not driven", path_, recording_->info().duration_s);
}

Result<void> RecordedTouchpad::read(std::uint64_t row) {
  auto record = recording_->step(row);
  if (!record) return tl::unexpected(record.error());
  next_row_ = row;
  next_ = *record;
  return {};
}

Result<device::TouchpadReadings> RecordedTouchpad::exchange(const control::MotorCommand& /*command*/, Instant now) {
  const recording::RecordingInfo& info = recording_->info();
  const Duration shift = start_->at(now) - info.header.started;
  const auto take = [&](recording::Table table, const auto& recorded, auto& reading) {
    if ((next_.missing & bitOf(table)) != 0) return;  // lost in the recording: taken as no new reading
    reading = recorded;
    move(reading, shift);
  };
  while (next_row_ < info.committed_samples && next_.inputs.now + shift <= now) {
    take(recording::Table::ir, next_.inputs.ir, readings_.ir);
    take(recording::Table::bridge, next_.inputs.bridge, readings_.bridge);
    take(recording::Table::motor_feedback, next_.inputs.motors, readings_.motors);
    if (next_row_ + 1 == info.committed_samples) {
      ++next_row_;
    } else if (auto row = read(next_row_ + 1); !row) {
      return tl::unexpected(row.error());
    }
  }
  if (next_row_ == info.committed_samples) return fail("{}: the recording has ended", path_);
  return readings_;
}

}  // namespace fyd::replay
