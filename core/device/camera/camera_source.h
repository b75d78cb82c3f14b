// Cameras through OpenCV: a device, a video file, a folder of pictures or a stream.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/device/camera/camera.h"
#include "core/device/device_parameters.h"

namespace fyd::device {

/// @param source one of
///   "0"                 number of a capture device
///   "id=SERIAL"         the capture device with this serial number, whichever node it has (stable_name.h)
///   "/dev/video0"       path of a capture device (or of a link to one, such as in /dev/v4l/by-id)
///   "press.avi"         video file, played at its own rate (30 fps where it states none), in a loop
///   "pictures/"         folder; its .png .jpg .jpeg .bmp .pgm .tif .tiff in the order of their names, 30 fps, in a
///   loop "rtsp://…", "http://…"   stream
/// Pictures are passed on unchecked, black ones too: the detector judges them.
/// Brightness, contrast and exposure are set at each opening where the source has them.
/// A device or stream that falls silent makes next() fail; each later call tries to open it again, at most once a
/// second.
/// Opening a stream takes at most 3 s; a device that is there but silent is given up after 10 s (OpenCV's own limit),
/// one that was unplugged at once.
/// @return an error that names the source, the kind it was taken for and what was found
[[nodiscard]] Result<std::unique_ptr<Camera>> openCamera(const std::string& source,
                                                         const DeviceParameters& parameters = {});

}  // namespace fyd::device
