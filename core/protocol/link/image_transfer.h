// Pictures cut into fragments and put together again. A picture of which a fragment is missing when the next one
// begins is given up: what arrives is whole, or not shown. Neither side allocates after construction.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "core/protocol/link/link_messages.h"

namespace fyd::protocol {

inline constexpr std::size_t kMaximumFragments = (kMaximumLinkImage + kImageFragment - 1) / kImageFragment;

class ImageSender {
 public:
  ImageSender() : picture_(kMaximumLinkImage) {}
  [[nodiscard]] bool busy() const { return sent_ < size_; }
  /// Copies the picture. @return false when it is empty, too long, or another one is still on its way
  bool begin(Bytes picture) {
    if (busy() || picture.empty() || picture.size() > picture_.size()) return false;
    std::ranges::copy(picture, picture_.begin());
    size_ = picture.size();
    sent_ = 0;
    ++number_;
    return true;
  }
  void stop() { sent_ = size_ = 0; }
  /// The next fragment; only while busy.
  [[nodiscard]] LinkImageFragment next() {
    const std::size_t size = std::min(kImageFragment, size_ - sent_);
    const LinkImageFragment out{.picture = number_,
                                .size = static_cast<std::uint32_t>(size_),
                                .index = static_cast<std::uint16_t>(sent_ / kImageFragment),
                                .bytes = Bytes(picture_).subspan(sent_, size)};
    sent_ += size;
    return out;
  }

 private:
  std::vector<std::uint8_t> picture_;
  std::size_t size_ = 0;
  std::size_t sent_ = 0;
  std::uint16_t number_ = 0;
};

class ImageReceiver {
 public:
  ImageReceiver() : incoming_(kMaximumLinkImage), whole_(kMaximumLinkImage) {}
  /// @return true when this fragment completed a picture
  bool take(const LinkImageFragment& fragment) {
    if (fragment.picture != number_ || fragment.size != size_) {
      // A late fragment of an older picture must not discard the present one.
      if (size_ != 0 && static_cast<std::int16_t>(fragment.picture - number_) < 0) return false;
      number_ = fragment.picture;
      size_ = fragment.size;
      have_.reset();
    }
    if (have_.test(fragment.index)) return false;
    std::ranges::copy(fragment.bytes, incoming_.begin() + static_cast<std::ptrdiff_t>(fragment.index * kImageFragment));
    have_.set(fragment.index);
    if (have_.count() != (size_ + kImageFragment - 1) / kImageFragment) return false;
    std::swap(incoming_, whole_);
    whole_size_ = size_;
    return true;
  }
  void reset() {
    size_ = 0;
    have_.reset();
  }
  /// The last whole picture, encoded.
  [[nodiscard]] Bytes image() const { return Bytes(whole_).first(whole_size_); }

 private:
  std::vector<std::uint8_t> incoming_;
  std::vector<std::uint8_t> whole_;
  std::bitset<kMaximumFragments> have_;
  std::uint16_t number_ = 0;
  std::size_t size_ = 0;
  std::size_t whole_size_ = 0;
};

}  // namespace fyd::protocol
