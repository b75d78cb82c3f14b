#include "app/console/shell/views.h"

#include <algorithm>

#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"
#include "widgets/devices/cable_text.h"

namespace fyd::console {
namespace {

using widgets::PartView;
using widgets::Severity;

using widgets::tr;
QString text(const std::string& words) { return QString::fromStdString(words); }

QString iconOf(device::Part part) {
  if (part == device::Part::camera) return QStringLiteral("camera");
  if (part == device::Part::robot) return QStringLiteral("robot");
  return QStringLiteral("touchpad");
}

PartView toPart(const device::DeviceReport& part) {
  PartView view{.icon = iconOf(part.part), .name = widgets::coreText(toString(part.part))};
  view.health = part.ok ? PartView::Health::well : PartView::Health::missing;
  view.origin = part.simulated ? PartView::Origin::simulated : PartView::Origin::real;
  view.figures = part.ok ? widgets::rateAndAge(part.rate_hz, part.age_ms) : widgets::coreText(part.problem);
  view.detail = widgets::coreText(part.description);
  if (part.errors > 0) view.detail += QLatin1Char('\n') + tr("%1 errors since the start").arg(part.errors);
  return view;
}

PartView loopPart(const station::LoopStatus& loop, double missed_now, std::uint64_t telemetry_lost) {
  constexpr double kUsualMissed = 5.0;  // 0.5 % of a second's cycles
  PartView view{.icon = QStringLiteral("loop"), .name = tr("Loop")};
  constexpr double kCyclesOfSecond = 1000.0;
  view.figures = loop.waits
                     ? tr("1 kHz · waits for this computer")
                     : tr("1 kHz · %1 % missed").arg(widgets::numberText(100.0 * missed_now / kCyclesOfSecond, 1));
  view.health = missed_now > kUsualMissed ? PartView::Health::doubtful : PartView::Health::well;
  view.detail = tr("%1 steps, %2 cycles missed since the start; a step takes %3 µs (median), %4 µs (99th percentile)")
                    .arg(loop.steps)
                    .arg(loop.missed_cycles)
                    .arg(widgets::numberText(loop.step_ns_p50 / 1000.0, 1))
                    .arg(widgets::numberText(loop.step_ns_p99 / 1000.0, 1));
  view.detail += QLatin1Char('\n') + (loop.real_time ? tr("Real-time priority granted.")
                                                     : tr("No real-time priority: the system may delay the loop."));
  if (loop.waits) {
    view.detail +=
        QLatin1Char('\n') + tr("Everything is simulated: time waits for this computer when it is late, %1 s so "
                               "far, and nothing is Held for it.")
                                .arg(widgets::numberText(loop.waited_s, 1));
  }
  if (telemetry_lost > 0) view.detail += QLatin1Char('\n') + tr("The curves lost %1 samples.").arg(telemetry_lost);
  return view;
}

bool hasLink(const station::LinkStatus& link) { return !link.local.empty(); }

PartView linkPart(const station::LinkStatus& link) {
  PartView view{.icon = QStringLiteral("link"), .name = tr("Link")};
  if (hasLink(link)) view.icon = link.secured ? QStringLiteral("lock") : QStringLiteral("lock-open");
  view.figures = widgets::coreText(link.protocol);
  view.opens = true;
  view.health = PartView::Health::well;
  view.detail = tr("Here: %1\nRobot: %2\n%3 states received, %4 touches sent, %5 datagrams refused")
                    .arg(link.local.empty() ? widgets::kNoValue : text(link.local),
                         link.peer.empty() ? widgets::kNoValue : text(link.peer))
                    .arg(link.states_received)
                    .arg(link.touches_sent)
                    .arg(link.refused);
  if (isWrong(link.scenes)) {
    view.health = PartView::Health::doubtful;
    view.figures = widgets::coreText(protocol::toString(link.scenes));
  }
  view.detail += QLatin1Char('\n') + tr("Click for more.");
  return view;
}

QString conditionOf(pipeline::LinkPhase phase) {
  using enum pipeline::LinkPhase;
  switch (phase) {
    case waiting: return tr("Waiting for a robot");
    case running: return tr("Running");
    case paused: return tr("Paused by the robot");
    case lost: return tr("Lost: the robot is silent");
    case closed: return tr("Closed: the robot has said goodbye");
    case none: break;
  }
  return {};
}

widgets::LinkView::Health healthOf(pipeline::LinkPhase phase) {
  using Health = widgets::LinkView::Health;
  if (phase == pipeline::LinkPhase::lost) return Health::lost;
  const bool speaking = phase == pipeline::LinkPhase::running || phase == pipeline::LinkPhase::paused;
  return speaking ? Health::well : Health::waiting;
}

/// The command that helps with a missing condition; "calibrate:PART" goes to that part's calibration.
struct Mending {
  const char* command = "";
  const char* words = "";
};

/// Where the signal is seen that a fault is about.
const char* signalOf(pipeline::Fault fault) {
  switch (pipeline::infoOf(fault).part) {
    case pipeline::Part::distances: return "calibrate:ir-1";
    case pipeline::Part::load_cell: return "calibrate:load-cell";
    case pipeline::Part::camera: return "calibrate:camera-region";
    default: return "place.calibrate";
  }
}

Mending mendingOf(pipeline::Fault fault) {
  using enum pipeline::Help;
  switch (pipeline::infoOf(fault).help) {
    case devices: return {"place.devices", QT_TRANSLATE_NOOP("Views", "Look at the devices")};
    case signal: return {signalOf(fault), QT_TRANSLATE_NOOP("Views", "Look at its signal")};
    case link: return {"view.link", QT_TRANSLATE_NOOP("Views", "Show the link")};
    case target: return {"session.target_by_hand", QT_TRANSLATE_NOOP("Views", "Set the target by hand")};
    case none: break;
  }
  return {};
}

bool inUse(const std::vector<device::DeviceReport>& devices, device::Part part) {
  return std::ranges::any_of(devices, [&](const auto& each) { return each.part == part && each.in_use; });
}

}  // namespace

QString closedText(bool connecting) {
  return connecting ? tr("Other devices are being connected …")
                    : tr("The session is closed: choose devices under Devices.");
}

QImage toImage(const cv::Mat& picture) {
  if (picture.empty() || picture.depth() != CV_8U) return {};
  const auto stride = static_cast<qsizetype>(picture.step);
  if (picture.channels() == 1) {
    return QImage(picture.data, picture.cols, picture.rows, stride, QImage::Format_Grayscale8).copy();
  }
  if (picture.channels() == 3) {
    return QImage(picture.data, picture.cols, picture.rows, stride, QImage::Format_BGR888).copy();
  }
  return {};
}

widgets::CameraPicture toCameraPicture(const station::CameraView& view) {
  return {.picture = toImage(view.picture),
          .mask = toImage(view.finger_mask),
          .region = QRect(view.region.x, view.region.y, view.region.width, view.region.height),
          .finger = view.finger};
}

std::vector<PartView> toParts(const station::StationStatus& status, double missed_now, std::uint64_t telemetry_lost) {
  std::vector<PartView> out;
  out.reserve(status.parts.size());
  for (const device::DeviceReport& part : status.parts) out.push_back(toPart(part));
  out.push_back(linkPart(status.link));
  out.push_back(loopPart(status.loop, missed_now, telemetry_lost));
  return out;
}

widgets::LinkView toLink(const station::StationStatus& status) {
  const station::LinkStatus& link = status.link;
  widgets::LinkView out{.protocol = widgets::coreText(link.protocol)};
  if (!hasLink(link)) return out;
  const protocol::LinkFigures& figures = link.figures;
  out.condition = conditionOf(link.phase);
  if (isWrong(link.scenes)) {
    QString scenes = widgets::coreText(protocol::toString(link.scenes));
    scenes[0] = scenes[0].toUpper();
    out.condition += QStringLiteral(". ") + scenes;
  }
  out.health = healthOf(link.phase);
  out.security = link.secured ? widgets::LinkView::Security::sealed : widgets::LinkView::Security::open;
  out.local_only = link.local.starts_with("127.") || link.local.starts_with("[::1]");
  out.peer = text(link.peer);
  out.local = text(link.local);
  out.round_trip_ms = figures.round_trip_ms;
  out.jitter_ms = figures.jitter_ms;
  out.loss_percent = figures.loss_percent;
  out.age_ms = figures.silence_ms;
  if (link.led) {
    const auto place = [](const Vec3& p) {
      using widgets::numberText;
      return widgets::rowText({numberText(p.x, 1), numberText(p.y, 1), numberText(p.z, 1)}) + QStringLiteral(" mm");
    };
    out.predictor = text(link.led->predictor);
    out.arrived = place(link.led->arrived_mm);
    out.led = place(link.led->target_mm);
    out.ahead_ms = link.led->horizon_ms;
    out.led_error_mm = link.led->error_mm;
  }
  out.received = link.states_received;
  out.sent = link.touches_sent;
  out.times_lost = figures.lost;
  out.refused = link.refused;
  for (const protocol::RefusalCount& each : figures.refusals) {
    out.refusals.push_back({.reason = widgets::coreText(each.reason), .count = each.count});
  }
  for (const device::DeviceReport& part : status.parts) {
    if (part.part == device::Part::robot && link.states_received > 0) out.rate_hz = part.rate_hz;
  }
  return out;
}

std::vector<widgets::ReadinessRow> toReadiness(const std::vector<station::ReadinessLine>& lines,
                                               const std::vector<device::DeviceReport>& devices,
                                               const ConnectionWords& connection) {
  std::vector<widgets::ReadinessRow> out;
  for (const station::ReadinessLine& line : lines) {
    QString why = widgets::coreText(line.why);
    if (!why.isEmpty()) why[0] = why[0].toUpper();
    QString remedy = widgets::cableRemedy(line.fault, connection);
    if (!remedy.isEmpty() && inUse(devices, widgets::silentPart(line.fault, connection))) {
      const widgets::InUseText text = widgets::inUseText(line.fault, connection);
      why = text.why;
      remedy = text.remedy;
    }
    const Mending mending = mendingOf(line.fault);
    out.push_back({.what = widgets::coreText(line.what),
                   .ok = line.ok,
                   .why = why,
                   .remedy = remedy.isEmpty() ? widgets::coreText(line.remedy) : remedy,
                   .fault = line.fault,
                   .command = QLatin1String(mending.command),
                   .action = *mending.words == '\0' ? QString() : tr(mending.words)});
  }
  return out;
}

Telling tellingOf(const pipeline::Event& e) {
  using enum Severity;
  using pipeline::EventKind, pipeline::SafetyState;
  switch (e.kind) {
#define EVENT(name, number, label, severity, slides_in, weight, said, logged) \
  case EventKind::name:                                                       \
    return {severity, slides_in};
#include "core/pipeline/event_list.h"
#undef EVENT
  }
  return {};
}

}  // namespace fyd::console
