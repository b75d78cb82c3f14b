#include "core/device/camera/folder_camera.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/system_reason.h"
#include "core/device/camera/picture_decoder.h"

namespace fyd::device {
namespace {

constexpr std::array<std::string_view, 7> kEndings = {".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".tif", ".tiff"};

bool isPicture(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace

Result<std::unique_ptr<Camera>> FolderCamera::open(const std::string& folder, const CameraSettings& settings) {
  std::unique_ptr<FolderCamera> camera(new FolderCamera(folder, settings));
  if (const auto listed = camera->list(); !listed) return tl::unexpected(listed.error());
  return camera;
}

Result<void> FolderCamera::list() {
  files_.clear();
  position_ = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
    if (isPicture(entry->path()) && entry->is_regular_file(error)) files_.push_back(entry->path().string());
  }
  if (error) return fail("camera folder '{}': {}", folder_, systemReason(error));
  if (files_.empty()) return fail("camera folder '{}': no pictures; expected {}", folder_, fmt::join(kEndings, " "));
  std::sort(files_.begin(), files_.end());
  return {};
}

Message FolderCamera::description() const {
  return say("folder {}, {} pictures at {:.0f} fps, repeating", folder_, files_.size(), pacer_.rate_Hz());
}

Result<CameraFrame> FolderCamera::next() {
  pacer_.wait();
  if (position_ == files_.size()) {
    if (const auto listed = list(); !listed) return tl::unexpected(listed.error());
  }
  const std::string& file = files_[position_++];
  auto picture = readPicture(file);
  if (!picture) return fail("camera folder: {}", picture.error().message);
  return CameraFrame{.picture = std::move(*picture), .taken = Clock::now(), .number = ++number_};
}

}  // namespace fyd::device
