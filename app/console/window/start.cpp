#include "app/console/window/start.h"

#include <QDir>
#include <QFileInfo>

namespace fyd::console {
namespace {

/// Whether an option says what the session is made of.
bool namesDevices(const Options& options) {
  const station::StationOptions& named = options.station;
  for (const std::string* word : {&named.touchpad, &named.motors, &named.camera, &named.robot, &named.key_file,
                                  &named.scene, &named.surface, &named.finger_csv}) {
    if (!word->empty()) return true;
  }
  return !options.profile.isEmpty() || named.record.has_value();
}

}  // namespace

Result<Start> readStart(const Options& options, const QString& profile_path, const WindowMemory& memory) {
  Start start{.station = options.station};
  // Screenshots for the manual show the defaults, whatever the operator saved.
  const bool own = options.profile.isEmpty();
  const bool standard = options.standardWindow();
  const bool there = QFileInfo::exists(profile_path);
  // The claim of the first window needs the profile's folder, which a first start has not made yet.
  if (own && !standard) (void)QDir().mkpath(QFileInfo(profile_path).absolutePath());
  if (!standard || !own) start.station.profile_file = profile_path.toStdString();
  if (!own || (!standard && there)) {
    auto loaded = station::loadProfile(profile_path.toStdString());
    if (loaded) {
      start.station.profile = *loaded;
    } else if (namesDevices(options)) {
      return tl::unexpected(loaded.error());
    } else {
      start.damaged_profile = loaded.error().message;
    }
  }
  const auto devices = memory.devices();
  if (devices && own) start.station.profile.sources = *devices;
  start.devices_remembered = !standard && !namesDevices(options);
  start.first = start.devices_remembered && !there && !devices && !memory.firstStepsOver();
  return start;
}

Result<OpenedStart> openStart(const Start& start) {
  if (!start.damaged_profile.empty()) return OpenedStart{.session = closedSession(start.station), .missing = {}};
  auto session = openSession(start.station);
  if (session) return OpenedStart{.session = std::move(*session), .missing = {}};
  if (!start.devices_remembered) return tl::unexpected(session.error());
  return OpenedStart{.session = closedSession(start.station), .missing = session.error().message};
}

}  // namespace fyd::console
