#include "core/protocol/link/link_key_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/system_reason.h"

namespace fyd::protocol {
namespace {

constexpr std::size_t kMaximumKeyFile = 4'096;

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] int get() const { return descriptor_; }

 private:
  int descriptor_;
};

Message reason() { return systemReason(errno); }

}  // namespace

Result<LinkKey> readKeyFile(const std::string& path) {
  // Opening a pipe must not block before it is refused.
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat state {};
  if (file.get() < 0 || ::fstat(file.get(), &state) != 0) return fail("key file {}: {}", path, reason());
  if (!S_ISREG(state.st_mode)) return fail("key file {}: not a regular file", path);
  if ((state.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return fail("key file {}: open to others (mode {:04o}); make it private with: chmod 600 {}", path,
                state.st_mode & 07777U, path);
  }
  SecretBytes<kMaximumKeyFile> text;
  std::size_t size = 0;
  while (size < kMaximumKeyFile) {
    const ssize_t got = ::read(file.get(), text.data() + size, kMaximumKeyFile - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail("key file {}: {}", path, reason());
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size == kMaximumKeyFile) return fail("key file {}: longer than {} bytes; not a key", path, kMaximumKeyFile - 1);
  return LinkKey::parseFile({reinterpret_cast<const char*>(text.data()), size}, path);
}

Result<void> writeKeyFile(const LinkKey& key, const std::string& path) {
  const File file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR));
  if (file.get() < 0) {
    return errno == EEXIST ? fail("key file {}: exists already; a key is never overwritten", path)
                           : fail("key file {}: {}", path, reason());
  }
  std::string text = key.fileText();
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t put = ::write(file.get(), text.data() + done, text.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) break;
    done += static_cast<std::size_t>(put);
  }
  const bool whole = done == text.size() && ::fsync(file.get()) == 0;
  const Message problem = whole ? Message{} : reason();
  wipe(text);
  if (whole) return {};
  ::unlink(path.c_str());
  return fail("key file {}: {}", path, problem);
}

}  // namespace fyd::protocol
