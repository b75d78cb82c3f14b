#include "core/recording/file/quick_deflate.h"

#include <isa-l/igzip_lib.h>

#include <limits>
#include <memory>

namespace fyd::recording {
namespace {

constexpr std::uint32_t kLevel = 1;  // the first with a Huffman code of its own: noise needs one
constexpr std::size_t kOverhead = 1'024;

const std::uint8_t* bytesOf(std::span<const std::byte> bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

}  // namespace

Result<void> quickDeflate(std::span<const std::byte> plain, std::vector<std::byte>& out) {
  thread_local std::vector<std::uint8_t> workspace(ISAL_DEF_LVL1_DEFAULT);
  thread_local const auto stream = std::make_unique<isal_zstream>();  // too large for a stack
  const std::size_t room = plain.size() + plain.size() / 8 + kOverhead;
  if (room > std::numeric_limits<std::uint32_t>::max()) return fail("{} bytes at once", plain.size());
  out.resize(room);
  isal_deflate_init(stream.get());
  stream->level = kLevel;
  stream->level_buf = workspace.data();
  stream->level_buf_size = static_cast<std::uint32_t>(workspace.size());
  stream->gzip_flag = IGZIP_ZLIB;
  stream->end_of_stream = 1;
  stream->flush = NO_FLUSH;
  stream->next_in = const_cast<std::uint8_t*>(bytesOf(plain));  // only read, though not declared const
  stream->avail_in = static_cast<std::uint32_t>(plain.size());
  stream->next_out = reinterpret_cast<std::uint8_t*>(out.data());
  stream->avail_out = static_cast<std::uint32_t>(out.size());
  const int status = isal_deflate(stream.get());
  if (status != COMP_OK || stream->internal_state.state != ZSTATE_END)
    return fail("{} bytes cannot be compressed ({})", plain.size(), status);
  out.resize(stream->total_out);
  return {};
}

Result<void> quickInflate(std::span<const std::byte> packed, std::span<std::byte> out) {
  thread_local const auto state = std::make_unique<inflate_state>();  // too large for a stack
  if (std::max(packed.size(), out.size()) > std::numeric_limits<std::uint32_t>::max())
    return fail("{} bytes at once", std::max(packed.size(), out.size()));
  isal_inflate_init(state.get());
  state->crc_flag = ISAL_ZLIB;
  state->next_in = const_cast<std::uint8_t*>(bytesOf(packed));
  state->avail_in = static_cast<std::uint32_t>(packed.size());
  state->next_out = reinterpret_cast<std::uint8_t*>(out.data());
  state->avail_out = static_cast<std::uint32_t>(out.size());
  const int status = isal_inflate(state.get());
  if (status != ISAL_DECOMP_OK) return fail("compressed bytes are damaged ({})", status);
  if (state->block_state != ISAL_BLOCK_FINISH || state->avail_out != 0)
    return fail("damaged: {} compressed bytes do not give the {} they should", packed.size(), out.size());
  return {};
}

}  // namespace fyd::recording
