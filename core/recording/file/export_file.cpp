#include "core/recording/file/export_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/base/atomic_rename.h"
#include "core/base/system_reason.h"

namespace fyd::recording {
namespace {

bool exists(const std::string& path) {
  struct stat ignored {};
  return ::lstat(path.c_str(), &ignored) == 0;
}

}  // namespace

Result<ExportFile> ExportFile::create(const std::string& path, bool replace) {
  if (std::filesystem::path(path).filename().empty()) return fail("{}: not a file's name", path);
  if (!replace && exists(path)) return fail("{}: exists already", path);
  auto target = writeTargetOf(path);
  if (!target) return tl::unexpected(target.error());
  const std::filesystem::path wanted(target->path);
  removeExportLeftovers(wanted.parent_path());
  auto part = makeExportPart(wanted);
  if (!part) return tl::unexpected(part.error());
  ExportFile file(path, std::move(*target), std::move(*part), replace);
  if (auto taken = takeOver(file.target_, file.lock_); !taken) return tl::unexpected(taken.error());
  return file;
}

ExportFile::ExportFile(std::string path, WriteTarget target, ExportPart part, bool replace)
    : path_(std::move(path)),
      target_(std::move(target)),
      temporary_(std::move(part.path)),
      lock_(part.lock),
      replace_(replace) {}

ExportFile::ExportFile(ExportFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      lock_(std::exchange(other.lock_, -1)),
      replace_(other.replace_),
      file_(std::move(other.file_)) {}

ExportFile::~ExportFile() {
  file_.reset();
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (lock_ >= 0) ::close(lock_);
}

tl::unexpected<Error> ExportFile::failed(int error) const {
  const Message why = systemReason(error);
  if (target_.exists) return fail("{}: writing failed: {}; the file stays as it was", path_, why);
  return fail("{}: writing failed: {}; nothing is left of it", path_, why);
}

Result<void> ExportFile::write(std::string_view bytes) {
  if (!file_) {
    file_.reset(std::fopen(temporary_.c_str(), "wbe"));
    if (!file_) return failed(errno);
  }
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) return failed(errno);
  return {};
}

// Write errors may appear only when the file is synced.
Result<void> ExportFile::syncPart() const {
  const int file = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return failed(errno);
  const bool synced = ::fsync(file) == 0;
  const int problem = errno;
  ::close(file);
  if (!synced) return failed(problem);
  return {};
}

Result<void> ExportFile::commit() {
  if (file_) {
    if (std::fflush(file_.get()) != 0) return failed(errno);
    file_.reset();
  }
  if (auto synced = syncPart(); !synced) return synced;
  // Checks again, because something that may not be replaced can have appeared there meanwhile.
  if (auto still = writeTargetOf(target_.path); !still) return tl::unexpected(still.error());
  const std::error_code problem =
      renameAtomically(temporary_, target_.path, replace_ ? ExistingFile::replace : ExistingFile::keep);
  if (problem == std::errc::file_exists) return fail("{}: exists already", path_);
  if (problem) return failed(problem.value());
  temporary_.clear();
  return {};
}

}  // namespace fyd::recording
