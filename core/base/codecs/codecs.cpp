#include "core/base/codecs/codecs.h"

#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <opencv2/videoio.hpp>

#include "core/base/codecs/opencv_codecs.h"

namespace fyd::codecs {
namespace {

namespace fs = std::filesystem;

/// FYD_CODECS, such as lib/x86_64-linux-gnu/fyd/codecs.so, beside the "bin", "lib" or (in a build folder) "python" in
/// which the program or library with this code stands. Looked for nowhere else, and never in the working folder: nobody
/// else's library is to be loaded.
/// @return empty: it stands in none of these
fs::path libraryPath() {
  const fs::path beside = FYD_CODECS;
  Dl_info self{};
  link_map* holder = nullptr;
  const bool known =
      dladdr1(reinterpret_cast<const void*>(&load), &self, reinterpret_cast<void**>(&holder), RTLD_DL_LINKMAP) != 0;
  const bool in_program = !known || holder == nullptr || *holder->l_name == '\0';  // a program has no name there
  std::error_code problem;
  fs::path folder = fs::canonical(in_program ? "/proc/self/exe" : holder->l_name, problem).parent_path();
  for (; folder.has_relative_path(); folder = folder.parent_path()) {
    const fs::path name = folder.filename();
    if (name == "bin" || name == *beside.begin() || name == "python") return folder.parent_path() / beside;
  }
  return {};
}

const OpenCvCodecs& library() {
  static std::mutex mutex;
  static const OpenCvCodecs* found = nullptr;  // stays loaded until the program ends
  const std::lock_guard lock(mutex);
  if (found == nullptr) {
    const std::string path = libraryPath().string();
    void* const handle = path.empty() ? nullptr : dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = handle == nullptr ? nullptr : dlsym(handle, kCodecsSymbol);
    if (symbol == nullptr) {
      const char* const why = dlerror();
      CV_Error(cv::Error::StsError,
               fmt::format("the coders of pictures and videos cannot be loaded: {}",
                           why == nullptr ? "expected " FYD_CODECS " beside the program's folder \"bin\"" : why));
    }
    found = reinterpret_cast<CodecsFunction>(symbol)();
  }
  return *found;
}

}  // namespace

Result<void> load() {
  try {
    static_cast<void>(library());
  } catch (const cv::Exception& problem) {
    return fail(verbatim(problem.err));
  }
  return {};
}

bool encodePicture(const std::string& ending, const cv::Mat& picture, std::vector<std::uint8_t>& coded,
                   const std::vector<int>& parameters) {
  return library().encode(ending, picture, coded, parameters);
}

cv::Mat decodePicture(std::span<const std::uint8_t> bytes, int flags) {
  cv::Mat picture;
  library().decode(cv::Mat(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data())), flags,
                   picture);
  return picture;
}

std::unique_ptr<cv::VideoCapture> videoCapture() { return std::unique_ptr<cv::VideoCapture>(library().capture()); }

std::unique_ptr<cv::VideoWriter> videoWriter(const std::string& path, const std::array<char, 4>& codec, double rate_Hz,
                                             cv::Size size, bool colour) {
  return std::unique_ptr<cv::VideoWriter>(library().writer(path, codec, rate_Hz, size, colour));
}

}  // namespace fyd::codecs
