// Turns bits in a recording's file, as a bad disk does.
#pragma once

#include <hdf5.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "core/session/recording_disk.h"

namespace fyd::session::samples {

inline std::string contentOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write(const std::string& file, const std::string& content) {
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
}

/// Where a table's chunk lies in the file.
inline std::pair<std::size_t, std::size_t> chunkOf(const std::string& file, const char* table, hsize_t number) {
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(id, table, H5P_DEFAULT);
  haddr_t at = 0;
  hsize_t size = 0;
  const hid_t space = H5Dget_space(set);
  (void)H5Dget_chunk_info(set, space, number, nullptr, nullptr, &at, &size);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(id);
  return {at + kJournalBytes, size};  // HDF5 counts from behind the user block
}

/// Turns one bit in the middle of a table's chunk. @param file closed as it should be
inline void damageChunk(const std::string& file, const char* table, hsize_t number) {
  const auto [at, size] = chunkOf(file, table, number);
  std::string bytes = contentOf(file);
  bytes[at + size / 2] = static_cast<char>(bytes[at + size / 2] ^ 0x10);
  write(file, bytes);
}

}  // namespace fyd::session::samples
