// Shared by the catalogue's tests: a temporary folder, fake recordings, writers in their own processes.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_scan.h"
#include "tests/child_process.h"

namespace fyd::catalogue {

inline bool unprivileged(const std::function<bool()>& work);

/// A temporary folder which is also this user's $XDG_DATA_HOME.
class CatalogueFolder : public testing::Test {
 protected:
  CatalogueFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "fyd-catalogue-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    setenv("XDG_DATA_HOME", folder_.c_str(), 1);
  }
  ~CatalogueFolder() override {
    unsetenv("XDG_DATA_HOME");
    std::error_code ignored;
    for (const auto& shut : shut_) {
      std::filesystem::permissions(shut, std::filesystem::perms::owner_all, ignored);
    }
    std::filesystem::permissions(folder_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// A folder that nobody but root may look into, until the test ends.
  void makeShutFolder(const std::string& name) {
    shut_.push_back(folder_ / name);
    std::filesystem::create_directories(shut_.back());
    std::filesystem::permissions(shut_.back(), std::filesystem::perms::none);
  }

  /// Lets others read these files and folders of `folder_`. @return whether they can reach them
  [[nodiscard]] bool openToOthers(std::initializer_list<const char*> names) const {
    using std::filesystem::perms;
    for (const char* name : names) {
      std::filesystem::permissions(folder_ / name, perms::others_read | perms::others_exec,
                                   std::filesystem::perm_options::add);
    }
    return unprivileged([&] {
      return std::ranges::all_of(names, [&](const char* name) { return access(path(name).c_str(), R_OK) == 0; });
    });
  }

  std::filesystem::path folder_;

 private:
  std::vector<std::filesystem::path> shut_;
};

inline CatalogueEntry entryOf(const std::string& id) {
  return {.id = id,
          .path = "/data/" + id + ".h5",
          .station = stationName(),
          .started_utc = "2026-11-21T14:05:09.250Z",
          .duration_s = 61.5,
          .operator_name = "Jo",
          .subject = "S07",
          .tags = {"pilot", "Cotton"},
          .notes = "first try",
          .touchpad = "simulated",
          .robot = "none",
          .samples = 61500,
          .gaps = 0,
          .events = 4,
          .wholeness = recording::Wholeness::whole,
          .health = "good",
          .bytes = 1234,
          .file_modified_ns = 1'700'000'000'123'456'789};
}

inline void writeText(const std::string& path, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A fake recording is a text file that holds its id.
inline Result<CatalogueEntry> readMadeUp(const std::string& path) {
  const std::string id = readText(path);
  if (id.empty() || id.size() > 64) return fail("{}: no recording", path);
  CatalogueEntry entry = entryOf(id);
  const auto facts = fileFacts(path);
  if (!facts) return fail("{}: gone", path);
  entry.path = path;
  entry.bytes = facts->bytes;
  entry.file_modified_ns = facts->modified_ns;
  return entry;
}

/// Runs `work` in a child process, which ends with this one at the latest. @return its process id
inline pid_t inProcess(const std::function<bool()>& work) {
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    endWithParent(parent);  // PR_SET_PDEATHSIG
    _exit(work() ? 0 : 1);
  }
  return child;
}

inline bool succeeded(pid_t child) {
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Runs in a process without root's privileges, as root may read and write anywhere.
inline bool unprivileged(const std::function<bool()>& work) {
  const pid_t parent = getpid();
  return succeeded(inProcess([&] {
    if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) return false;
    endWithParent(parent);
    return work();
  }));
}

}  // namespace fyd::catalogue
