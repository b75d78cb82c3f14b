// What is said of a device: before its first answer, while it answers, complains, fails and is silent.
#include "core/device/part_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/device/in_use.h"

namespace fyd::device {
namespace {

Instant at(double seconds) { return Instant{} + fromSeconds(1000.0 + seconds); }

TEST(PartMonitor, WaitsForTheFirstAnswer) {
  const PartMonitor monitor(Part::camera, verbatim("/dev/video0"));
  const DeviceReport report = monitor.report(at(0));
  EXPECT_EQ(report.part, Part::camera);
  EXPECT_EQ(report.description.text(), "/dev/video0");
  EXPECT_FALSE(report.ok);
  EXPECT_EQ(report.problem.text(), "nothing received yet");
  EXPECT_TRUE(std::isnan(report.age_ms));
  EXPECT_EQ(report.rate_hz, 0.0);
}

TEST(PartMonitor, TellsAgeSilenceAndEndOfSilence) {
  PartMonitor monitor(Part::touchpad, {}, std::chrono::milliseconds(500));
  for (int i = 0; i <= 1000; ++i) EXPECT_FALSE(monitor.succeeded(at(0.001 * i)));
  EXPECT_TRUE(monitor.report(at(1.4)).ok);
  EXPECT_NEAR(monitor.report(at(1.4)).age_ms, 400.0, 1e-6);
  EXPECT_NEAR(monitor.report(at(1.4)).rate_hz, 1000.0, 20.0);
  EXPECT_EQ(monitor.problem(at(1.6)).text(), "silent; is it plugged in and switched on?");
  EXPECT_EQ(monitor.report(at(3.1)).rate_hz, 0.0);
  monitor.succeeded(at(3.2));
  EXPECT_TRUE(monitor.report(at(3.2)).ok);
  EXPECT_EQ(monitor.report(at(3.2)).errors, 0U);
}

TEST(PartMonitor, KnowsThatAnotherProgramHasIt) {
  PartMonitor monitor(Part::touchpad, {});
  monitor.failed(about("modbus-tcp:10.0.0.7:502", phrase(kDrivenElsewhere)));
  EXPECT_TRUE(monitor.report(at(0)).in_use);
  monitor.failed(listed({verbatim("silent"), portInUse("/dev/ttyUSB0")}));  // of a touchpad of two halves
  EXPECT_TRUE(monitor.report(at(0)).in_use);
  monitor.failed(verbatim("no answer"));
  EXPECT_FALSE(monitor.report(at(0)).in_use);
  monitor.failed(phrase(kDrivenElsewhere));
  monitor.succeeded(at(1));
  EXPECT_FALSE(monitor.report(at(1)).in_use);
}

TEST(PartMonitor, TellsAComplaintThatDoesNotTouchWhatIsMeasured) {
  PartMonitor monitor(Part::touchpad, {});
  monitor.succeeded(at(0), verbatim("too hot"));
  EXPECT_FALSE(monitor.report(at(0)).measures);
  monitor.succeeded(at(1), verbatim("motors off"), true);
  EXPECT_FALSE(monitor.report(at(1)).ok);
  EXPECT_TRUE(monitor.report(at(1)).measures);
  monitor.failed(verbatim("no answer"));
  EXPECT_FALSE(monitor.report(at(1)).measures);
}

TEST(PartMonitor, CountsFailuresAndEachNewComplaintOnce) {
  PartMonitor monitor(Part::robot, {});
  EXPECT_TRUE(monitor.failed(verbatim("no answer")));
  EXPECT_FALSE(monitor.failed(verbatim("no answer")));
  EXPECT_EQ(monitor.report(at(0)).errors, 2U);
  EXPECT_TRUE(monitor.succeeded(at(0), verbatim("too hot")));
  EXPECT_FALSE(monitor.succeeded(at(0.1), verbatim("too hot")));
  EXPECT_EQ(monitor.report(at(0.1)).errors, 3U);
  EXPECT_EQ(monitor.report(at(0.1)).problem.text(), "too hot");
  monitor.succeeded(at(0.2));
  EXPECT_TRUE(monitor.report(at(0.2)).ok);
}

}  // namespace
}  // namespace fyd::device
