// What the devices read back, line by line, from the step's newest sample and the devices' own reports.
#pragma once

#include <vector>

#include "core/device/device_report.h"
#include "core/pipeline/telemetry.h"
#include "widgets/tuning/tuning_model.h"
#include "widgets/tuning/tuning_readback.h"

namespace fyd::console {

/// Live parameters are held by the step, the stretch by the motors (read by their encoders), a camera's controls by its
/// driver.
[[nodiscard]] std::vector<widgets::ReadbackLine> readbackLines(const widgets::TuningModel& model,
                                                               const pipeline::TelemetrySample& newest,
                                                               const std::vector<device::DeviceReport>& reports);

}  // namespace fyd::console
