// Opens what a session's options name: finger and local model (surface, scene) of a simulation, touchpad, camera.
#pragma once

#include <memory>
#include <string>

#include "core/device/touchpad/touchpad.h"
#include "core/pipeline/local_model.h"
#include "core/replay/recorded_device.h"
#include "core/sim/finger_path.h"
#include "core/sim/touchpad/touchpad_world.h"
#include "core/station/camera_thread.h"
#include "core/station/profile/calibrated_values.h"
#include "core/station/station_options.h"

namespace fyd::station {

inline constexpr std::string_view kSimulated = "simulated";

/// Whether the options' words mean something and fit each other, without a look at any file or device. What is left
/// empty is not judged: it may come from the profile.
[[nodiscard]] Result<void> checkWords(const StationOptions& options);

/// @param surface, scene files; empty: none
[[nodiscard]] Result<pipeline::LocalModel> readLocalModel(const std::string& surface, const std::string& scene,
                                                          double rate_Hz);

/// @param path empty: the built-in gesture
[[nodiscard]] Result<sim::FingerPath> readFinger(const std::string& path);

/// The touchpad that the options name, as in touchpad_name.h. A real one whose serial number the options do not demand
/// is asked for it.
/// @return empty when it does not answer now
[[nodiscard]] std::string touchpadOf(const StationOptions& options);

/// Gives `options.profile` the calibrated values of the touchpad that they name (calibrated_values.h), and demands that
/// no other one answers later. @return the same profile, with what is to be said of it; an error when a file is bad
[[nodiscard]] Result<TouchpadProfile> bindToTouchpad(StationOptions& options);

/// @param options that `checkWords` found good
/// @param world of the simulated touchpad; null: a real or recorded one is opened
[[nodiscard]] Result<std::unique_ptr<device::Touchpad>> openTouchpad(
    const StationOptions& options, const std::shared_ptr<sim::TouchpadWorld>& world,
    const std::shared_ptr<replay::PlaybackStart>& playback);

/// @param clock_waits the session's clock waits for the simulated camera
[[nodiscard]] CameraThread::Opener cameraOpener(const StationOptions& options,
                                                const std::shared_ptr<sim::TouchpadWorld>& world,
                                                const std::shared_ptr<replay::PlaybackStart>& playback,
                                                bool clock_waits);

}  // namespace fyd::station
