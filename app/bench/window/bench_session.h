// A fake session with the highest data rate: first a minute of samples at once, then 1000 samples a second with every
// quantity changing, and 30 pictures a second. Producing them costs the window's thread almost nothing.
#pragma once

#include <chrono>
#include <cmath>
#include <opencv2/core.hpp>

#include "app/bench/window/bench_parts.h"
#include "app/console/shell/session.h"

namespace fyd::console::bench {

constexpr float kBusySpike_N = 9.0F;

/// Sample number `index`, one each millisecond. One in 5000 has a spike of one sample in the force.
inline pipeline::TelemetrySample busySample(std::int64_t index, Instant now) {
  pipeline::TelemetrySample s;
  const double t_s = 1e-3 * static_cast<double>(index);
  const double fast = std::sin(800.0 * t_s) + 0.3 * std::sin(2100.0 * t_s);
  s.now = now;
  s.step = static_cast<std::uint64_t>(index) + 1;
  s.state = pipeline::SafetyState::active;
  s.contact = true;
  s.force_N = index % 5000 == 1234 ? kBusySpike_N : 2.0 + std::sin(3.0 * t_s) + 0.05 * fast;
  s.indentation_mm = 4.0 + 2.0 * std::sin(3.0 * t_s) + 0.02 * fast;
  s.stiffness_observable = true;
  s.stiffness_N_per_mm = 0.5 + 0.1 * std::sin(t_s) + 0.01 * fast;
  s.target_N_per_mm = 0.5 + 0.1 * std::floor(std::fmod(t_s, 3.0));
  s.reachable_target_N_per_mm = std::min(s.target_N_per_mm, 0.65);
  s.stretch_reference_deg = 30.0 * std::sin(t_s);
  s.stretch_measured_deg = 30.0 * std::sin(t_s - 0.02) + 0.1 * fast;
  s.translation_measured_deg = 5.0 * std::sin(0.5 * t_s);
  s.acceleration_x_g = 0.5 * fast;
  s.acceleration_y_g = 0.3 * std::sin(1200.0 * t_s);
  s.acceleration_z_g = 1.0 + 0.2 * fast;
  s.texture_signal_g = 0.5 * fast;
  s.vibration_duty_percent = 60.0 * fast / 1.3;
  s.bridge_age_ms = s.ir_age_ms = s.motors_age_ms = s.robot_age_ms = s.finger_age_ms = 4.0;
  return s;
}

class BusySession : public Session {
 public:
  static constexpr std::int64_t kBefore = 60'000;  ///< samples at once

  void start() override {}
  void shutDown() override {}
  bool command(const pipeline::OperatorCommand&) override { return true; }
  void requestStop() override { stopped_ms.push_back(now_ms()); }
  void windowAlive() override {}
  Result<void> setParameter(std::string_view, double) override { return {}; }
  station::Profile currentProfile() const override { return {}; }
  std::size_t takeTelemetry(std::span<pipeline::TelemetrySample> out) override {
    const auto due = kBefore + static_cast<std::int64_t>(now_ms() - begun_ms_);
    std::size_t taken = 0;
    for (; taken < out.size() && next_ < due; ++taken, ++next_) {
      out[taken] = busySample(next_, instantAt(1e-3 * (begun_ms_ + static_cast<double>(next_ - kBefore))));
    }
    return taken;
  }
  [[nodiscard]] double newest_ms() const { return begun_ms_ + static_cast<double>(next_ - 1 - kBefore); }
  std::uint64_t telemetryLost() const override { return 0; }
  std::vector<station::Notice> takeNotices() override { return {}; }
  station::CameraView cameraView() const override {
    constexpr double kPicture_ms = 1000.0 / 30.0;
    const auto number = static_cast<std::uint64_t>((now_ms() - begun_ms_) / kPicture_ms) + 1;
    return {.picture = pictures_[number % pictures_.size()],
            .finger_mask = {},
            .region = {80, 60, 480, 360},
            .finger = {},
            .number = number};
  }
  station::StationStatus status() const override {
    return {.parts = {{.part = device::Part::touchpad, .ok = true, .rate_hz = 250},
                      {.part = device::Part::camera, .ok = true, .rate_hz = 30}},
            .loop = {},
            .link = {}};
  }
  std::vector<station::ReadinessLine> readiness() const override {
    return {{.what = say("Motors answer"), .ok = true}};
  }
  std::vector<device::DeviceReport> devices() const override { return {}; }
  Result<void> startDeviceTest(device::DeviceTest, double) override { return {}; }
  void keepDeviceTest() override {}
  void stopDeviceTest() override {}
  station::DeviceTestStatus deviceTestStatus() const override { return {}; }
  std::vector<texture::SweepRow> deviceTestSweep() override { return {}; }
  Result<void> startRecording(const recording::RecordingRequest&) override { return {}; }
  Result<void> stopRecording() override { return {}; }
  Result<void> note(recording::NoteKind, const std::string&) override { return {}; }
  recording::RecorderStatus recorderStatus() const override { return {}; }
  void moveSimulatedFinger(double, double, double) override {}
  void releaseSimulatedFinger() override {}
  void playSimulatedFinger(const sim::FingerPath&) override {}
  std::string fingerFile() const override { return {}; }
  bool simulated() const override { return true; }
  std::shared_ptr<scene::SceneStage> scene() const override { return nullptr; }
  ConnectionWords connection() const override { return {}; }
  Check checkOf(const ConnectionWords&) const override {
    return [] { return std::vector<station::ConnectionProblem>(); };
  }
  std::function<Arrival()> leaveFor(const ConnectionWords&) override {
    return [] { return [] { return Result<void>(); }; };
  }
  Result<void> beginAnew(const station::Profile&) override { return {}; }
  bool isOpen() const override { return true; }

  std::vector<double> stopped_ms;  ///< when the stop arrived here

 private:
  static std::vector<cv::Mat> noisyPictures() {
    std::vector<cv::Mat> out(8);
    for (cv::Mat& picture : out) {
      picture.create(480, 640, CV_8UC3);
      cv::randu(picture, 0, 255);
    }
    return out;
  }
  double begun_ms_ = now_ms();
  std::int64_t next_ = 0;
  std::vector<cv::Mat> pictures_ = noisyPictures();
};

}  // namespace fyd::console::bench
