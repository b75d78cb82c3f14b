#include "core/export/export_columns.h"

#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/system_reason.h"

namespace fyd::exports {

ColumnStore::~ColumnStore() {
  if (mapped_ != nullptr) ::munmap(const_cast<double*>(mapped_), columns_ * rows_ * sizeof(double));
  if (file_ >= 0) ::close(file_);
}

Result<void> ColumnStore::open(const std::string& folder) {
  std::string name = (folder.empty() ? "." : folder) + "/.fyd-columns-XXXXXX";
  file_ = ::mkstemp(name.data());
  if (file_ < 0) return fail("{}: no temporary file can be made: {}", folder, systemReason(errno));
  ::unlink(name.c_str());
  return {};
}

Result<void> ColumnStore::put(std::size_t column, std::size_t first_row, std::span<const double> values) {
  const auto bytes = std::as_bytes(values);
  auto offset = static_cast<off_t>((column * rows_ + first_row) * sizeof(double));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::pwrite(file_, bytes.data() + done, bytes.size() - done, offset);
    if (written <= 0) return fail("the temporary columns cannot be written: {}", systemReason(errno));
    done += static_cast<std::size_t>(written);
    offset += written;
  }
  return {};
}

Result<void> ColumnStore::map() {
  void* memory = ::mmap(nullptr, columns_ * rows_ * sizeof(double), PROT_READ, MAP_SHARED, file_, 0);
  if (memory == MAP_FAILED) return fail("the temporary columns cannot be mapped: {}", systemReason(errno));
  mapped_ = static_cast<const double*>(memory);
  return {};
}

}  // namespace fyd::exports
