#include "core/catalogue/catalogue_scan.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/base/system_reason.h"

namespace fyd::catalogue {
namespace {

namespace fs = std::filesystem;

/// Folders of the operating system, found on many disks: nobody keeps recordings there.
constexpr std::string_view kSystemFolders[] = {"lost+found", "System Volume Information", "$RECYCLE.BIN"};
constexpr std::string_view kWasteOfAUser = ".Trash-";  // and the user's number

bool isTheSystems(const std::string& folder) {
  const std::string name = fs::path(folder).filename();
  return name.starts_with(kWasteOfAUser) || std::ranges::find(kSystemFolders, name) != std::end(kSystemFolders);
}

bool isRecording(const std::string& path) { return path.ends_with(".h5") || path.ends_with(".h5.partial"); }

/// One folder's recordings; the folders in it go to `below`.
/// @return why it could not be read to its end
std::error_code list(const std::string& folder, FoundRecordings& out, std::vector<std::string>& below) {
  std::error_code error;
  fs::directory_iterator item(folder, error);
  for (; !error && item != fs::directory_iterator(); item.increment(error)) {
    const std::string& path = item->path().native();
    std::error_code unreadable;
    if (item->is_directory(unreadable) && !item->is_symlink(unreadable)) {
      below.push_back(path);
    } else if (isRecording(path) && item->is_regular_file(unreadable)) {
      out.files.push_back(path);
    }
  }
  const bool none = error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
  return none ? std::error_code() : error;
}

}  // namespace

std::optional<FileFacts> fileFacts(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileFacts{static_cast<std::uint64_t>(status.st_size),
                   status.st_mtim.tv_sec * 1'000'000'000LL + status.st_mtim.tv_nsec};
}

bool isUnchanged(const CatalogueEntry& entry, const FileFacts& facts) {
  return entry.bytes == facts.bytes && entry.file_modified_ns == facts.modified_ns;
}

FoundRecordings recordingsIn(const std::string& folder, bool deep) {
  FoundRecordings out;
  std::error_code error;
  const std::string absolute = fs::weakly_canonical(folder, error);
  if (error) {
    out.problems.push_back(about(folder, systemReason(error)));
    return out;
  }
  // Each folder by itself: one that cannot be read costs what is in it, not the search.
  std::vector<std::string> waiting = {absolute};
  while (!waiting.empty()) {
    const std::string next = std::move(waiting.back());
    waiting.pop_back();
    std::vector<std::string> below;
    const std::error_code unread = list(next, out, below);
    const bool left_out = next != absolute && unread == std::errc::permission_denied && isTheSystems(next);
    if (unread && !left_out) out.problems.push_back(about(next, systemReason(unread)));
    if (deep) waiting.insert(waiting.end(), below.begin(), below.end());
  }
  std::ranges::sort(out.files);
  return out;
}

}  // namespace fyd::catalogue
