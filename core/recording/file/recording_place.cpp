#include "core/recording/file/recording_place.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/base/atomic_rename.h"
#include "core/base/system_reason.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording {
namespace {

// Offset of the lock, beyond any file's end. Open-file-description locks do not conflict with HDF5's whole-file locks.
constexpr off_t kLockAt = off_t{1} << 62U;

constexpr const char* kNotesEnding = ".notes.json";

struct NetworkKind {
  std::uint64_t magic;
  const char* name;
};
constexpr auto kNetwork = std::to_array<NetworkKind>({{NFS_SUPER_MAGIC, "NFS"},
                                                      {SMB_SUPER_MAGIC, "SMB"},
                                                      {0xFF534D42, "CIFS"},
                                                      {0xFE534D42, "SMB2"},
                                                      {CEPH_SUPER_MAGIC, "Ceph"},
                                                      {AFS_SUPER_MAGIC, "AFS"},
                                                      {CODA_SUPER_MAGIC, "Coda"},
                                                      {V9FS_MAGIC, "9P"},
                                                      {FUSE_SUPER_MAGIC, "FUSE"}});

std::string folderOf(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

/// The notes of a recording of this name, whatever the name is: those of earlier versions where only they are there.
std::string notesBeside(const std::string& recording_path) {
  const std::string whole = wholeOf(recording_path);
  const std::string path = whole + kNotesEnding, former = partialOf(whole) + kNotesEnding;
  std::error_code problem;
  const bool only_former = !std::filesystem::exists(path, problem) && std::filesystem::exists(former, problem);
  return only_former ? former : path;
}

Message reasonOf(int error) { return systemReason(error); }

struct flock lockRange(short type) {
  struct flock range {};
  range.l_type = type;
  range.l_whence = SEEK_SET;
  range.l_start = kLockAt;
  range.l_len = 1;
  return range;
}

}  // namespace

std::string partialOf(const std::string& path) { return path + kPartialEnding; }

std::string wholeOf(std::string path) {
  if (path.ends_with(kPartialEnding)) path.resize(path.size() - std::string_view(kPartialEnding).size());
  return path;
}

std::string existingName(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 && ::stat(partialOf(path).c_str(), &status) == 0) return partialOf(path);
  return path;
}

std::string reviewNotesPath(const std::string& recording_path) {
  std::string named = notesBeside(recording_path);
  const std::string file = existingName(recording_path);
  std::error_code problem;
  if (!std::filesystem::is_symlink(file, problem)) return named;
  const std::filesystem::path target = std::filesystem::canonical(file, problem);
  if (problem) return named;
  std::string theirs = notesBeside(target);
  const bool only_named = !std::filesystem::exists(theirs, problem) && std::filesystem::exists(named, problem);
  return only_named ? named : theirs;
}

const char* networkShareOf(const std::string& folder) {
  struct statfs system {};
  if (::statfs(folder.c_str(), &system) != 0) return nullptr;
  for (const NetworkKind& kind : kNetwork)
    if (static_cast<std::uint32_t>(system.f_type) == kind.magic) return kind.name;
  return nullptr;
}

Result<void> checkPlace(const std::string& path) {
  const std::string folder = folderOf(path);
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) return fail("{}: the folder cannot be used: {}", folder, reasonOf(errno));
  if (!S_ISDIR(status.st_mode)) return fail("{}: not a folder", folder);
  struct statfs system {};
  if (::statfs(folder.c_str(), &system) != 0) return fail("{}: the folder cannot be used: {}", folder, reasonOf(errno));
  if (const char* kind = networkShareOf(folder))
    return fail("{}: lies on {}; a recording needs a local disk, whose promise to have written can be trusted", folder,
                kind);
  for (const std::string& name : {path, partialOf(path)})
    if (::lstat(name.c_str(), &status) == 0) return fail("{}: exists; a recording never replaces a file", name);
  // They would become this recording's, and their tags would stand in place of its own.
  if (const std::string notes = reviewNotesPath(path); ::lstat(notes.c_str(), &status) == 0) {
    return fail("{}: notes of another recording of this name; move them away, or choose another name", notes);
  }
  return {};
}

Result<void> syncFolder(const std::string& path) {
  const std::string folder = folderOf(path);
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return fail(about(folder, reasonOf(errno)));
  const int status = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  // Some file systems cannot sync a folder (EINVAL) and store names without it.
  if (status != 0 && error != EINVAL) return fail(about(folder, reasonOf(error)));
  return {};
}

Result<void> renameNew(const std::string& from, const std::string& to) {
  const std::error_code problem = renameAtomically(from, to, ExistingFile::keep);
  if (problem) return fail("{}: cannot be named {}: {}", from, to, systemReason(problem));
  return {};
}

bool lockAsRecorder(int file_descriptor) {
  struct flock range = lockRange(F_WRLCK);
  return ::fcntl(file_descriptor, F_OFD_SETLK, &range) == 0;
}

bool recorderRuns(int file_descriptor) {
  struct flock range = lockRange(F_WRLCK);
  // F_OFD_GETLK only queries the lock, so a read-only descriptor is enough.
  return ::fcntl(file_descriptor, F_OFD_GETLK, &range) == 0 && range.l_type != F_UNLCK;
}

}  // namespace fyd::recording
