#include "core/recording/file/recording_values.h"

#include <algorithm>

#include "core/recording/file/recording_driver.h"
#include "core/recording/file/recording_layout.h"

namespace fyd::recording {
namespace {

/// A value that was never written takes no room in the file, and HDF5 would give as many zeros as its size says.
void checkIsWritten(hid_t file, hid_t set, const char* path, std::uint64_t bytes) {
  const std::uint64_t stored = H5Dget_storage_size(set);
  if (stored != bytes || bytes > diskBytes(file))
    failHard("{}: says to be {} bytes, while {} stand in the file of {} bytes", path, bytes, stored, diskBytes(file));
}

}  // namespace

void writeText(hid_t file, const char* path, const std::string& text) {
  const Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose, path);
  check(H5Pset_create_intermediate_group(properties.id(), 1), path);
  // HDF5 has no string type of length 0: the empty text has a null dataspace.
  const Handle type = textType(std::max<std::size_t>(1, text.size()));
  const Handle space(H5Screate(text.empty() ? H5S_NULL : H5S_SCALAR), H5Sclose, path);
  const Handle set(H5Dcreate2(file, path, type.id(), space.id(), properties.id(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                   path);
  if (!text.empty()) check(H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path);
}

std::string readText(hid_t file, const char* path) {
  const Handle set = openValue(file, path);
  const Handle type(H5Dget_type(set.id()), H5Tclose, path);
  const Handle space(H5Dget_space(set.id()), H5Sclose, path);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) failHard("{}: not a text", path);
  if (H5Sget_simple_extent_type(space.id()) == H5S_NULL) return {};
  if (H5Sget_simple_extent_npoints(space.id()) != 1) failHard("{}: not one text", path);
  const std::size_t size = H5Tget_size(type.id());
  if (size > kLongestText) failHard("{}: a text of {} bytes", path, size);
  checkIsWritten(file, set.id(), path, size);
  std::string text(size, '\0');
  check(H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path);
  return text;
}

void writeBytes(hid_t file, const char* path, const std::string& bytes) {
  const hsize_t count = bytes.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, path);
  const Handle set(H5Dcreate2(file, path, H5T_STD_U8LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                   path);
  check(H5Dwrite(set.id(), H5T_STD_U8LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path);
}

std::string readBytes(hid_t file, const char* path, std::uint64_t most) {
  const Handle set = openValue(file, path);
  const Handle space(H5Dget_space(set.id()), H5Sclose, path);
  const Handle type(H5Dget_type(set.id()), H5Tclose, path);
  if (H5Tequal(type.id(), H5T_STD_U8LE) <= 0) failHard("{}: not bytes", path);
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  if (size < 0 || static_cast<std::uint64_t>(size) > most) failHard("{}: {} bytes", path, size);
  checkIsWritten(file, set.id(), path, static_cast<std::uint64_t>(size));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check(H5Dread(set.id(), H5T_STD_U8LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path);
  return bytes;
}

void writeNumber(hid_t file, const char* attribute, std::int64_t value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, attribute);
  const Handle id(H5Acreate2(file, attribute, H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                  attribute);
  check(H5Awrite(id.id(), H5T_STD_I64LE, &value), attribute);
}

std::int64_t readNumber(hid_t file, const char* attribute) {
  const Handle id(H5Aopen(file, attribute, H5P_DEFAULT), H5Aclose, attribute);
  const Handle space(H5Aget_space(id.id()), H5Sclose, attribute);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) failHard("{}: not one number", attribute);
  std::int64_t value = 0;
  check(H5Aread(id.id(), H5T_STD_I64LE, &value), attribute);
  return value;
}

}  // namespace fyd::recording
