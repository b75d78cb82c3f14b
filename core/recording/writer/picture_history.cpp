#include "core/recording/writer/picture_history.h"

#include <opencv2/imgcodecs.hpp>

#include "core/base/codecs/codecs.h"
#include "core/recording/file/picture_decode.h"
#include "core/recording/file/picture_png.h"

namespace fyd::recording {
namespace {

constexpr int kJpegQuality = 80;

}  // namespace

EncodedPicture encodePicture(const HeldPicture& held, bool with_whole) {
  EncodedPicture out{.taken = held.taken, .number = held.number, .region_px = held.region_px, .finger = held.finger};
  if (held.picture.empty() || static_cast<std::int64_t>(held.picture.total()) > kMostPixels) return out;
  try {
    const cv::Rect whole(0, 0, held.picture.cols, held.picture.rows);
    const bool inside = held.region_px.area() > 0 && (held.region_px & whole) == held.region_px;
    if (inside) out.region = encodePng(held.picture(held.region_px));
    if (with_whole || out.region.empty())
      codecs::encodePicture(".jpg", held.picture, out.whole, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  } catch (const cv::Exception&) {  // a depth that this format does not know
    out.whole.clear();
  }
  return out;
}

void PictureHistory::add(HeldPicture picture) {
  bytes_ += bytesOf(picture);
  pictures_.push_back(std::move(picture));
  while (pictures_.size() > 1 && bytes_ > kMost_bytes) drop();
}

void PictureHistory::drop() {
  if (reading_ && reader_ <= dropped_) ++lost_;
  bytes_ -= bytesOf(pictures_.front());
  pictures_.pop_front();
  ++dropped_;
}

void PictureHistory::trim(Instant oldest) {
  const auto unread = [this] { return reading_ && reader_ <= dropped_; };
  while (!pictures_.empty() && pictures_.front().taken < oldest && !unread()) drop();
}

void PictureHistory::readFrom(Instant from) {
  reading_ = true;
  lost_ = 0;
  reader_ = dropped_;
  for (const HeldPicture& picture : pictures_) {
    if (picture.taken >= from) break;
    ++reader_;
  }
}

std::optional<HeldPicture> PictureHistory::read(Instant until) {
  if (!reading_) return std::nullopt;
  if (reader_ < dropped_) reader_ = dropped_;
  const std::uint64_t index = reader_ - dropped_;
  if (index >= pictures_.size() || pictures_[index].taken > until) return std::nullopt;
  ++reader_;
  return pictures_[index];
}

}  // namespace fyd::recording
