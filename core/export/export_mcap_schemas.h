// The JSON Schemas of the MCAP channels. Viewers know foxglove.CompressedImage and foxglove.Log by their names.
#pragma once

#include <span>
#include <string>

#include "core/pipeline/telemetry.h"

namespace fyd::exports {

[[nodiscard]] std::string telemetrySchema(std::span<const pipeline::TelemetryField* const> fields);
[[nodiscard]] std::string linkSchema();
[[nodiscard]] std::string pictureSchema();
[[nodiscard]] std::string logSchema();

}  // namespace fyd::exports
