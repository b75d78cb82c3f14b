// Finger detector: time for one picture beside its error over labelled pictures.
#include <cmath>
#include <functional>

#include <opencv2/core/utility.hpp>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/detector_opencv.h"
#include "app/bench/parts/labelled_pictures.h"
#include "app/bench/parts/table.h"
#include "core/sensing/finger_detector.h"

namespace fyd::bench {
namespace {

int frames() { return wholeOrQuick(2000, 100); }

struct Contestant {
  std::string name;
  std::string pixels;
  std::function<sensing::FingerDetection(const ImageView&)> detect;
  std::vector<double> ns;
  double squares = 0.0;
  double worst = 0.0;
  double area_scale = 1.0;  // to pixels of the camera
  double area_squares = 0.0;
  double area_worst = 0.0;
  int found = 0;

  void look(const ImageView& picture, const FrameLabel& truth) {
    const auto start = std::chrono::steady_clock::now();
    const sensing::FingerDetection seen = detect(picture);
    ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    if (!seen.contact) return;
    ++found;
    // The thesis' own millimetres would show its scale's error, not its centroid's.
    const sensing::FingerParameters p;
    const double error =
        std::hypot((seen.x_px - truth.x_px) * p.scale_x_mm_per_px, (seen.y_px - truth.y_px) * p.scale_y_mm_per_px);
    const double area = seen.area_px * area_scale / truth.area_px - 1.0;
    squares += error * error;
    worst = std::max(worst, error);
    area_squares += area * area;
    area_worst = std::max(area_worst, std::abs(area));
  }
};

Contestant fyd(const std::string& name, const std::string& pixels, const sensing::FingerParameters& parameters) {
  auto detector = std::make_shared<sensing::FingerDetector>(parameters);
  return {.name = name, .pixels = pixels, .detect = [detector](const ImageView& p) { return detector->detect(p); }};
}

}  // namespace

Table bench_detector() {
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  std::vector<Contestant> all;
  auto baseline = std::make_shared<OpenCvFinger>();
  all.push_back({.name = "baseline: adaptive, call by call with OpenCV",
                 .pixels = "220 × 150",
                 .detect = [baseline](const ImageView& p) { return baseline->detect(p); }});
  sensing::FingerParameters parameters;
  parameters.mode = sensing::FingerMode::thesis;
  all.push_back(fyd("thesis", "160 × 120", parameters));
  all.back().area_scale = 220.0 * 150.0 / (160.0 * 120.0);
  parameters.mode = sensing::FingerMode::adaptive;
  for (const int stride : {1, 2, 3, 4}) {
    parameters.stride_px = stride;
    all.push_back(fyd(stride == 1 ? "adaptive (default)" : fmt::format("adaptive, every {} px", stride),
                      fmt::format("{} × {}", (220 + stride - 1) / stride, (150 + stride - 1) / stride), parameters));
  }

  LabelledPictures pictures(2024);
  for (int i = 0; i < frames(); ++i) {
    pictures.next();
    for (Contestant& c : all) c.look(pictures.picture(), pictures.label());
  }
  cv::setNumThreads(threads);

  Table table{.subject = "detector",
              .title = "Finger detector: time and error over labelled pictures",
              .columns = {{"method", Role::method},
                          "pixels used",
                          {"p50", "µs", Role::cost},
                          {"p99", "µs"},
                          "times faster by p50",
                          {"found", "%"},
                          {"centroid RMS", "mm", Role::error},
                          {"centroid worst", "mm"},
                          {"area RMS", "%"},
                          {"area worst", "%"}}};
  const double base_ns = quantiles(all.front().ns).p50;
  for (Contestant& c : all) {
    const Quantiles t = quantiles(c.ns);
    const double n = c.found;
    table.rows.push_back({c.name, c.pixels, number(t.p50 / 1e3), number(t.p99 / 1e3), number(base_ns / t.p50),
                          number(100.0 * n / frames(), 4), number(std::sqrt(c.squares / n)), number(c.worst),
                          number(100 * std::sqrt(c.area_squares / n)), number(100 * c.area_worst)});
  }
  table.notes = {
      fmt::format(
          "{} pictures of 320 × 240 grey, another finger in each, another light every {}: noise σ 0–8, slope of "
          "the light to 40 %, lens fall-off to 15 %, radius 10–32 px, blur σ 0–2 px, contrast 45–75 %, a third "
          "near or over the region's edge (truth is then the visible part). Error over the pictures found.",
          frames(), LabelledPictures::kFramesPerLight),
      "The baseline has the same light surface, components and sums, one OpenCV call and one whole picture after the "
      "other; OpenCV on one thread. thesis: its threshold of 210 takes a dim cloth for a finger; its area is a count.",
      "Synthetic discs: what real fingers, fabric weave and cast shadows do is not in these figures."};
  return table;
}

}  // namespace fyd::bench
