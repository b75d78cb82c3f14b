// A whole station on real drivers, connected through the real protocols to a simulated touchpad.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>
#include <opencv2/imgcodecs.hpp>

#include "core/sim/server/touchpad_process.h"
#include "core/sim/touchpad/picture.h"
#include "core/station/station.h"
#include "tests/wait.h"

namespace fyd::station {

enum class Backend : std::uint8_t { modbus_tcp, modbus_rtu, qbmove, mjpeg };
inline constexpr std::array<const char*, 4> kBackendNames = {"modbus_tcp", "modbus_rtu", "qbmove", "mjpeg"};

/// Keeps the logged warnings, to be searched.
class LogKeeper final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  [[nodiscard]] bool has(std::string_view words) {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(lines_, [&](const auto& line) { return line.find(words) != std::string::npos; });
  }
  void forget() {
    const std::lock_guard lock(mutex_);
    lines_.clear();
  }

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (message.level < spdlog::level::warn) return;
    lines_.emplace_back(message.payload.begin(), message.payload.end());
  }
  void flush_() override {}
  std::vector<std::string> lines_;
};

class DeviceRig {
 public:
  explicit DeviceRig(Backend backend) : backend_(backend) {
    static int number = 0;
    folder_ = std::filesystem::path(testing::TempDir()) / fmt::format("fyd-rig-{}-{}", ::getpid(), ++number);
    std::filesystem::create_directories(folder_ / "by-id");
    by_id_ = (folder_ / "by-id").string();
    spdlog::default_logger()->sinks().push_back(log_);
    startPeer();
    StationOptions options;
    options.robot = "none";
    // A test machine may pause for longer than a real one.
    options.profile.step.step.motors_maximum_age_ms = 400.0;
    options.profile.step.step.ir_maximum_age_ms = 500.0;
    options.profile.step.step.bridge_maximum_age_ms = 500.0;
    options.profile.device.response_timeout_ms = 150.0;  // a late reply is 250 ms late
    options.profile.device.watchdog_ms = 1000.0;
    options.profile.device.qbmove_timeout_ms = 100.0;
    options.profile.device.qbmove_watchdog_ms = 1000.0;
    // Pictures that are 250 ms late come every 250 ms: the limit is below that, so that the test sees them as stale.
    options.profile.step.step.finger_maximum_age_ms = 150.0;
    options.profile.device.stuck_sensor_s = 1.0;
    options.profile.device.serial_by_id = by_id_;
    choose(options);
    auto opened = Station::open(options);
    if (!opened) throw std::runtime_error(opened.error().text());
    station = std::move(*opened);
    station->start();
  }
  ~DeviceRig() {
    station.reset();
    process.reset();
    std::erase(spdlog::default_logger()->sinks(), log_);
    std::filesystem::remove_all(folder_);
  }
  DeviceRig(const DeviceRig&) = delete;
  DeviceRig& operator=(const DeviceRig&) = delete;

  /// Starts the simulated touchpad, again at the same addresses. Serial lines come back on another port: only the name
  /// that belongs to the device leads there.
  void startPeer() {
    namespace fs = std::filesystem;
    sim::TouchpadProcessOptions options;
    const auto any = *protocol::parseEndpoint("127.0.0.1:0");
    std::string port = (folder_ / fmt::format("port{}", ++starts_)).string();
    const auto plugIn = [&](const char* name) {
      fs::remove(folder_ / "by-id" / name);
      fs::create_symlink(port, folder_ / "by-id" / name);
      return port;
    };
    switch (backend_) {
      case Backend::modbus_tcp: options.modbus_tcp = any; break;
      case Backend::modbus_rtu: options.modbus_rtu = plugIn("usb-Maker_RS485_AB12-if00-port0"); break;
      case Backend::qbmove:
        options.modbus_tcp = any;
        options.qbmove = plugIn("usb-Maker_UART_CD34-if00-port0");
        break;
      case Backend::mjpeg: options.camera_mjpeg = any; break;
    }
    if (options.modbus_tcp && modbus_port_ != 0) options.modbus_tcp->port = modbus_port_;
    if (options.camera_mjpeg && camera_port_ != 0) options.camera_mjpeg->port = camera_port_;
    auto started = sim::TouchpadProcess::start(options);
    ASSERT_TRUE(started) << started.error().text();
    process = std::move(*started);
    modbus_port_ = process->modbusPort();
    camera_port_ = process->cameraPort();
  }

  void unplug() {
    process.reset();
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "by-id")) std::filesystem::remove(entry);
  }

  [[nodiscard]] device::DeviceReport part() const {
    return station->status().parts[backend_ == Backend::mjpeg ? 1 : 0];
  }
  /// Whether a problem with these words is shown, or was since `inject`: many last for a few milliseconds only.
  [[nodiscard]] bool told(std::string_view words) const {
    const device::DeviceReport now = part();
    return (!now.ok && now.problem.text().find(words) != std::string::npos) || log_->has(words);
  }
  void inject(sim::TouchpadFault fault, double seconds) {
    log_->forget();
    process->inject(fault, seconds);
  }
  [[nodiscard]] bool lineOk(std::string_view what) const {
    for (const ReadinessLine& line : station->readiness()) {
      if (line.what == phrase(what)) return line.ok;
    }
    return false;
  }
  [[nodiscard]] bool allOk() const { return linesOk() && part().ok; }

  /// Takes the telemetry there is. Counts samples, the Active ones, and encoders' angles that no motor can have had.
  void drain() {
    std::vector<pipeline::TelemetrySample> batch(2000);
    const std::size_t taken = station->takeTelemetry(batch);
    for (std::size_t i = 0; i < taken; ++i) {
      const auto& sample = batch[i];
      ++samples;
      active_samples += sample.state == pipeline::SafetyState::active ? 1 : 0;
      lookAtAngle(sample);
      state = sample.state;
    }
  }
  template <class Condition>
  [[nodiscard]] testing::AssertionResult wait(std::string_view what, Condition&& condition,
                                              Duration patience = kPatience) {
    auto came = comesTrue(
        what,
        [&] {
          drain();
          return condition();
        },
        patience);
    if (!came) came << "; state " << toString(state) << ", " << part().problem.text();
    return came;
  }
  /// Waits for that many more steps, so that their effects have occurred.
  [[nodiscard]] testing::AssertionResult pass(std::uint64_t steps) {
    const std::uint64_t end = samples + steps;
    return wait(fmt::format("{} steps", steps), [&] { return samples >= end; });
  }
  /// Whether a problem that ends in "then arm again" is shown now: the motors went off by themselves.
  [[nodiscard]] bool isToBeArmed(std::string_view why) const {
    const std::string problem = part().problem.text();
    return problem.find(why) != std::string::npos && problem.ends_with("then arm again");
  }
  [[nodiscard]] bool linesOk() const {
    return std::ranges::all_of(station->readiness(), [](const ReadinessLine& line) { return line.ok; });
  }
  /// Waits until everything answers. A stop ends what is said of motors that went off by themselves.
  [[nodiscard]] testing::AssertionResult well() {
    return wait("every device and line of the readiness list", [this] {
      if (isToBeArmed("")) station->requestStop();
      return allOk();
    });
  }
  /// Arms, and repeats it when a pause of the machine led to Held at once.
  [[nodiscard]] testing::AssertionResult armed() {
    const Instant end = Clock::now() + kPatience;
    testing::AssertionResult active = testing::AssertionFailure();
    while (!active && Clock::now() < end) {
      if (auto ready = well(); !ready) return ready;
      (void)station->command({.action = pipeline::OperatorAction::arm});
      active = wait(
          "the state Active", [this] { return state == pipeline::SafetyState::active; },
          std::chrono::milliseconds(200));
    }
    return active;
  }
  [[nodiscard]] testing::AssertionResult stopped() {
    station->requestStop();
    return wait("the state Stopped", [this] { return state == pipeline::SafetyState::stopped; });
  }

  std::unique_ptr<sim::TouchpadProcess> process;
  std::unique_ptr<Station> station;
  pipeline::SafetyState state = pipeline::SafetyState::disconnected;
  std::uint64_t samples = 0;
  int active_samples = 0;
  int impossible_angles = 0;

 private:
  /// By the bound of core/device: no motor is faster than 1000 °/s, however long nothing was read from it.
  void lookAtAngle(const pipeline::TelemetrySample& sample) {
    if (!std::isfinite(sample.stretch_measured_deg)) return;
    const double read_s = toSeconds(sample.now.time_since_epoch()) - 1e-3 * sample.motors_age_ms;
    const double allowed_deg = 5.0 + 1000.0 * std::max(0.0, read_s - stretch_read_s_);
    if (std::abs(sample.stretch_measured_deg - stretch_deg_) > allowed_deg) ++impossible_angles;
    stretch_deg_ = sample.stretch_measured_deg;
    stretch_read_s_ = read_s;
  }

  void choose(StationOptions& options) {
    if (backend_ == Backend::mjpeg) {
      options.camera = fmt::format("http://127.0.0.1:{}/", camera_port_);
      return;
    }
    options.camera = (folder_ / "cloth").string();
    std::filesystem::create_directories(options.camera);
    cv::Mat picture;
    std::mt19937_64 random{1};
    sim::PictureRenderer(sim::SimParameters{}).render({}, random, picture);
    cv::imwrite(options.camera + "/cloth.png", picture);
    options.touchpad =
        backend_ == Backend::modbus_rtu ? "modbus-rtu:id=AB12" : fmt::format("modbus-tcp:127.0.0.1:{}", modbus_port_);
    if (backend_ == Backend::qbmove) options.motors = "qbmove:id=CD34";
  }

  Backend backend_;
  std::shared_ptr<LogKeeper> log_ = std::make_shared<LogKeeper>();
  std::filesystem::path folder_;
  std::string by_id_;
  int starts_ = 0;
  std::uint16_t modbus_port_ = 0;
  std::uint16_t camera_port_ = 0;
  double stretch_deg_ = pipeline::kNone;
  double stretch_read_s_ = 0.0;
};

}  // namespace fyd::station
