#include "core/device/camera/camera_source.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "core/device/camera/capture_camera.h"
#include "core/device/camera/folder_camera.h"

namespace fyd::device {
namespace {

Message devicesPresent() {
  std::vector<std::string> found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/dev", error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().starts_with("video")) found.push_back(entry->path().string());
  }
  std::sort(found.begin(), found.end());
  return found.empty() ? say("none") : verbatim(fmt::format("{}", fmt::join(found, ", ")));
}

std::optional<int> deviceNumber(const std::string& source) {
  int number = 0;
  const auto [end, error] = std::from_chars(source.data(), source.data() + source.size(), number);
  if (error != std::errc{} || end != source.data() + source.size() || number < 0) return std::nullopt;
  return number;
}

}  // namespace

Result<std::unique_ptr<Camera>> openCamera(const std::string& source, const DeviceParameters& parameters) {
  namespace fs = std::filesystem;
  const auto open = [&](CaptureKind kind, std::optional<int> number = std::nullopt) {
    return CaptureCamera::open(
        {.kind = kind, .source = number ? fmt::format("/dev/video{}", *number) : source, .number = number}, parameters);
  };
  std::error_code error;
  if (const auto number = deviceNumber(source)) {
    const std::string path = fmt::format("/dev/video{}", *number);
    if (!fs::exists(path, error)) {
      return fail("camera device {}: there is no {}; capture devices found: {}", *number, path, devicesPresent());
    }
    return open(CaptureKind::device, number);
  }
  if (source.starts_with("id=")) return open(CaptureKind::device);
  if (source.find("://") != std::string::npos) return open(CaptureKind::stream);
  const fs::file_status status = fs::status(source, error);
  switch (status.type()) {
    case fs::file_type::directory: return FolderCamera::open(source, cameraSettings(parameters));
    case fs::file_type::character: return open(CaptureKind::device);
    case fs::file_type::regular: return open(CaptureKind::video);
    default: break;
  }
  if (source.starts_with("/dev/")) {
    return fail("camera device '{}': there is none; capture devices found: {}", source, devicesPresent());
  }
  return fail(
      "camera '{}': no such file or folder; expected a device number, a path such as /dev/video0, id=SERIAL, a video "
      "file, a folder of pictures or a stream's URL",
      source);
}

}  // namespace fyd::device
