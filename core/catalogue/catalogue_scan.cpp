#include "core/catalogue/catalogue_scan.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

namespace fyd::catalogue {
namespace {

namespace fs = std::filesystem;

template <class Iterator>
void collect(const std::string& folder, std::vector<std::string>& out) {
  std::error_code error;
  Iterator item(folder, fs::directory_options::skip_permission_denied, error);
  while (!error && item != Iterator()) {
    const std::string& path = item->path().native();
    std::error_code unreadable;
    if ((path.ends_with(".h5") || path.ends_with(".h5.partial")) && item->is_regular_file(unreadable)) {
      out.push_back(path);
    }
    item.increment(error);
  }
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

std::vector<std::string> recordingsIn(const std::string& folder, bool deep) {
  std::vector<std::string> out;
  std::error_code error;
  const std::string absolute = fs::weakly_canonical(folder, error);
  if (error) return out;
  if (deep) {
    collect<fs::recursive_directory_iterator>(absolute, out);
  } else {
    collect<fs::directory_iterator>(absolute, out);
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace fyd::catalogue
