// A recording as a camera: plays its pictures in real time, the region of interest exactly as recorded.
#pragma once

#include "core/device/camera/camera.h"
#include "core/recording/reader/recording.h"
#include "core/replay/recorded_device.h"

namespace fyd::replay {

class RecordedCamera final : public device::Camera {
 public:
  /// @return an error when the file is no recording or holds no picture
  [[nodiscard]] static Result<std::unique_ptr<device::Camera>> open(const std::string& path,
                                                                    std::shared_ptr<PlaybackStart> start);

  [[nodiscard]] Message description() const override;
  [[nodiscard]] Message kind() const override { return say("recording"); }
  /// @return an error once the recording has ended
  [[nodiscard]] Result<device::CameraFrame> next() override;

 private:
  RecordedCamera(std::string path, std::unique_ptr<recording::Recording> recording,
                 std::shared_ptr<PlaybackStart> start);

  std::string path_;
  std::unique_ptr<recording::Recording> recording_;
  std::shared_ptr<PlaybackStart> start_;
  std::uint64_t next_ = 0;
};

}  // namespace fyd::replay
