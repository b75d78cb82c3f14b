#include "widgets/devices/cable_text.h"

#include "core/device/stable_name.h"
#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

/// What follows `prefix` in a source's word; empty where it is another kind of source.
QString addressAfter(const std::string& source, std::string_view prefix) {
  return source.starts_with(prefix) ? QString::fromStdString(source.substr(prefix.size())) : QString();
}

QString touchpadRemedy(const std::string& source) {
  if (const QString at = addressAfter(source, "modbus-tcp:"); !at.isEmpty()) {
    return tr("Check the touchpad's power and its network cable to %1.").arg(at);
  }
  if (const QString at = addressAfter(source, "modbus-rtu:"); !at.isEmpty()) {
    return tr("Check the touchpad's power and its serial cable at %1.").arg(at);
  }
  return {};
}

QString motorRemedy(const std::string& source) {
  const QString at = addressAfter(source, "qbmove:");
  return at.isEmpty() ? QString() : tr("Check the motor board's power and its serial cable at %1.").arg(at);
}

QString cameraRemedy(const std::string& source) {
  const QString at = QString::fromStdString(device::withoutSecrets(source));
  if (at.contains(QLatin1String("://")))
    return tr("Check the network cable and what sends the pictures at %1.").arg(at);
  bool number = false;
  static_cast<void>(at.toInt(&number));
  if (number || at.startsWith(QLatin1String("/dev/")) || at.startsWith(QLatin1String("id="))) {
    return tr("Check the cable of the camera %1, or choose another source.").arg(at);
  }
  return {};
}

QString robotRemedy(const std::string& source) {
  for (const std::string_view protocol : {"link:", "classic:"}) {
    if (const QString at = addressAfter(source, protocol); !at.isEmpty()) {
      return tr("Check the network cable and the robot's program; it is awaited at %1.").arg(at);
    }
  }
  return {};
}

}  // namespace

QString cableRemedy(pipeline::Fault fault, const station::SourceParameters& words) {
  using enum pipeline::Fault;
  switch (fault) {
    case motors_stale: return words.motors.empty() ? touchpadRemedy(words.touchpad) : motorRemedy(words.motors);
    case ir_stale:
    case bridge_stale: return touchpadRemedy(words.touchpad);
    case camera_stale: return cameraRemedy(words.camera);
    case robot_lost: return robotRemedy(words.robot);
    default: return {};
  }
}

device::Part silentPart(pipeline::Fault fault, const station::SourceParameters& words) {
  const bool board = fault == pipeline::Fault::motors_stale && !words.motors.empty();
  return board ? device::Part::motor_board : device::Part::touchpad;
}

InUseText inUseText(pipeline::Fault fault, const station::SourceParameters& words) {
  const bool board = silentPart(fault, words) == device::Part::motor_board;
  const std::string& source = board ? words.motors : words.touchpad;
  const QString at = QString::fromStdString(source.substr(source.find(':') + 1));
  return {.why = board ? tr("Another program has the motor board") : tr("Another program drives the touchpad"),
          .remedy = tr("Close what has it at %1, such as another console; this one then takes it by itself.").arg(at)};
}

}  // namespace fyd::widgets
