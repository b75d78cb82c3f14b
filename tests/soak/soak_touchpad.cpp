#include "tests/soak/soak_touchpad.h"

#include <algorithm>
#include <array>

#include <opencv2/imgcodecs.hpp>

namespace fyd::soak {
namespace {

using sim::TouchpadFault;
using std::chrono::milliseconds;

constexpr Duration kCycle = milliseconds(4);
constexpr Duration kFirstRetry = milliseconds(20);
constexpr Duration kLongestRetry = milliseconds(500);
constexpr double kTimeout_ms = 60.0;  // of this machine's time: its threads may have to wait
constexpr int kVibrationOpcode = 141;
constexpr double kFlatGrey = 200.0;

/// A fault, and by when Active must have ended: with its motors on Modbus, on their own board; 0: it need not.
struct Kind {
  TouchpadFault fault;
  int modbus_ms;
  int board_ms;
};
// Ages of 50 ms (motors) and 100 ms (sensors), half a second until values count as frozen, and the time of a few cycles.
constexpr std::array<Kind, 10> kKinds = {{{TouchpadFault::silence, 70, 130},
                                          {TouchpadFault::brown_out, 70, 130},
                                          {TouchpadFault::garbage, 70, 130},
                                          {TouchpadFault::frozen_values, 750, 750},
                                          {TouchpadFault::bridge_end, 180, 180},
                                          {TouchpadFault::hot_reading, 70, 130},
                                          {TouchpadFault::disobedience, 70, 0},
                                          {TouchpadFault::encoder_jump, 70, 70},
                                          {TouchpadFault::stuck_sensor, 0, 0},
                                          {TouchpadFault::late_reply, 0, 0}}};
// A picture may be 250 ms old; the next is up to a period later.
constexpr std::array<Kind, 7> kCameraKinds = {{{TouchpadFault::silence, 300, 300},
                                               {TouchpadFault::garbage, 300, 300},
                                               {TouchpadFault::brown_out, 300, 300},
                                               {TouchpadFault::camera_freeze, 300, 300},
                                               {TouchpadFault::camera_flat, 330, 330},
                                               {TouchpadFault::camera_damage, 900, 900},
                                               {TouchpadFault::camera_cut, 300, 300}}};

std::string nameOf(TouchpadFault fault) {
  return std::string(sim::kTouchpadFaultNames[static_cast<std::size_t>(fault)]);
}

std::string touchpadName(TouchpadFault fault, bool own_board) {
  return "touchpad " + nameOf(fault) + (own_board ? ", own motor board" : "");
}

std::string cameraName(TouchpadFault fault) { return "camera " + nameOf(fault); }

device::DeviceParameters deviceParameters() {
  device::DeviceParameters out;
  out.response_timeout_ms = kTimeout_ms;
  out.qbmove_timeout_ms = kTimeout_ms;
  out.qbmove_vibration_opcode = kVibrationOpcode;
  return out;
}

sim::SimParameters simParameters(int seed) {
  sim::SimParameters out;
  out.seed = seed;
  return out;
}

}  // namespace

SoakTouchpad::SoakTouchpad(const pipeline::Parameters& parameters, const sim::FingerPath& finger, bool own_board,
                           const std::string& folder, int seed, Instant start)
    : own_board_(own_board),
      faults_({}, start),
      world_(std::make_shared<sim::TouchpadWorld>(simParameters(seed), finger, start)),
      electronics_(std::make_shared<sim::TouchpadElectronics>(
          world_, faults_, sim::MotorBoardOptions{.vibration_opcode = kVibrationOpcode}, start)),
      frozen_(deviceParameters()),
      plausibility_(deviceParameters()),
      due_(start),
      board_due_(start),
      retry_(kFirstRetry),
      board_retry_(kFirstRetry),
      active_sent_(start),
      camera_faults_({}, start),
      camera_(world_),
      detector_(parameters.sensing.finger),
      same_(milliseconds(500)),
      next_picture_(start),
      picture_period_(fromSeconds(1.0 / simParameters(seed).camera_rate_Hz)) {
  *clock_ns_ = start.time_since_epoch().count();
  electronics_->readTimeFrom([clock = clock_ns_] { return Instant(Duration(clock->load())); });
  auto served = sim::ModbusTcpServer::start(*protocol::parseEndpoint("127.0.0.1:0"), electronics_);
  if (!served) broken(served.error().text());
  modbus_ = std::move(*served);
  const auto address = device::parseModbusAddress(fmt::format("modbus-tcp:127.0.0.1:{}", modbus_->local().port));
  touchpad_ = std::make_unique<device::ModbusTouchpad>(*address, deviceParameters());
  if (!own_board) return;
  const std::string port = folder + "/board";
  auto board = sim::QbmoveServer::start(port, 2'000'000, electronics_);
  if (!board) broken(board.error().text());
  board_ = std::move(*board);
  motors_ = std::make_unique<device::QbmoveMotors>(port, deviceParameters());
}

void SoakTouchpad::advance(Instant now, const control::MotorCommand& command, pipeline::Inputs& inputs) {
  *clock_ns_ = now.time_since_epoch().count();
  electronics_->advanceTo(now);
  command_ = command;
  if (!own_board_) touchpad_->queueVibration({&command.vibration_duty_percent, 1});
  if (now >= due_ || (own_board_ && now >= board_due_)) exchange(now, inputs);
  takePicture(now, inputs);
  lookAtMotors(now);
}

void SoakTouchpad::exchange(Instant now, pipeline::Inputs& inputs) {
  if (command_.active) active_sent_ = now;
  if (own_board_ && now >= board_due_) {
    const auto moved = motors_->exchange(command_);
    if (moved) board_feedback_.set(*moved, now);
    board_due_ = now + (moved ? kCycle : board_retry_);
    board_retry_ = moved ? kFirstRetry : std::min(2 * board_retry_, kLongestRetry);
  }
  if (now < due_) return;
  control::MotorCommand sent = command_;
  if (own_board_) sent.active = false;
  auto exchanged = touchpad_->exchange(sent, now);
  due_ = now + (exchanged ? kCycle : retry_);
  retry_ = exchanged ? kFirstRetry : std::min(2 * retry_, kLongestRetry);
  device::TouchpadReadings said{.ir = inputs.ir, .bridge = inputs.bridge, .motors = inputs.motors};
  if (exchanged) said = *exchanged;
  if (own_board_) said.motors = board_feedback_;
  if (!exchanged && !own_board_) return;
  const device::TouchpadReadings believed = plausibility_.check(frozen_.check(said), command_, now);
  inputs.ir = believed.ir;
  inputs.bridge = believed.bridge;
  inputs.motors = believed.motors;
}

void SoakTouchpad::takePicture(Instant now, pipeline::Inputs& inputs) {
  if (now < next_picture_) return;
  next_picture_ += picture_period_;
  const auto is = [&](TouchpadFault fault) { return camera_faults_.active(fault, now); };
  if (is(TouchpadFault::silence) || is(TouchpadFault::brown_out)) return;
  if (!is(TouchpadFault::camera_freeze) || jpeg_.empty()) {
    cv::Mat drawn = camera_.frameAt(now).picture;
    if (is(TouchpadFault::camera_flat)) drawn.setTo(cv::Scalar::all(kFlatGrey));
    cv::imencode(".jpg", drawn, jpeg_, {cv::IMWRITE_JPEG_QUALITY, 92});
    if (is(TouchpadFault::camera_cut)) jpeg_.resize(jpeg_.size() / 3);
    if (is(TouchpadFault::garbage)) jpeg_.resize(2000);
    const std::size_t wrong = is(TouchpadFault::garbage) ? jpeg_.size() : is(TouchpadFault::camera_damage) ? 8 : 0;
    for (std::size_t i = 0; i < wrong; ++i) jpeg_[random_() % jpeg_.size()] = static_cast<std::uint8_t>(random_());
  }
  auto decoded = device::decodeJpeg(jpeg_);
  damage_.saw(!decoded.has_value());
  if (!decoded || !damage_.believed() || !same_.isNews(*decoded, now)) return;
  picture_ = std::move(*decoded);
  ++pictures_;
  inputs.finger.set(detector_.detect(device::viewOf(picture_)), now);
}

void SoakTouchpad::lookAtMotors(Instant now) {
  constexpr Duration kWatchdog = milliseconds(100) + milliseconds(80);  // the board's counts in steps of 20 ms
  const bool silent = faults_.active(TouchpadFault::silence, now) || faults_.active(TouchpadFault::brown_out, now);
  if (silent && !silent_) silent_since_ = now;
  silent_ = silent;
  const bool must_be_off = now - active_sent_ > kWatchdog || (silent && now - silent_since_ > kWatchdog);
  if (must_be_off && electronics_->figures().motors_on) {
    broken(fmt::format("the simulated motors are on {:.0f} ms after the last active command{}",
                       toMilliseconds(now - active_sent_), silent ? ", on a silent line" : ""));
  }
}

std::optional<Deadline> SoakTouchpad::disturb(Chance& chance, Instant now, Figures& figures) {
  const Kind kind = kKinds[static_cast<std::size_t>(chance.below(kKinds.size()))];
  const double seconds = kind.fault == TouchpadFault::late_reply ? 0.0 : chance.between(0.02, 1.5);
  faults_.add(kind.fault, now, seconds);
  ++figures.faults[touchpadName(kind.fault, own_board_)];
  const bool alone = now > fault_ends_ + milliseconds(1000);
  fault_ends_ = std::max(fault_ends_, now + fromSeconds(seconds));
  const int ms = own_board_ ? kind.board_ms : kind.modbus_ms;
  if (ms == 0) return std::nullopt;
  Deadline out{
      .name = nameOf(kind.fault), .until = now + milliseconds(ms), .ends = now + fromSeconds(seconds), .alone = alone};
  // The new angle is believed after a second, or when the motors have been off.
  if (kind.fault == TouchpadFault::encoder_jump) out.ends = std::min(out.ends, out.until + milliseconds(10));
  return out;
}

std::optional<Deadline> SoakTouchpad::disturbCamera(Chance& chance, Instant now, Figures& figures) {
  const Kind kind = kCameraKinds[static_cast<std::size_t>(chance.below(kCameraKinds.size()))];
  const double seconds = chance.between(0.02, 1.5);
  camera_faults_.add(kind.fault, now, seconds);
  ++figures.faults[cameraName(kind.fault)];
  const bool alone = now > camera_fault_ends_ + milliseconds(2000);
  camera_fault_ends_ = std::max(camera_fault_ends_, now + fromSeconds(seconds));
  return Deadline{.name = cameraName(kind.fault),
                  .until = now + milliseconds(kind.modbus_ms),
                  .ends = now + fromSeconds(seconds),
                  .alone = alone};
}

void SoakTouchpad::nameFaults(Figures& figures) {
  for (const Kind& kind : kKinds) {
    for (const bool own_board : {false, true}) figures.faults[touchpadName(kind.fault, own_board)];
  }
  for (const Kind& kind : kCameraKinds) figures.faults[cameraName(kind.fault)];
}

}  // namespace fyd::soak
