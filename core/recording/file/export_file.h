// A file that appears whole or not at all: written under a temporary name in its folder, synced, renamed. It goes to a
// regular file only, through links to their end, and keeps the mode and the owner of the file it replaces.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/write_target.h"
#include "core/recording/file/export_part.h"

namespace fyd::recording {

class ExportFile {
 public:
  /// Removes first what killed programs left in the folder.
  /// @return an error when the folder cannot be written, `path` is no file, or exists and may not be replaced
  [[nodiscard]] static Result<ExportFile> create(const std::string& path, bool replace);
  ExportFile(ExportFile&& other) noexcept;
  ExportFile& operator=(ExportFile&&) = delete;
  ~ExportFile();  ///< without `commit`: nothing is left behind

  /// The name to write to meanwhile, with the same extension; exists, empty.
  [[nodiscard]] const std::string& temporary() const { return temporary_; }
  [[nodiscard]] Result<void> write(std::string_view bytes);
  /// Syncs, then gives the file its name.
  [[nodiscard]] Result<void> commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  ExportFile(std::string path, WriteTarget target, ExportPart part, bool replace);
  [[nodiscard]] Result<void> syncPart() const;
  [[nodiscard]] tl::unexpected<Error> failed(int error) const;

  std::string path_;  ///< as the caller calls it
  WriteTarget target_;
  std::string temporary_;  ///< empty: renamed, or moved to another ExportFile
  int lock_ = -1;          ///< flock on the part file; held while this program runs
  bool replace_ = false;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace fyd::recording
