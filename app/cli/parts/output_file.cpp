#include "app/cli/parts/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/cli/parts/command.h"
#include "core/base/write_target.h"
#include "core/station/profile/replace_file.h"

namespace fyd::cli {
namespace {

/// Of a name that isOwnDescriptor; -1: none.
int descriptorOf(const std::string& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  const std::string_view number = std::string_view(path).substr(path.rfind('/') + 1);
  int descriptor = -1;
  const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), descriptor);
  return problem == std::errc() && end == number.data() + number.size() ? descriptor : -1;
}

/// A copy, which shares the place in the file with the original.
std::FILE* openDescriptor(const std::string& path) {
  std::cout.flush();
  const int copy = ::fcntl(descriptorOf(path), F_DUPFD_CLOEXEC, 0);
  if (copy < 0) return nullptr;
  std::FILE* file = ::fdopen(copy, "wb");
  if (file == nullptr) ::close(copy);
  return file;
}

/// Also of a file that does not exist yet.
bool sameFile(const std::string& one, const std::string& other) {
  namespace fs = std::filesystem;
  std::error_code none;
  if (fs::equivalent(one, other, none)) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(one, none), none);
  return !first.empty() && first == fs::weakly_canonical(fs::absolute(other, none), none);
}

/// By its name, or by its first bytes: HDF5 may begin at 0, 512 and each double of that.
bool isRecording(const std::string& path) {
  if (path.ends_with(".h5") || path.ends_with(".h5.partial")) return true;
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  constexpr std::streamoff kFirst = 512, kLast = 1 << 20;
  std::ifstream file(path, std::ios::binary);
  for (std::streamoff at = 0; at <= kLast; at = at == 0 ? kFirst : 2 * at) {
    std::array<char, kSignature.size()> begin{};
    if (!file.seekg(at) || !file.read(begin.data(), begin.size())) return false;
    if (std::ranges::equal(begin, kSignature)) return true;
  }
  return false;
}

}  // namespace

void refuseToDestroy(const std::string& path, const std::vector<std::string>& inputs) {
  if (isOwnDescriptor(path)) return;
  for (const std::string& input : inputs) {
    if (input.empty() || !sameFile(path, input)) continue;
    throw Failure(say("{}: this command uses that file already, it would be lost; choose another name", path));
  }
  if (isRecording(path)) {
    throw Failure(say("{}: is, or is named as, a recording, which nothing overwrites; choose another name", path));
  }
}

void writeTextFile(const std::string& path, const std::string& text, const std::vector<std::string>& inputs) {
  if (!isOwnDescriptor(path)) {
    refuseToDestroy(path, inputs);
    valueOrFail(station::replaceFile(path, text));
    return;
  }
  OutputFile out(path, inputs);
  out.write(text);
  out.close();
}

OutputFile::OutputFile(const std::string& path, const std::vector<std::string>& inputs) : path_(path) {
  refuseToDestroy(path, inputs);
  file_.reset(isOwnDescriptor(path) ? openDescriptor(path)
                                    : std::fopen(valueOrFail(writeTargetOf(path)).path.c_str(), "wbe"));
  if (!file_) throw Failure(say("{}: cannot be opened for writing", path));
}

void OutputFile::write(std::string_view text) {
  whole_ = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() && whole_;
}

void OutputFile::flush() { whole_ = std::fflush(file_.get()) == 0 && whole_; }

void OutputFile::close() {
  whole_ = std::fclose(file_.release()) == 0 && whole_;
  if (!whole_) throw Failure(say("{}: writing failed; is the disk full?", path_));
}

}  // namespace fyd::cli
