#include "core/base/whole_file.h"

#include <filesystem>
#include <fstream>

#include "core/base/system_reason.h"

namespace fyd {
namespace {

namespace fs = std::filesystem;

Message tooLarge(const std::string& path, std::uint64_t bytes, std::uint64_t largest_bytes) {
  return say("{}: {} bytes, expected at most {}", path, bytes, largest_bytes);
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
  // Checked first, so that nothing is read of a file that is refused anyway.
  const std::uint64_t size = pipe ? 0 : fs::file_size(path, problem);
  if (!pipe && !problem && size > largest_bytes) return tl::unexpected(Error{tooLarge(path, size, largest_bytes)});

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail("{}: cannot be read: {}", path, systemReason(errno));
  std::string text;
  std::array<char, 65536> block{};
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_bytes) return tl::unexpected(Error{tooLarge(path, text.size(), largest_bytes)});
  }
  if (file.bad()) return fail("{}: cannot be read: {}", path, systemReason(errno));
  return text;
}

}  // namespace fyd
