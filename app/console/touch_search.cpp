#include "app/console/touch_search.h"

#include <memory>

namespace fyd::console {
namespace {

using Touches = Result<std::vector<session::Touch>>;

Touches touchesOf(const std::string& path) {
  auto recording = session::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  return session::findTouches(**recording);
}

}  // namespace

void TouchSearch::look(const QString& path, Found found) {
  work_.run([path = path.toStdString(), found = std::move(found)](const std::stop_token&) -> Background::Finish {
    const auto touches = std::make_shared<Touches>(touchesOf(path));
    return [touches, found] { found(*touches); };
  });
}

}  // namespace fyd::console
