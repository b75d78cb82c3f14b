#include "core/station/profile/replace_file.h"

#include "core/base/whole_file.h"
#include "core/recording/file/export_file.h"

namespace fyd::station {

Result<void> replaceFile(const std::string& path, std::string_view text) {
  auto file = recording::ExportFile::create(path, true);
  if (!file) return tl::unexpected(file.error());
  if (auto written = file->write(text); !written) return written;
  return file->commit();
}

}  // namespace fyd::station
