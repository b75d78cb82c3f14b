// Flips bits in a recording's file, as a bad disk does, and changes it through HDF5, as another program does.
#pragma once

#include <hdf5.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_hdf5.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording::samples {

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

/// Flips one bit in the middle of a table's chunk. @param file a closed recording
inline void damageChunk(const std::string& file, const char* table, hsize_t number) {
  const auto [at, size] = chunkOf(file, table, number);
  std::string bytes = contentOf(file);
  bytes[at + size / 2] = static_cast<char>(bytes[at + size / 2] ^ 0x10);
  write(file, bytes);
}

/// Offset of a commit's row in the file. @param file a closed recording
inline std::size_t commitAt(const std::string& file, std::uint64_t number) {
  constexpr std::size_t kRowsInChunk = 4096 / sizeof(CommitRow);
  return chunkOf(file, "/commits", number / kRowsInChunk).first + number % kRowsInChunk * sizeof(CommitRow);
}

/// Flips one bit of the file.
inline void flipBit(const std::string& file, std::size_t byte, unsigned bit) {
  std::fstream disk(file, std::ios::binary | std::ios::in | std::ios::out);
  char c = 0;
  disk.seekg(static_cast<std::streamoff>(byte)).get(c);
  disk.seekp(static_cast<std::streamoff>(byte)).put(static_cast<char>(c ^ (1 << bit)));
}

/// Overwrites bytes of the file with zeros, as a disk gives a lost sector.
inline void loseBytes(const std::string& file, std::size_t first, std::size_t count) {
  std::fstream disk(file, std::ios::binary | std::ios::in | std::ios::out);
  disk.seekp(static_cast<std::streamoff>(first));
  disk.write(std::string(count, '\0').data(), static_cast<std::streamsize>(count));
}

/// Changes a closed recording. @param how is given the opened file
inline void change(const std::string& file, const std::function<void(hid_t)>& how) {
  const auto lock = hdf5Lock();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "access");
  const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, access.id()), H5Fclose, "the file");
  how(opened.id());
}

/// Whether HDF5's own programs open it: neither too damaged nor marked as being written.
inline bool othersOpen(const std::string& file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  return id >= 0 && H5Fclose(id) >= 0;
}

}  // namespace fyd::recording::samples
