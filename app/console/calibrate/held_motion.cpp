#include "app/console/calibrate/held_motion.h"

#include <array>

namespace fyd::console {
namespace {

constexpr int kKeep_ms = 100;
constexpr int kPress_ms = 1500;  // the simulated finger rests that long at each depth
constexpr std::array kDepths_mm = {3.0, 5.0, 7.0};

}  // namespace

HeldMotion::HeldMotion(Session& session, widgets::HoldButton* button, QObject* parent)
    : QObject(parent), session_(session), button_(button) {
  timer_.setInterval(kKeep_ms);
  connect(&timer_, &QTimer::timeout, this, &HeldMotion::keep);
}

Result<void> HeldMotion::start(device::DeviceTest test, double stretch_deg) {
  if (auto started = session_.startDeviceTest(test, stretch_deg); !started) return started;
  timer_.start();
  pressing_ = test == device::DeviceTest::stretch && session_.simulated();
  pressing_since_.invalidate();
  return {};
}

void HeldMotion::keep() {
  if (!button_->engaged()) return end();
  session_.keepDeviceTest();
  if (!pressing_ || !status_.resting) return;
  if (!pressing_since_.isValid()) pressing_since_.start();
  const auto depth = static_cast<std::size_t>(pressing_since_.elapsed() / kPress_ms) % kDepths_mm.size();
  session_.moveSimulatedFinger(0.0, 0.0, kDepths_mm[depth]);
}

void HeldMotion::end() {
  if (!timer_.isActive()) return;
  timer_.stop();
  session_.stopDeviceTest();
  if (pressing_) session_.releaseSimulatedFinger();
  pressing_ = false;
  status_ = {};
  emit ended();
}

}  // namespace fyd::console
