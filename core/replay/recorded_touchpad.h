// A recording as a touchpad: plays its raw readings in real time. Commands have no effect.
#pragma once

#include "core/device/touchpad/touchpad.h"
#include "core/recording/reader/recording.h"
#include "core/replay/recorded_device.h"

namespace fyd::replay {

class RecordedTouchpad final : public device::Touchpad {
 public:
  /// @return an error when the file is no recording or holds no step
  [[nodiscard]] static Result<std::unique_ptr<device::Touchpad>> open(const std::string& path,
                                                                      std::shared_ptr<PlaybackStart> start);

  [[nodiscard]] Message description() const override;
  /// Instants are shifted to the present. @return an error once the recording has ended
  [[nodiscard]] Result<device::TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  [[nodiscard]] bool driven() const override { return false; }
  [[nodiscard]] Duration period() const override { return std::chrono::milliseconds(1); }

 private:
  RecordedTouchpad(std::string path, std::unique_ptr<recording::Recording> recording,
                   std::shared_ptr<PlaybackStart> start);
  [[nodiscard]] Result<void> read(std::uint64_t row);

  std::string path_;
  std::unique_ptr<recording::Recording> recording_;
  std::shared_ptr<PlaybackStart> start_;
  std::uint64_t next_row_ = 0;
  recording::StepRecord next_;  // row next_row_
  device::TouchpadReadings readings_;
};

}  // namespace fyd::replay
