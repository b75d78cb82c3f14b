#include "app/cli/parts/output_file.h"

#include "app/cli/parts/command.h"
#include "core/base/write_target.h"
#include "core/station/profile/replace_file.h"

namespace fyd::cli {

void writeTextFile(const std::string& path, const std::string& text) {
  if (!isOwnDescriptor(path)) {
    valueOrFail(station::replaceFile(path, text));
    return;
  }
  std::ofstream out = openForWriting(path);
  if (!(out << text).flush()) throw Failure(say("{}: cannot be written", path));
}

std::ofstream openForWriting(const std::string& path) {
  const std::string target = isOwnDescriptor(path) ? path : valueOrFail(writeTargetOf(path)).path;
  std::ofstream out(target, std::ios::binary);
  if (!out) throw Failure(say("{}: cannot be opened for writing", path));
  return out;
}

}  // namespace fyd::cli
