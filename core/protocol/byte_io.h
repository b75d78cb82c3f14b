// Little-endian numbers into and out of a span of bytes; a write or read past the end is not done and makes
// ok() false.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace fyd::protocol {

class ByteWriter {
 public:
  explicit ByteWriter(std::span<std::uint8_t> out) : out_(out) {}

  template <int Bytes>
  void little(std::uint64_t value) {
    if (!room(Bytes)) return;
    for (int i = 0; i < Bytes; ++i) out_[size_++] = static_cast<std::uint8_t>(value >> (8 * i));
  }
  void u8(std::uint8_t value) { little<1>(value); }
  void u16(std::uint16_t value) { little<2>(value); }
  void u32(std::uint32_t value) { little<4>(value); }
  void u48(std::uint64_t value) { little<6>(value); }
  void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
  void bytes(std::span<const std::uint8_t> value) {
    if (!room(value.size()) || value.empty()) return;
    std::memcpy(out_.data() + size_, value.data(), value.size());
    size_ += value.size();
  }

  [[nodiscard]] bool ok() const { return ok_; }
  /// Bytes written; 0 when they did not fit.
  [[nodiscard]] std::size_t size() const { return ok_ ? size_ : 0; }

 private:
  bool room(std::size_t wanted) {
    ok_ = ok_ && wanted <= out_.size() - size_;
    return ok_;
  }
  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> in) : in_(in) {}

  template <int Bytes>
  std::uint64_t little() {
    const auto taken = bytes(Bytes);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) value |= std::uint64_t{taken[i]} << (8 * i);
    return value;
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(little<1>()); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(little<2>()); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little<4>()); }
  std::uint64_t u48() { return little<6>(); }
  float f32() { return std::bit_cast<float>(u32()); }
  /// Empty, and the reader no longer ok, when fewer are left.
  std::span<const std::uint8_t> bytes(std::size_t count) {
    ok_ = ok_ && count <= in_.size();
    if (!ok_) return {};
    const auto taken = in_.first(count);
    in_ = in_.subspan(count);
    return taken;
  }

  [[nodiscard]] std::size_t left() const { return in_.size(); }
  [[nodiscard]] bool ok() const { return ok_; }
  /// Everything was there and nothing is left over.
  [[nodiscard]] bool complete() const { return ok_ && in_.empty(); }

 private:
  std::span<const std::uint8_t> in_;
  bool ok_ = true;
};

}  // namespace fyd::protocol
