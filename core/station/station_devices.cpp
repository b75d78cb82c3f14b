// The station's side of the devices page: reports of all devices, and tests of the motors.
#include <spdlog/spdlog.h>

#include "core/station/station_impl.h"

namespace fyd::station {

std::vector<device::DeviceReport> Station::devices() const {
  const Instant now = Clock::now();
  std::vector<device::DeviceReport> out = impl_->touchpad.reports(now);
  out.push_back(impl_->camera.report(now));
  return out;
}

Result<void> Station::startDeviceTest(device::DeviceTest test, double stretch_deg) {
  auto started = impl_->device_test.start(test, Clock::now(), stretch_deg);
  if (started) spdlog::info("Device test '{}' started", device::kDeviceTestNames[static_cast<std::size_t>(test)]);
  return started;
}

void Station::keepDeviceTest() { impl_->device_test.keep(Clock::now()); }

void Station::stopDeviceTest() { impl_->device_test.stop(); }

DeviceTestStatus Station::deviceTestStatus() const { return impl_->device_test.status(); }

std::vector<texture::SweepRow> Station::deviceTestSweep() { return impl_->device_test.sweep(); }

}  // namespace fyd::station
