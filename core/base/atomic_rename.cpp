#include "core/base/atomic_rename.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace fyd {
namespace {

std::error_code lastError() { return {errno, std::generic_category()}; }

bool unsupported(int error) { return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP; }

}  // namespace

std::error_code renameAtomically(const std::string& from, const std::string& to, ExistingFile existing) {
  if (existing == ExistingFile::replace)
    return ::rename(from.c_str(), to.c_str()) == 0 ? std::error_code{} : lastError();
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (!unsupported(errno)) return lastError();
  // Without RENAME_NOREPLACE: link() also fails when the name is taken.
  if (::link(from.c_str(), to.c_str()) == 0) return ::unlink(from.c_str()) == 0 ? std::error_code{} : lastError();
  if (!unsupported(errno) && errno != EPERM) return lastError();
  if (::access(to.c_str(), F_OK) == 0) return std::make_error_code(std::errc::file_exists);
  return ::rename(from.c_str(), to.c_str()) == 0 ? std::error_code{} : lastError();
}

}  // namespace fyd
