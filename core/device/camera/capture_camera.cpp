#include "core/device/camera/capture_camera.h"

#include <cctype>
#include <cstdlib>
#include <mutex>
#include <thread>

#include <opencv2/core/utils/logger.hpp>

#include "core/base/codecs/codecs.h"

namespace fyd::device {
namespace {

constexpr Duration kRetryAfter = std::chrono::seconds(1);
constexpr Duration kLongestDamage = std::chrono::seconds(1);
constexpr int kOpenTimeout_ms = 3000;
constexpr int kReadTimeout_ms = 1000;

/// Whether OpenCV's code for a codec (four characters) is one of JPEG pictures.
bool meansJpeg(double fourcc) {
  const auto code = static_cast<std::uint32_t>(fourcc);
  std::string word;
  for (const unsigned shift : {0U, 8U, 16U, 24U})
    word += static_cast<char>(std::tolower(static_cast<int>((code >> shift) & 0xFFU)));
  return word == "mjpg" || word == "jpeg" || word == "mjpe";  // the last: FFmpeg's "mjpeg", for a stream without a code
}

}  // namespace

void prepareCaptures() {
  static std::once_flag once;
  std::call_once(once, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    // NOLINTBEGIN(concurrency-mt-unsafe): before there are threads
    ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    ::setenv("OPENCV_VIDEOIO_V4L_RANGE_NORMALIZED", "1", 1);
    // NOLINTEND(concurrency-mt-unsafe)
  });
}

Result<std::unique_ptr<Camera>> CaptureCamera::open(const CaptureChoice& choice, const DeviceParameters& parameters) {
  prepareCaptures();
  std::unique_ptr<CaptureCamera> camera(new CaptureCamera(choice, parameters));
  if (const auto opened = camera->openCapture(); !opened) return tl::unexpected(opened.error());
  if (choice.kind == CaptureKind::video) {
    if (cv::Mat first; camera->read(first) == Got::nothing) return fail("{}: holds no picture", camera->name());
    if (const auto rewound = camera->openCapture(); !rewound) return tl::unexpected(rewound.error());
  }
  return camera;
}

Message CaptureCamera::name() const {
  switch (kind_) {
    case CaptureKind::device: return say("camera device '{}'", shown_);
    case CaptureKind::video: return say("video file '{}'", shown_);
    case CaptureKind::stream: return say("camera stream '{}'", shown_);
  }
  return verbatim(shown_);
}

Message CaptureCamera::kind() const {
  static constexpr std::array<std::string_view, 3> kKinds = {sentence("camera device"), sentence("video file"),
                                                             sentence("stream")};
  return phrase(kKinds[static_cast<std::size_t>(kind_)]);
}

Message CaptureCamera::description() const {
  const std::string size = fmt::format("{} × {}", size_.width, size_.height);
  if (kind_ == CaptureKind::video) return say("{}, {} at {:.4g} fps, repeating", name(), size, pacer_.rate_Hz());
  return size_.empty() ? name() : listed({name(), verbatim(size)}, "{}, {}");
}

void CaptureCamera::openDevice(const std::string& path) {
  if (number_) {
    capture_->open(*number_, cv::CAP_V4L2);
  } else {
    capture_->open(path, cv::CAP_V4L2);
  }
}

void CaptureCamera::setUpDevice() {  // the thesis' format; a camera without it keeps its own
  capture_->set(cv::CAP_PROP_FRAME_WIDTH, 320);
  capture_->set(cv::CAP_PROP_FRAME_HEIGHT, 240);
  capture_->set(cv::CAP_PROP_FPS, kUsualRate_Hz);
  controls_ = applyControls(settings_, {.set = [this](int what, double share) { return capture_->set(what, share); },
                                        .get = [this](int what) { return capture_->get(what); }});
}

Result<void> CaptureCamera::openCapture() {
  last_attempt_ = Clock::now();
  const auto path = kind_ == CaptureKind::device ? resolveDevice(source_, by_id_) : source_;
  if (!path) return fail("camera: {}", path.error().message);
  try {
    if (!capture_) capture_ = codecs::videoCapture();
    // The backend is named, because OpenCV otherwise also tries GStreamer, which scans its plugins and leaks.
    switch (kind_) {
      case CaptureKind::device: openDevice(*path); break;
      case CaptureKind::video: capture_->open(source_, cv::CAP_FFMPEG); break;
      case CaptureKind::stream:
        capture_->open(source_, cv::CAP_FFMPEG,
                       {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenTimeout_ms,  //
                        cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadTimeout_ms});
        break;
    }
    if (!capture_->isOpened()) {
      static constexpr std::array<std::string_view, 3> kExpected = {
          sentence("expected a camera that Video4Linux can read, and the right to open it"),
          sentence("expected a video that FFmpeg can decode"),
          sentence("expected a stream that FFmpeg can play and that starts within 3 s"),
      };
      return fail("{}: does not open; {}", name(), phrase(kExpected[static_cast<std::size_t>(kind_)]));
    }
    if (kind_ == CaptureKind::device) {
      setUpDevice();
    } else {
      controls_ =
          noControls(settings_, kind_ == CaptureKind::video ? say("a video file has none") : say("a stream has none"));
    }
    size_ = {static_cast<int>(capture_->get(cv::CAP_PROP_FRAME_WIDTH)),
             static_cast<int>(capture_->get(cv::CAP_PROP_FRAME_HEIGHT))};
    if (kind_ == CaptureKind::video && frames_ == 0) pacer_ = Pacer(capture_->get(cv::CAP_PROP_FPS));
    takeJpegsUndecoded();
  } catch (const cv::Exception& problem) {
    if (capture_) capture_->release();
    return fail("{}: does not open: {}", name(), verbatim(problem.err));
  }
  return {};
}

/// Requests undecoded JPEGs: OpenCV and FFmpeg decode a damaged one without an error.
void CaptureCamera::takeJpegsUndecoded() {
  jpegs_ = meansJpeg(capture_->get(cv::CAP_PROP_FOURCC)) &&
           (kind_ == CaptureKind::device ? capture_->set(cv::CAP_PROP_CONVERT_RGB, 0)
                                         : capture_->set(cv::CAP_PROP_FORMAT, -1));
}

bool CaptureCamera::grab(cv::Mat& out) {
  try {
    return capture_->read(out) && !out.empty();
  } catch (const cv::Exception&) {
    return false;
  }
}

CaptureCamera::Got CaptureCamera::read(cv::Mat& picture) {
  cv::Mat bytes;
  if (!grab(jpegs_ ? bytes : picture)) return Got::nothing;
  if (!jpegs_) return Got::picture;
  auto decoded = decodeJpeg({bytes.data, bytes.total() * bytes.elemSize()}, size_);
  watch_.saw(!decoded);
  if (!decoded) {
    damage_ = decoded.error().message;
    ++damaged_;
  }
  if (!watch_.believed() || !decoded) return Got::damaged;
  picture = std::move(*decoded);
  return Got::picture;
}

Result<void> CaptureCamera::rewind() {
  capture_->release();
  return openCapture();
}

tl::unexpected<Error> CaptureCamera::ended() {
  capture_->release();
  last_attempt_ = Clock::now();
  return kind_ == CaptureKind::video ? fail("{}: holds no picture", name())
                                     : fail("{}: gives no picture any more", name());
}

Result<CameraFrame> CaptureCamera::next() {
  if (!capture_->isOpened()) {
    std::this_thread::sleep_until(last_attempt_ + kRetryAfter);
    if (const auto opened = openCapture(); !opened) return tl::unexpected(opened.error());
  }
  const Instant began = Clock::now();
  CameraFrame frame;
  bool rewound = false;
  for (;;) {
    if (kind_ == CaptureKind::video && !rewound) pacer_.wait();
    const Got got = read(frame.picture);
    if (got == Got::picture) break;
    if (got == Got::damaged) {
      if (Clock::now() - began > kLongestDamage) return fail("{}: sends damaged pictures: {}", name(), damage_);
      continue;
    }
    if (kind_ != CaptureKind::video || rewound) return ended();
    if (const auto opened = rewind(); !opened) return tl::unexpected(opened.error());  // its end: again from the start
    rewound = true;
  }
  frame.taken = Clock::now();
  frame.number = ++frames_;
  return frame;
}

}  // namespace fyd::device
