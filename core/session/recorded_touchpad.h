// A recording as a touchpad: its raw readings come again at their own pace. Commands move nothing.
#pragma once

#include "core/device/touchpad.h"
#include "core/session/recorded_device.h"
#include "core/session/recording.h"

namespace fyd::session {

class RecordedTouchpad final : public device::Touchpad {
 public:
  /// @return an error when the file is no recording or holds no step
  [[nodiscard]] static Result<std::unique_ptr<device::Touchpad>> open(const std::string& path,
                                                                      std::shared_ptr<PlaybackStart> start);

  [[nodiscard]] Message description() const override;
  /// Instants are moved to the present. @return an error once the recording has ended: the touchpad is then silent
  [[nodiscard]] Result<device::TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  [[nodiscard]] bool driven() const override { return false; }
  [[nodiscard]] Duration period() const override { return std::chrono::milliseconds(1); }

 private:
  RecordedTouchpad(std::string path, std::unique_ptr<Recording> recording, std::shared_ptr<PlaybackStart> start);
  [[nodiscard]] Result<void> read(std::uint64_t row);

  std::string path_;
  std::unique_ptr<Recording> recording_;
  std::shared_ptr<PlaybackStart> start_;
  std::uint64_t next_row_ = 0;
  StepRecord next_;  // row next_row_
  device::TouchpadReadings readings_;
};

}  // namespace fyd::session
