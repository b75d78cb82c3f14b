#include "core/station/camera_thread.h"

#include <spdlog/spdlog.h>

#include <condition_variable>

namespace fyd::station {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);

void sleepUnlessStopped(const std::stop_token& stop, Duration time) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait_for(lock, stop, time, [] { return false; });
}

}  // namespace

CameraThread::CameraThread(const std::string& description, Opener opener, const sensing::FingerParameters& parameters)
    : opener_(std::move(opener)), detector_(parameters), monitor_("Camera", description), parameters_(parameters) {}

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
        fail(opened.error().message);
        sleepUnlessStopped(stop, kRetry);
        continue;
      }
      camera = std::move(*opened);
      monitor_.describe(camera->description());
    }
    auto frame = camera->next();
    if (frame) {
      process(std::move(*frame));
    } else {
      fail(frame.error().message);
      sleepUnlessStopped(stop, kRetry);
    }
  }
}

void CameraThread::fail(const std::string& problem) {
  if (monitor_.failed(problem)) spdlog::warn("Camera: {}", problem);
}

void CameraThread::process(device::CameraFrame frame) {
  {
    const std::lock_guard lock(mutex_);
    if (parameters_changed_) detector_.configure(parameters_);
    parameters_changed_ = false;
  }
  CameraView view;
  view.finger = detector_.detect(device::viewOf(frame.picture));
  newest_.set(view.finger, frame.taken);
  finger.write(newest_);
  monitor_.succeeded(frame.taken);

  const sensing::RegionOfInterest region = detector_.region();
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
