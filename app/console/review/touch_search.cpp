#include "app/console/review/touch_search.h"

#include <QFileInfo>
#include <memory>

namespace fyd::console {
namespace {

using Touches = Result<std::vector<exports::Touch>>;

Touches touchesOf(const std::string& path, const recording::Progress& progress) {
  auto recording = recording::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  return exports::findTouches(**recording, progress);
}

}  // namespace

void TouchSearch::look(const QString& path, Found found) {
  work_.run(tr("Looking for touches in %1").arg(QFileInfo(path).fileName()),
            [path = path.toStdString(), found = std::move(found)](const recording::Progress& progress) {
              const auto touches = std::make_shared<Touches>(guarded([&] { return touchesOf(path, progress); }));
              return [touches, found] { found(*touches); };
            });
}

}  // namespace fyd::console
