#include "app/cli/parts/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

#include "app/cli/parts/command.h"
#include "core/base/system_reason.h"
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

/// With all that stands in it.
/// @param made whether it was not there
std::FILE* openWhole(const std::string& path, bool& made) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_CLOEXEC;
  constexpr mode_t kMode = 0666;
  int descriptor = ::open(path.c_str(), kFlags | O_EXCL, kMode);
  made = descriptor >= 0;
  if (!made) descriptor = ::open(path.c_str(), kFlags, kMode);
  if (descriptor < 0) return nullptr;
  std::FILE* file = ::fdopen(descriptor, "wb");
  if (file == nullptr) ::close(descriptor);
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

OutputFile::OutputFile(const std::string& path, const std::vector<std::string>& inputs, Appears appears) : path_(path) {
  refuseToDestroy(path, inputs);
  if (isOwnDescriptor(path)) {
    file_.reset(openDescriptor(path));
  } else if (appears == Appears::whole) {
    part_.emplace(valueOrFail(recording::ExportFile::create(path, true)));
    return;
  } else {
    target_ = valueOrFail(writeTargetOf(path)).path;
    file_.reset(openWhole(target_, made_));
  }
  if (!file_) throw Failure(say("{}: cannot be opened for writing", path));
}

OutputFile::~OutputFile() {
  if (made_ && !begun_) ::unlink(target_.c_str());
}

void OutputFile::begin() {
  if (std::exchange(begun_, true) || target_.empty()) return;
  note(::ftruncate(::fileno(file_.get()), 0) == 0);
}

void OutputFile::note(bool written) {
  if (!written && problem_ == 0) problem_ = errno != 0 ? errno : EIO;
}

void OutputFile::write(std::string_view text) {
  if (part_) return valueOrFail(part_->write(text));
  begin();
  note(std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size());
}

void OutputFile::flush() {
  if (!part_) note(std::fflush(file_.get()) == 0);
}

void OutputFile::close() {
  if (part_) return valueOrFail(part_->commit());
  begin();
  note(std::fclose(file_.release()) == 0);
  if (problem_ != 0) throw Failure(problem());
}

Message OutputFile::problem() const {
  return problem_ == 0 ? Message{} : say("{}: writing failed: {}", path_, systemReason(problem_));
}

}  // namespace fyd::cli
