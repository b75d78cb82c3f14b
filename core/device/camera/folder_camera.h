// A folder of pictures as a camera: in the order of their names, 30 a second, again from the start at the end.
#pragma once

#include <string>
#include <vector>

#include "core/device/camera/camera.h"
#include "core/device/camera/camera_controls.h"
#include "core/device/pacer.h"

namespace fyd::device {

class FolderCamera final : public Camera {
 public:
  /// @return an error when the folder cannot be read or holds no picture
  [[nodiscard]] static Result<std::unique_ptr<Camera>> open(const std::string& folder,
                                                            const CameraSettings& settings = {});

  [[nodiscard]] Message description() const override;
  [[nodiscard]] std::vector<CameraControl> controls() const override {
    return noControls(settings_, say("a folder has none"));
  }
  [[nodiscard]] Message kind() const override { return say("folder"); }
  /// @return an error for a picture that cannot be decoded (the next call goes on with the one after it), and when
  ///         the folder is empty as it is listed again at the end of a round
  [[nodiscard]] Result<CameraFrame> next() override;

 private:
  FolderCamera(std::string folder, const CameraSettings& settings)
      : folder_(std::move(folder)), settings_(settings), pacer_(kUsualRate_Hz) {}
  [[nodiscard]] Result<void> list();

  std::string folder_;
  CameraSettings settings_;
  std::vector<std::string> files_;
  std::size_t position_ = 0;
  Pacer pacer_;
  std::uint64_t number_ = 0;
};

}  // namespace fyd::device
