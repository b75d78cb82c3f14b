#include "core/catalogue/archive_move.h"

#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/atomic_rename.h"
#include "core/base/system_reason.h"
#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_address.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/review_notes.h"

namespace fyd::catalogue {
namespace {

namespace fs = std::filesystem;
using Hash = std::array<unsigned char, crypto_generichash_BYTES>;
constexpr std::size_t kChunk = std::size_t{1} << 20;

Message reason() { return systemReason(errno); }

class File {
 public:
  File(const std::string& path, int flags, mode_t mode = 0600) : fd_(open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (fd_ >= 0) close(fd_);
  }
  explicit operator bool() const { return fd_ >= 0; }
  [[nodiscard]] int get() const { return fd_; }
  /// Some file systems report a write error only here.
  [[nodiscard]] bool closeNow() { return close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

/// Removes the unfinished copy unless it was renamed.
struct Unfinished {
  std::string path;
  ~Unfinished() {
    if (!path.empty()) unlink(path.c_str());
  }
};

void syncFolder(const std::string& folder) {
  const File handle(folder, O_RDONLY | O_DIRECTORY);
  if (handle) fsync(handle.get());
}

bool writeAll(int fd, const unsigned char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(fd, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    data += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

/// Reads `from` to its end; each piece goes to `sink`, which returns false when it failed.
template <class Sink>
Result<Hash> hashed(const File& from, const std::string& name, Sink&& sink) {
  crypto_generichash_state state;
  crypto_generichash_init(&state, nullptr, 0, crypto_generichash_BYTES);
  std::vector<unsigned char> chunk(kChunk);
  for (;;) {
    const ssize_t got = read(from.get(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail("{}: cannot be read: {}", name, reason());
    if (got == 0) break;
    crypto_generichash_update(&state, chunk.data(), static_cast<unsigned long long>(got));
    if (auto ok = sink(chunk.data(), static_cast<std::size_t>(got)); !ok) return tl::unexpected(ok.error());
  }
  Hash out{};
  crypto_generichash_final(&state, out.data(), out.size());
  return out;
}

Result<Hash> hashOf(const std::string& path) {
  const File file(path, O_RDONLY);
  if (!file) return fail("{}: cannot be opened: {}", path, reason());
  posix_fadvise(file.get(), 0, 0, POSIX_FADV_DONTNEED);  // read from the storage, not the cache
  return hashed(file, path, [](const unsigned char*, std::size_t) -> Result<void> { return {}; });
}

bool sameMoment(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

/// Copies and verifies. The source is only read.
Result<void> copyVerified(const std::string& source, const std::string& target) {
  const File in(source, O_RDONLY);
  struct stat before {};
  if (!in || fstat(in.get(), &before) != 0) return fail("{}: cannot be opened: {}", source, reason());
  const fs::path folder = fs::path(target).parent_path();
  struct statvfs space {};
  if (statvfs(folder.c_str(), &space) == 0) {
    const auto free_bytes = static_cast<std::uint64_t>(space.f_bavail) * space.f_frsize;
    if (free_bytes < static_cast<std::uint64_t>(before.st_size)) {
      return fail("{}: {:.1f} MB free, the recording needs {:.1f} MB", folder.native(),
                  static_cast<double>(free_bytes) / 1e6, static_cast<double>(before.st_size) / 1e6);
    }
  }
  Unfinished copy{folder /
                  fmt::format(".{}.storing-{:08x}", fs::path(target).filename().native(), randombytes_random())};
  File out(copy.path, O_WRONLY | O_CREAT | O_EXCL, before.st_mode & 0777);
  if (!out) {
    const Message why = reason();
    copy.path.clear();
    return fail("{}: cannot be written: {}", folder.native(), why);
  }
  const auto written = hashed(in, source, [&](const unsigned char* data, std::size_t size) -> Result<void> {
    if (!writeAll(out.get(), data, size)) return fail("{}: writing failed: {}", copy.path, reason());
    return {};
  });
  if (!written) return tl::unexpected(written.error());
  const std::array<timespec, 2> times = {before.st_atim, before.st_mtim};
  futimens(out.get(), times.data());
  if (fsync(out.get()) != 0 || !out.closeNow()) return fail("{}: writing failed: {}", copy.path, reason());

  const auto arrived = hashOf(copy.path);
  if (!arrived) return tl::unexpected(arrived.error());
  struct stat after {};
  struct stat there {};
  if (stat(source.c_str(), &after) != 0 || after.st_size != before.st_size ||
      !sameMoment(after.st_mtim, before.st_mtim)) {
    return fail("{}: changed while it was copied; is it still being recorded?", source);
  }
  if (stat(copy.path.c_str(), &there) != 0 || there.st_size != before.st_size || *arrived != *written) {
    return fail("{}: the copy reads back differently from the source; the storage is not to be trusted", copy.path);
  }
  const std::error_code problem = renameAtomically(copy.path, target, ExistingFile::keep);
  if (problem == std::errc::file_exists) return fail("{}: there is a file of this name already", target);
  if (problem) return fail("{}: the copy cannot get its name: {}", target, systemReason(problem));
  copy.path.clear();
  syncFolder(folder);
  return {};
}

/// Refuses a target that is the source under another name (a link, a folder mounted twice, a file system that does not
/// tell capital letters from small ones): removing the source would remove the only copy.
Result<void> isFileOfItsOwn(const std::string& source, const std::string& target) {
  struct stat here {};
  struct stat there {};
  if (lstat(source.c_str(), &here) != 0) return fail(about(source, reason()));
  if (lstat(target.c_str(), &there) != 0) return fail(about(target, reason()));
  if (!S_ISREG(there.st_mode)) return fail("{}: expected an ordinary file", target);
  if (here.st_dev == there.st_dev && here.st_ino == there.st_ino) {
    return fail("{}: is {} itself under another name, not a copy; nothing was removed", target, source);
  }
  return {};
}

/// Whether the target is already a complete copy of the source, left by an interrupted move.
Result<bool> alreadyThere(const std::string& source, const std::string& target) {
  std::error_code error;
  const fs::file_status found = fs::symlink_status(target, error);
  if (found.type() == fs::file_type::not_found) return false;
  if (error) return fail(about(target, systemReason(error)));
  if (auto own = isFileOfItsOwn(source, target); !own) return tl::unexpected(own.error());
  if (fs::file_size(target, error) == fs::file_size(source, error) && !error) {
    // Whoever copied it may have been interrupted before it was on the storage, and the source is about to go.
    const File copy(target, O_RDONLY);
    if (!copy || fsync(copy.get()) != 0) return fail("{}: writing failed: {}", target, reason());
    syncFolder(fs::path(target).parent_path());
    const auto there = hashOf(target);
    const auto here = hashOf(source);
    if (there && here && *there == *here) return true;
  }
  return fail("{}: there is another file of this name; nothing was moved", target);
}

/// @return whether it was there already
Result<bool> copyOnce(const std::string& source, const std::string& target) {
  auto there = alreadyThere(source, target);
  if (!there || *there) return there;
  if (auto copied = copyVerified(source, target); !copied) return tl::unexpected(copied.error());
  return false;
}

}  // namespace

Result<StoredFile> moveFile(const std::string& file, const std::string& folder,
                            const std::function<Result<void>(const std::string&)>& stored) {
  std::error_code error;
  const fs::path source = fs::canonical(file, error);
  if (error) return fail(about(file, systemReason(error)));
  if (!fs::is_regular_file(source, error)) return fail("{}: expected an ordinary file", file);
  const fs::path to = fs::canonical(folder, error);
  if (error) return fail("{}: {}; the recording stays at {}", folder, systemReason(error), source.native());
  if (!fs::is_directory(to, error)) return fail("{}: expected a folder", folder);
  const fs::path target = to / source.filename();
  if (target == source) return fail("{}: already in {}", file, to.native());

  const auto there = copyOnce(source, target);
  if (!there) return fail("{}; the recording stays at {}", there.error().message, source.native());
  StoredFile out{.path = target, .bytes = fs::file_size(target, error), .was_there = *there};
  if (auto ok = stored(target); !ok) {
    return fail("{}; the recording is whole in both places, {} and {}: store it again to finish", ok.error().message,
                source.native(), target.native());
  }
  // Once more: what stands under the target's name may have been replaced since.
  if (auto own = isFileOfItsOwn(source, target); !own) return tl::unexpected(own.error());
  if (unlink(source.c_str()) != 0) {
    return fail("{}: stored, but the source cannot be removed: {}; it is whole in both places", source.native(),
                reason());
  }
  syncFolder(source.parent_path());
  return out;
}

Result<StoredFile> storeClosed(const std::string& file, const std::string& folder, const std::string& catalogue_word) {
  const auto word = parseCatalogueAddress(catalogue_word);
  if (!word) return tl::unexpected(word.error());
  auto entry = readCatalogueEntry(file);
  if (!entry) return tl::unexpected(entry.error());
  if (entry->wholeness == recording::Wholeness::growing)
    return fail("{}: is still being recorded; close it first", file);
  if (entry->wholeness == recording::Wholeness::crashed) {
    return fail("{}: was left behind by a crash; `fyd session recover` makes it whole first", file);
  }
  if (entry->wholeness == recording::Wholeness::damaged) {
    return fail("{}: is damaged; `fyd session recover` keeps what can be proven of it first", file);
  }
  // Opened before anything is copied: if the catalogue were unreachable later, the recording would stay in two places.
  std::optional<Catalogue> catalogue;
  if (word->kind != CatalogueAddress::Kind::none) {
    auto opened = Catalogue::open(catalogue_word);
    if (!opened) return tl::unexpected(opened.error());
    catalogue = std::move(*opened);
  }
  const std::string notes = recording::reviewNotesPath(entry->path);
  std::error_code error;
  auto moved = moveFile(entry->path, folder, [&](const std::string& path) -> Result<void> {
    entry->path = path;
    // Before the recording goes: a move that is interrupted after it cannot be repeated.
    if (fs::exists(notes, error)) {
      const fs::path target = fs::path(path).parent_path() / fs::path(notes).filename();
      if (auto copied = copyOnce(notes, target); !copied) {
        if (!fs::exists(target, error)) return tl::unexpected(copied.error());
        // Such as notes that were corrected after a move was interrupted: nobody but the user knows which hold.
        return fail("{}; of {} and {}, move away the notes that are not needed", copied.error().message, notes,
                    target.native());
      }
    }
    return catalogue ? catalogue->add(*entry) : Result<void>();
  });
  if (!moved || !fs::exists(notes, error)) return moved;
  const auto followed = moveFile(notes, folder, [](const std::string&) -> Result<void> { return {}; });
  if (!followed) return fail("{} is stored, its notes are not: {}", moved->path, followed.error().message);
  return moved;
}

}  // namespace fyd::catalogue
