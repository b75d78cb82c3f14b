// The camera's pictures to a video: .mkv without loss (FFV1), .avi small (Motion JPEG).
//
// A video has a constant rate, a camera only roughly: each frame shows the picture that was newest then, to half a
// frame's time, so that the video keeps the recording's time; a picture is repeated where the camera was late.
// OUT.times.csv gives for each frame the picture's number and the true time at which it was taken.
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/codecs/codecs.h"
#include "core/base/median.h"
#include "core/export/export_csv_text.h"
#include "core/export/export_selection.h"
#include "core/recording/file/export_file.h"

namespace fyd::exports {
namespace {

constexpr std::uint64_t kPicturesForRate = 120;
/// Share of the export's time that writing takes, for the progress bar; the rest is reading the file again.
constexpr double kFramesShare = 0.6;
constexpr double kUsualRate_Hz = 30.0;
constexpr double kHighestRate_Hz = 1000.0;
/// Longer breaks between pictures are cut to this.
constexpr double kLongestStill_s = 10.0;

const cv::Mat& chosen(const recording::RecordedPicture& picture, bool region) {
  return region ? picture.region : picture.whole;
}

/// From the median distance of the first pictures; a whole number when it is nearly one.
Result<double> rateOf(const recording::Recording& recording, std::uint64_t first, std::uint64_t end,
                      const recording::Progress& progress) {
  std::vector<double> distances_s;
  double last_s = pipeline::kNone;
  for (std::uint64_t i = first; i < std::min(end, first + kPicturesForRate); ++i) {
    if (auto told = recording::tellProgress(progress, 0.0); !told) return tl::unexpected(told.error());
    const auto picture = recording.picture(i);
    if (!picture) return tl::unexpected(picture.error());
    if (picture->time_s > last_s) distances_s.push_back(picture->time_s - last_s);
    last_s = picture->time_s;
  }
  if (distances_s.empty()) return kUsualRate_Hz;
  const double rate_Hz = std::clamp(1.0 / median(std::move(distances_s)), 0.1, kHighestRate_Hz);
  const double whole_Hz = std::round(rate_Hz);
  return whole_Hz >= 1.0 && std::abs(rate_Hz - whole_Hz) < 0.03 * whole_Hz ? whole_Hz : rate_Hz;
}

/// Writes frames; a video's size is that of its first picture, rounded to even numbers as coders demand.
class FrameWriter {
 public:
  FrameWriter(std::string path, bool lossless, double rate_Hz)
      : path_(std::move(path)), lossless_(lossless), rate_Hz_(rate_Hz) {}

  Result<void> show(const cv::Mat& picture, std::uint64_t times) {
    if (!writer_) {
      size_ = picture.size();
      colour_ = picture.channels() == 3;
      constexpr std::array kLossless{'F', 'F', 'V', '1'}, kSmall{'M', 'J', 'P', 'G'};
      const cv::Size even(size_.width + size_.width % 2, size_.height + size_.height % 2);
      writer_ = codecs::videoWriter(path_, lossless_ ? kLossless : kSmall, rate_Hz_, even, colour_);
      if (!writer_->isOpened()) {
        return fail("no video can be written: OpenCV has no coder for it, or the disk is full");
      }
    }
    if (picture.size() != size_) {
      return fail("a picture is {} × {} px, those before {} × {}; choose a time with one size", picture.cols,
                  picture.rows, size_.width, size_.height);
    }
    cv::Mat frame = picture;
    if (picture.channels() == 3 && !colour_) cv::cvtColor(picture, frame, cv::COLOR_BGR2GRAY);
    if (picture.channels() == 1 && colour_) cv::cvtColor(picture, frame, cv::COLOR_GRAY2BGR);
    cv::copyMakeBorder(frame, frame, 0, size_.height % 2, 0, size_.width % 2, cv::BORDER_REPLICATE);
    for (std::uint64_t i = 0; i < times; ++i) writer_->write(frame);
    frames_ += times;
    return {};
  }

  /// OpenCV does not report a failed write: the file is read again, and must hold every frame.
  Result<void> finish(const recording::Progress& progress) {
    writer_.reset();
    const auto reader = codecs::videoCapture();
    reader->open(path_, cv::CAP_FFMPEG);
    std::uint64_t found = 0;
    while (reader->grab()) {
      const double done = static_cast<double>(++found) / static_cast<double>(std::max(found, frames_));
      if (auto told = recording::tellProgress(progress, done); !told) return told;
    }
    if (found != frames_) return fail("only {} of {} frames could be written; is the disk full?", found, frames_);
    return {};
  }

  [[nodiscard]] std::uint64_t frames() const { return frames_; }

 private:
  std::string path_;
  bool lossless_;
  double rate_Hz_;
  std::unique_ptr<cv::VideoWriter> writer_;
  cv::Size size_;
  bool colour_ = false;
  std::uint64_t frames_ = 0;
};

/// A picture to be written when the next one's time is known, which gives the number of its frames.
struct Waiting {
  cv::Mat picture;
  std::uint64_t index = 0;
  std::uint64_t number = 0;
  double time_s = 0.0;
};

Result<void> show(const Waiting& waiting, double next_s, double start_s, FrameWriter& video,
                  recording::ExportFile& times, ExportResult& result) {
  const double shown_s = std::min(next_s, waiting.time_s + kLongestStill_s) - start_s;
  const auto until = static_cast<std::uint64_t>(std::max(0.0, std::round(shown_s * result.rate_Hz)));
  if (until <= video.frames()) {
    ++result.left_out;
    return {};
  }
  const std::uint64_t repeats = until - video.frames();
  std::string lines;
  for (std::uint64_t frame = video.frames(); frame < until; ++frame) {
    appendNumber(lines, static_cast<double>(frame));
    lines += fmt::format(",{},{},{}\n", waiting.index, waiting.number, waiting.time_s);
  }
  if (auto shown = video.show(waiting.picture, repeats); !shown) return shown;
  ++result.pictures;
  result.repeated += repeats - 1;
  return times.write(lines);
}

Result<void> writeFrames(const recording::Recording& recording, std::uint64_t first, const ExportOptions& options,
                         FrameWriter& video, recording::ExportFile& times, ExportResult& result) {
  const recording::Progress progress = recording::partOf(options.progress, 0.0, kFramesShare);
  std::optional<Waiting> waiting;
  double start_s = 0.0;
  if (auto titled = times.write("frame,picture,camera_number,time_s\n"); !titled) return titled;
  for (std::uint64_t i = first; i < recording.info().frames; ++i) {
    const double done = static_cast<double>(i - first) / static_cast<double>(recording.info().frames - first);
    if (auto told = recording::tellProgress(progress, done); !told) return told;
    const auto picture = recording.picture(i);
    if (!picture) return tl::unexpected(picture.error());
    if (picture->time_s > options.to_s) break;
    const cv::Mat& pixels = chosen(*picture, options.region);
    if (pixels.empty()) continue;  // the region lay outside the picture
    if (!waiting) {
      start_s = picture->time_s;
    } else if (picture->time_s <= waiting->time_s) {
      continue;  // a video goes forward only
    } else if (auto shown = show(*waiting, picture->time_s, start_s, video, times, result); !shown) {
      return shown;
    } else if (picture->time_s - waiting->time_s > kLongestStill_s) {
      // The break was cut: later frames are counted from its shortened end.
      start_s += picture->time_s - waiting->time_s - kLongestStill_s;
    }
    waiting = Waiting{pixels, i, picture->number, picture->time_s};
  }
  if (!waiting) {
    return options.region ? fail("no region of interest from {} s to {} s", options.from_s, options.to_s)
                          : fail("no picture from {} s to {} s", options.from_s, options.to_s);
  }
  return show(*waiting, waiting->time_s + 1.0 / result.rate_Hz, start_s, video, times, result);
}

}  // namespace

Result<ExportResult> exportVideo(const recording::Recording& recording, const std::string& path,
                                 const ExportOptions& options) {
  if (const auto range = selectRows(recording, options); !range) return tl::unexpected(range.error());
  const auto first = pictureIndexAt(recording, options.from_s);
  if (!first) return tl::unexpected(first.error());
  const auto rate_Hz = rateOf(recording, *first, recording.info().frames, options.progress);
  if (!rate_Hz) return tl::unexpected(rate_Hz.error());

  ExportResult result{.files = exportFiles(path), .rate_Hz = *rate_Hz};
  auto file = recording::ExportFile::create(path, options.replace);
  if (!file) return tl::unexpected(file.error());
  auto times = recording::ExportFile::create(result.files.back(), options.replace);
  if (!times) return tl::unexpected(times.error());

  FrameWriter video(file->temporary(), extensionOf(path) == ".mkv", *rate_Hz);
  auto done = writeFrames(recording, *first, options, video, *times, result);
  if (done) done = video.finish(recording::partOf(options.progress, kFramesShare, 1.0));
  if (!done) return fail(about(path, done.error().message));
  done = times->commit();
  if (done) done = file->commit();
  if (!done) return tl::unexpected(done.error());
  return result;
}

}  // namespace fyd::exports
