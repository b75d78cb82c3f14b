// The camera thread: takes pictures, finds the finger, hands the result to the haptic loop and the picture to the
// window.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/latest_value.h"
#include "core/device/camera/camera.h"
#include "core/device/camera/frozen_picture.h"
#include "core/device/device_parameters.h"
#include "core/device/part_monitor.h"
#include "core/sensing/finger_detector.h"
#include "core/station/camera_view.h"

namespace fyd::station {

class CameraThread {
 public:
  /// Opens the source; called again after failures, from the camera thread.
  using Opener = std::function<Result<std::unique_ptr<device::Camera>>()>;
  /// Sees every picture with its detection, on the camera thread.
  using Observer = std::function<void(const CameraView&)>;

  CameraThread(const Message& description, Opener opener, const sensing::FingerParameters& parameters,
               const device::DeviceParameters& device = {});
  ~CameraThread();
  void observe(Observer observer) { observer_ = std::move(observer); }  ///< before start
  void start();
  void shutDown();

  /// Takes effect with the next picture; from any thread but the haptic loop.
  void configure(const sensing::FingerParameters& parameters);

  LatestValue<Timed<sensing::FingerDetection>> finger;  ///< read by the haptic loop
  [[nodiscard]] CameraView view() const;
  [[nodiscard]] device::DeviceReport status(Instant now) const { return monitor_.report(now); }
  [[nodiscard]] device::DeviceReport report(Instant now) const;

 private:
  void run(const std::stop_token& stop);
  void process(device::CameraFrame frame);
  void detect(device::CameraFrame frame);
  void describe(const device::Camera& camera);
  void countDamaged(const device::Camera& camera);
  void failed(const Message& problem);

  Opener opener_;
  Observer observer_;
  sensing::FingerDetector detector_;
  Timed<sensing::FingerDetection> newest_;
  device::PartMonitor monitor_;
  device::FrozenPicture frozen_;
  bool live_ = false;
  const bool flat_cloth_;  // an untouched cloth then gives a uniformly grey picture
  mutable std::mutex mutex_;
  CameraView view_;
  device::DeviceReport report_;
  std::uint64_t repeated_ = 0;  // pictures equal to the one before
  std::uint64_t damaged_ = 0;
  sensing::FingerParameters parameters_;
  bool parameters_changed_ = false;
  std::jthread thread_;
};

}  // namespace fyd::station
