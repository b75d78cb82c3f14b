// The last seconds of pictures, as the camera gave them; compressing waits until a recording wants them.
#pragma once

#include <deque>
#include <optional>

#include "core/recording/recording_types.h"

namespace fyd::recording {

struct HeldPicture {
  cv::Mat picture;
  cv::Rect region_px;
  sensing::FingerDetection finger;
  Instant taken{};
  std::uint64_t number = 0;
};

[[nodiscard]] inline std::size_t bytesOf(const HeldPicture& held) {
  return held.picture.total() * held.picture.elemSize();
}

/// The region of interest as PNG, and the whole picture as JPEG when it is asked for or there is no such region; both
/// empty when the picture cannot be compressed.
[[nodiscard]] EncodedPicture encodePicture(const HeldPicture& held, bool with_whole = true);

/// Used by one thread at a time. Bounded in memory: a large camera's pictures go back less far than the steps.
class PictureHistory {
 public:
  static constexpr std::size_t kMost_bytes = 40'000'000;

  void add(HeldPicture picture);
  /// Drops pictures taken before `oldest`, but none that the reader has still to read: kMost_bytes alone bounds those.
  void trim(Instant oldest);

  /// The one reader: pictures taken at `from` and later.
  void readFrom(Instant from);
  void stopReading() { reading_ = false; }
  /// The next one, in order, taken no later than `until`.
  [[nodiscard]] std::optional<HeldPicture> read(Instant until);
  /// Pictures that never came here, and that the reader would have read.
  void countLost(std::uint64_t pictures) { lost_ += reading_ ? pictures : 0; }
  /// Pictures dropped before they were read, since readFrom.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  void drop();

  std::deque<HeldPicture> pictures_;
  std::size_t bytes_ = 0;
  std::uint64_t dropped_ = 0;
  std::uint64_t reader_ = 0;
  std::uint64_t lost_ = 0;
  bool reading_ = false;
};

}  // namespace fyd::recording
