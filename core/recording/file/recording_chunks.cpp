#include "core/recording/file/recording_chunks.h"

#include <algorithm>
#include <array>

#include "core/recording/file/quick_deflate.h"

namespace fyd::recording {
namespace {

// Scratch, under the HDF5 lock.
std::vector<std::byte>& plain() {
  static std::vector<std::byte> bytes;
  return bytes;
}
std::vector<std::byte>& packed() {
  static std::vector<std::byte> bytes;
  return bytes;
}

// HDF5's shuffle filter: first every row's first byte, then every row's second…
void shuffle(std::span<const std::byte> rows, std::size_t row_bytes, std::span<std::byte> out) {
  const std::size_t count = rows.size() / row_bytes;
  for (std::size_t column = 0; column < row_bytes; ++column)
    for (std::size_t i = 0; i < count; ++i) out[column * count + i] = rows[i * row_bytes + column];
}

void unshuffle(std::span<const std::byte> columns, std::size_t row_bytes, std::span<std::byte> out) {
  const std::size_t count = out.size() / row_bytes;
  for (std::size_t column = 0; column < row_bytes; ++column)
    for (std::size_t i = 0; i < count; ++i) out[i * row_bytes + column] = columns[column * count + i];
}

std::size_t chunkBytes(const TableLayout& layout) { return layout.chunk_rows * layout.row_bytes; }

}  // namespace

bool hasOurChunks(hid_t set, const TableLayout& layout) {
  const Handle properties(H5Dget_create_plist(set), H5Pclose, layout.path);
  hsize_t rows = 0;
  if (H5Pget_layout(properties.id()) != H5D_CHUNKED || H5Pget_chunk(properties.id(), 1, &rows) != 1) return false;
  const int filters = H5Pget_nfilters(properties.id());
  if (rows != layout.chunk_rows || filters != (layout.compressed ? 2 : 0)) return false;
  constexpr std::array kOurs{H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};
  for (unsigned i = 0; i < static_cast<unsigned>(filters); ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    if (H5Pget_filter2(properties.id(), i, &flags, &values, nullptr, 0, nullptr, nullptr) != kOurs[i]) return false;
  }
  return true;
}

void writeChunk(hid_t set, const TableLayout& layout, std::uint64_t first_row, std::span<const std::byte> rows) {
  if (rows.size() < chunkBytes(layout)) {
    plain().assign(rows.begin(), rows.end());
    plain().resize(chunkBytes(layout));
    rows = plain();
  }
  if (layout.compressed) {
    static std::vector<std::byte> columns;
    columns.resize(rows.size());
    shuffle(rows, layout.row_bytes, columns);
    if (const auto done = quickDeflate(columns, packed()); !done) failHard(about(layout.path, done.error().message));
    rows = packed();
  }
  const hsize_t first = first_row;
  check(H5Dwrite_chunk(set, H5P_DEFAULT, 0, &first, rows.size(), rows.data()), layout.path);
}

void readChunk(hid_t set, const TableLayout& layout, std::uint64_t first_row, std::span<std::byte> chunk) {
  const hsize_t first = first_row;
  hsize_t stored = 0;
  check(H5Dget_chunk_storage_size(set, &first, &stored), layout.path);
  const std::size_t whole = chunkBytes(layout);
  if (stored == 0 || (layout.compressed ? stored > 2 * whole + 1'024 : stored != whole))
    failHard("{}: rows from {} on take {} bytes", layout.path, first_row, stored);
  std::uint32_t left_out = 0;  // filters
  if (!layout.compressed) {
    check(H5Dread_chunk(set, H5P_DEFAULT, &first, &left_out, chunk.data()), layout.path);
    return;
  }
  packed().resize(stored);
  check(H5Dread_chunk(set, H5P_DEFAULT, &first, &left_out, packed().data()), layout.path);
  if (left_out != 0) failHard("{}: rows from {} on are packed otherwise", layout.path, first_row);
  plain().resize(whole);
  if (const auto done = quickInflate(packed(), plain()); !done)
    failHard("{}: rows from {} on: {}", layout.path, first_row, done.error().message);
  unshuffle(plain(), layout.row_bytes, chunk);
}

}  // namespace fyd::recording
