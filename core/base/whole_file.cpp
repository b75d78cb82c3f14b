#include "core/base/whole_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/base/end_signals.h"
#include "core/base/system_reason.h"

namespace fyd {
namespace {

namespace fs = std::filesystem;

Message tooLarge(const std::string& path, std::uint64_t bytes, std::uint64_t largest_bytes) {
  return say("{}: {} bytes, expected at most {}", path, bytes, largest_bytes);
}

using Block = std::array<char, 65536>;

/// Waits for what is written, and for a signal that asks the program to end, which must not wait for a writer.
Result<std::string> drained(int pipe, const std::string& path, std::uint64_t largest_bytes) {
  std::string text;
  Block block{};
  for (;;) {
    std::array<pollfd, 2> asked{{{pipe, POLLIN, 0}, {endSignalDescriptor(), POLLIN, 0}}};
    if (::poll(asked.data(), asked.size(), -1) < 0 && errno != EINTR) {
      return fail("{}: cannot be read: {}", path, systemReason(errno));
    }
    if (endSignal() != 0) return fail("{}: not read to its end: the program was asked to end", path);
    if (asked[0].revents == 0) continue;
    const ssize_t count = ::read(pipe, block.data(), block.size());
    if (count == 0) return text;
    if (count < 0 && errno != EINTR && errno != EAGAIN)
      return fail("{}: cannot be read: {}", path, systemReason(errno));
    text.append(block.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (text.size() > largest_bytes) return tl::unexpected(Error{tooLarge(path, text.size(), largest_bytes)});
  }
}

Result<std::string> readPipe(const std::string& path, std::uint64_t largest_bytes) {
  // A pipe without a writer opens only so, instead of waiting where no signal is looked at.
  const int pipe = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (pipe < 0) return fail("{}: cannot be read: {}", path, systemReason(errno));
  auto text = drained(pipe, path, largest_bytes);
  ::close(pipe);
  return text;
}

}  // namespace

Result<std::string> readWholeFile(const std::string& path, std::uint64_t largest_bytes, FileKind kind) {
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (!fs::exists(status)) {
    if (!problem) problem = std::make_error_code(std::errc::no_such_file_or_directory);
    return fail("{}: cannot be read: {}", path, systemReason(problem));
  }
  const bool pipe = fs::is_fifo(status) || fs::is_character_file(status);
  if (!fs::is_regular_file(status) && !(pipe && kind == FileKind::pipe_too)) {
    return fail("{}: cannot be read: it is no file", path);
  }
  if (pipe) return readPipe(path, largest_bytes);
  // Checked first, so that nothing is read of a file that is refused anyway.
  const std::uint64_t size = fs::file_size(path, problem);
  if (!problem && size > largest_bytes) return tl::unexpected(Error{tooLarge(path, size, largest_bytes)});

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail("{}: cannot be read: {}", path, systemReason(errno));
  std::string text;
  Block block{};
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_bytes) return tl::unexpected(Error{tooLarge(path, text.size(), largest_bytes)});
  }
  if (file.bad()) return fail("{}: cannot be read: {}", path, systemReason(errno));
  return text;
}

}  // namespace fyd
