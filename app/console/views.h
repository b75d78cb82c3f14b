// From the station's structs to what the widgets show.
#pragma once

#include <QImage>
#include <vector>

#include "core/station/station.h"
#include "widgets/camera_image.h"
#include "widgets/link_panel.h"
#include "widgets/notice_stack.h"
#include "widgets/part_list.h"
#include "widgets/readiness_list.h"

namespace fyd::console {

/// A picture of our own, so that the camera's thread may go on. 8 bit, grey or BGR; anything else gives a null image.
[[nodiscard]] QImage toImage(const cv::Mat& picture);
[[nodiscard]] widgets::CameraPicture toCameraPicture(const station::CameraView& view);
/// @param missed_now cycles missed in the last second
[[nodiscard]] std::vector<widgets::PartView> toParts(const station::StationStatus& status, double missed_now,
                                                     std::uint64_t telemetry_lost);
[[nodiscard]] std::vector<widgets::ReadinessRow> toReadiness(const std::vector<station::ReadinessLine>& lines);

[[nodiscard]] widgets::LinkView toLink(const station::StationStatus& status);

/// How loudly an event is told.
struct Telling {
  widgets::Severity severity = widgets::Severity::information;
  bool slides_in = false;  ///< otherwise it only goes to the log
};
[[nodiscard]] Telling tellingOf(const pipeline::Event& event);

}  // namespace fyd::console
