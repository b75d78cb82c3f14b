// Converts the station's structs to the views of the widgets.
#pragma once

#include <QImage>
#include <vector>

#include "app/console/shell/session.h"
#include "core/station/station.h"
#include "widgets/devices/camera_image.h"
#include "widgets/devices/link_panel.h"
#include "widgets/status/notice_stack.h"
#include "widgets/status/part_list.h"
#include "widgets/status/readiness_list.h"

namespace fyd::console {

/// A copy, so that the camera's thread may continue. 8 bit, grey or BGR; anything else gives a null image.
[[nodiscard]] QImage toImage(const cv::Mat& picture);
[[nodiscard]] widgets::CameraPicture toCameraPicture(const station::CameraView& view);
/// @param missed_now cycles missed in the last second
[[nodiscard]] std::vector<widgets::PartView> toParts(const station::StationStatus& status, double missed_now,
                                                     std::uint64_t telemetry_lost);
/// @param connection the session's, to name the cables
/// @param devices of which one may be in use by another program
[[nodiscard]] std::vector<widgets::ReadinessRow> toReadiness(const std::vector<station::ReadinessLine>& lines,
                                                             const std::vector<device::DeviceReport>& devices,
                                                             const ConnectionWords& connection);

/// Why nothing can be done without a session, and what to do.
/// @param connecting another is being opened
[[nodiscard]] QString closedText(bool connecting);

[[nodiscard]] widgets::LinkView toLink(const station::StationStatus& status);

/// How an event is shown to the operator.
struct Telling {
  widgets::Severity severity = widgets::Severity::information;
  bool slides_in = false;  ///< otherwise it only goes to the log
};
[[nodiscard]] Telling tellingOf(const pipeline::Event& event);

}  // namespace fyd::console
