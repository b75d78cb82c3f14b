// Events of the step as sentences for the operator.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/parameter.h"
#include "core/base/time.h"
#include "core/pipeline/outputs.h"
#include "core/station/lateness.h"

namespace fyd::station {

/// An event with its time, and as a sentence; or a sentence about the session.
struct Notice {
  Instant when{};
  pipeline::Event event;
  Message message;
  bool of_step = true;  ///< false: about the session, a warning without an event
  Message lateness;     ///< of this computer, where it may be why the state is Held; empty: it was on time
};

/// The station raises it where the link needs it, in this session: what it tells of it does not change the profile.
inline constexpr std::string_view kInputDelay = "texture.input_delay_ms";

/// @param parameters the step's, for the names behind indices
/// @param lateness of this computer in the second before: what went missing then is blamed on it, not on a cable
[[nodiscard]] Message describeEvent(const pipeline::Event& event, std::span<const Parameter> parameters,
                                    const Lateness& lateness = {});

/// What the computer's lateness may have to do with this event, as a phrase; empty: nothing.
[[nodiscard]] Message blameOf(const pipeline::Event& event, const Lateness& lateness);

/// Of a robot's command: "vibration up".
[[nodiscard]] std::string_view toString(pipeline::RobotCommand command);

}  // namespace fyd::station
