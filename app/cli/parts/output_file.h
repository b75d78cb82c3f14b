// Files that commands write: regular files, which keep mode and owner, or own descriptors such as /dev/stdout.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/recording/file/export_file.h"

namespace fyd::cli {

/// @param inputs what the command reads, or writes by another option; empty names count for nothing
/// @throws Failure when `path` is one of them, or a recording: to write it would destroy what cannot be had again
void refuseToDestroy(const std::string& path, const std::vector<std::string>& inputs);

/// Replaces a regular file atomically: a reader sees the old or the new one. @throws Failure when it cannot be
/// written, or by refuseToDestroy
void writeTextFile(const std::string& path, const std::string& text, const std::vector<std::string>& inputs = {});

/// Growing: others may read it meanwhile. What stood under its name stays until the first write, or `close`, and a new
/// name without either goes again: what fails before it has a word to write leaves all as it was.
/// Whole: it gets its name with `close`; without, what stood there stays.
enum class Appears { growing, whole };

/// A file that is written while the command runs. An own descriptor is written where it stands: nothing before is lost,
/// and what is printed afterwards follows.
class OutputFile {
 public:
  /// @throws Failure when it cannot be opened, or by refuseToDestroy
  OutputFile(const std::string& path, const std::vector<std::string>& inputs, Appears appears = Appears::growing);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  void write(std::string_view text);
  void flush();
  /// Throws Failure when not everything reached the file.
  void close();
  /// Of a growing file, the first write that failed; empty: none.
  [[nodiscard]] Message problem() const;

 private:
  struct Closer {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
  };

  void begin();
  void note(bool written);

  std::string path_;
  std::optional<recording::ExportFile> part_;  ///< of a file that appears whole
  std::string target_;                         ///< that is really written; empty: an own descriptor
  bool made_ = false;                          ///< it was not there before
  bool begun_ = false;
  std::unique_ptr<std::FILE, Closer> file_;
  int problem_ = 0;  ///< errno of the first write that failed
};

}  // namespace fyd::cli
