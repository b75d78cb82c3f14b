#include "core/station/camera_thread.h"

#include <spdlog/spdlog.h>

#include <condition_variable>

#include "core/device/camera/camera_controls.h"

namespace fyd::station {
namespace {

constexpr Duration kCameraSilence = std::chrono::milliseconds(900);  // the slowest video gives a picture a second
constexpr Duration kRetry = std::chrono::milliseconds(500);

void sleepUnlessStopped(const std::stop_token& stop, Duration time) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait_for(lock, stop, time, [] { return false; });
}

}  // namespace

CameraThread::CameraThread(const Message& description, Opener opener, const sensing::FingerParameters& parameters,
                           const device::DeviceParameters& device)
    : opener_(std::move(opener)),
      detector_(parameters),
      monitor_(device::Part::camera, description, kCameraSilence),
      frozen_(fromSeconds(device.camera_freeze_ms / 1e3)),
      flat_cloth_(device.camera_flat_cloth),
      report_{.part = device::Part::camera, .description = description},
      parameters_(parameters) {}

CameraThread::~CameraThread() { shutDown(); }

void CameraThread::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void CameraThread::shutDown() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void CameraThread::configure(const sensing::FingerParameters& parameters) {
  const std::lock_guard lock(mutex_);
  parameters_ = parameters;
  parameters_changed_ = true;
}

CameraView CameraThread::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

void CameraThread::run(const std::stop_token& stop) {
  std::unique_ptr<device::Camera> camera;
  while (!stop.stop_requested()) {
    if (!camera) {
      auto opened = opener_();
      if (!opened) {
        failed(opened.error().message);
        sleepUnlessStopped(stop, kRetry);
        continue;
      }
      camera = std::move(*opened);
      describe(*camera);
    }
    auto frame = camera->next();
    countDamaged(*camera);
    if (frame) {
      process(std::move(*frame));
    } else {
      failed(frame.error().message);
      sleepUnlessStopped(stop, kRetry);
      frozen_.reset();
      describe(*camera);  // opening again may have found other controls
    }
  }
}

void CameraThread::describe(const device::Camera& camera) {
  live_ = camera.live();
  auto controls = camera.controls();
  const Message description = camera.description();
  const Message missing = device::missingControls(controls);
  monitor_.describe(missing.empty() ? description : explained(description, missing));
  const std::lock_guard lock(mutex_);
  report_.kind = camera.kind();
  report_.description = description;
  report_.controls = std::move(controls);
}

device::DeviceReport CameraThread::report(Instant now) const {
  device::DeviceReport out;
  {
    const std::lock_guard lock(mutex_);
    out = report_;
    out.counters = {{say("repeated pictures"), repeated_}, {say("damaged pictures"), damaged_}};
    if (!view_.picture.empty()) {
      out.values = {{.name = say("width"), .number = static_cast<double>(view_.picture.cols), .unit = "px"},
                    {.name = say("height"), .number = static_cast<double>(view_.picture.rows), .unit = "px"},
                    {.name = say("pictures"), .number = static_cast<double>(view_.number)},
                    {.name = say("finger"), .text = phrase(sensing::toString(view_.finger.reason))}};
    }
  }
  monitor_.fillIn(out, now);
  return out;
}

void CameraThread::countDamaged(const device::Camera& camera) {
  const std::lock_guard lock(mutex_);
  damaged_ = camera.damaged();
}

void CameraThread::failed(const Message& problem) {
  if (monitor_.failed(problem)) spdlog::warn("Camera: {}", problem.text());
}

// A picture identical to the last one carries no new measurement: it is not handed on, so that the finger's age grows.
void CameraThread::process(device::CameraFrame frame) {
  const bool was_frozen = frozen_.frozen();
  if (!live_ || frozen_.isNews(frame.picture, frame.taken)) {
    detect(std::move(frame));
    return;
  }
  if (frozen_.frozen() && !was_frozen) {
    failed(say("the picture is frozen: the camera sends the same one again and again; unplug it and plug it in again"));
  }
  const std::lock_guard lock(mutex_);
  ++repeated_;
}

void CameraThread::detect(device::CameraFrame frame) {
  {
    const std::lock_guard lock(mutex_);
    if (parameters_changed_) detector_.configure(parameters_);
    parameters_changed_ = false;
  }
  CameraView view;
  view.finger = detector_.detect(device::viewOf(frame.picture));
  using enum sensing::FingerReason;
  if (flat_cloth_ && (view.finger.reason == flat_picture || view.finger.reason == saturated)) {
    view.finger.reason = no_finger;
  }
  newest_.set(view.finger, frame.taken);
  finger.write(newest_);
  monitor_.succeeded(frame.taken);

  const RegionOfInterest region = detector_.region();
  view.region = cv::Rect(region.x, region.y, region.width, region.height);
  view.finger_mask.create(region.height, region.width, CV_8UC1);
  detector_.drawOverlay({view.finger_mask.data, view.finger_mask.total()});
  view.picture = std::move(frame.picture);
  view.taken = frame.taken;
  view.number = frame.number;
  if (observer_) observer_(view);
  const std::lock_guard lock(mutex_);
  view_ = std::move(view);
}

}  // namespace fyd::station
