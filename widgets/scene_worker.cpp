#include "widgets/scene_worker.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <cmath>

namespace fyd::widgets {
namespace {

constexpr double kRest = 0.15;       // of the time that a picture took
constexpr double kStay = 1.1;        // of the aim: as fine as the last picture up to here, so that it does not flicker
constexpr double kLearn = 0.3;       // of a new measurement, in the mean
constexpr double kForget = 0.999;    // a picture: what was once too slow is tried again after some seconds of motion
constexpr double kGuess_ns = 30.0;   // a ray, before the first picture
constexpr double kFinerCosts = 2.0;  // times as much, until it was measured: too little, so that it is tried
constexpr double kLearnFrom = 0.3;   // of the picture's pixels: the cost of fewer is mostly another

double raysPerPixel(SceneFineness f) { return static_cast<double>(f.samples) / (f.block * f.block); }

}  // namespace

SceneWorker::SceneWorker() { setObjectName(QStringLiteral("scene")); }

SceneWorker::~SceneWorker() {
  end_ = true;
  wake_.release();
  wait();
  delete asked_.exchange(nullptr);
  delete answered_.exchange(nullptr);
}

void SceneWorker::ask(std::unique_ptr<SceneRequest> request) {
  wanted_ = request->meshes.get();
  const std::unique_ptr<SceneRequest> passed_over(asked_.exchange(request.release()));
  if (!passed_over) wake_.release();
}

std::unique_ptr<SceneAnswer> SceneWorker::take() { return std::unique_ptr<SceneAnswer>(answered_.exchange(nullptr)); }

void SceneWorker::run() {
#ifdef __linux__
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);  // of this thread alone
#endif
  while (true) {
    wake_.acquire();
    if (end_) return;
    busy_ = true;
    const std::unique_ptr<SceneRequest> request(asked_.exchange(nullptr));
    if (request) serve(*request);
    busy_ = false;
  }
}

double SceneWorker::expected_ns(std::size_t level) const {
  if (pixel_ns_[level] > 0.0) return pixel_ns_[level];
  for (std::size_t coarser = level + 1; coarser < kLevels.size(); ++coarser) {
    if (pixel_ns_[coarser] > 0.0) {
      return pixel_ns_[coarser] * std::pow(kFinerCosts, static_cast<double>(coarser - level));
    }
  }
  return kGuess_ns * raysPerPixel(kLevels[level]);
}

std::size_t SceneWorker::choose(const SceneRequest& request) const {
  if (request.finest) return 0;
  for (std::size_t level = 0; level < kLevels.size(); ++level) {
    const double expected_ms =
        1e-6 * expected_ns(level) * static_cast<double>(caster_.pixelsToCast(request.shot, kLevels[level]));
    if (expected_ms <= (level == level_ ? kStay : 1.0) * kAim_ms) return level;
  }
  return kLevels.size() - 1;
}

void SceneWorker::learn(std::size_t level, std::size_t pixels, double took_ms) {
  for (double& each : pixel_ns_) each *= kForget;
  const QSize size = caster_.picture().shot.size_px;
  if (static_cast<double>(pixels) < kLearnFrom * size.width() * size.height()) return;
  const double measured_ns = 1e6 * took_ms / static_cast<double>(pixels);
  double& known_ns = pixel_ns_[level];
  known_ns = known_ns > 0.0 ? known_ns + kLearn * (measured_ns - known_ns) : measured_ns;
}

void SceneWorker::serve(const SceneRequest& request) {
  QElapsedTimer clock;
  clock.start();
  if (request.meshes && request.meshes != caster_.meshes() && request.meshes != failed_) {
    const SceneMeshes* mine = request.meshes.get();
    if (!caster_.build(request.meshes, [this, mine] { return !end_ && wanted_ == mine; })) {
      if (end_ || wanted_ != mine) return;
      failed_ = request.meshes;
    }
    pixel_ns_ = {};
  }
  const auto begun_ns = clock.nsecsElapsed();
  caster_.move(request.parts, request.shapes, request.shot);
  level_ = choose(request);
  const std::size_t pixels = caster_.pixelsToCast(request.shot, kLevels[level_]);
  // A newer request ends the long work for smooth edges.
  const bool done = caster_.cast(request.shot, kLevels[level_],
                                 [&] { return !end_ && !(request.finest && asked_.load() != nullptr); });
  if (!done && caster_.problem().isEmpty()) return;
  const double took_ms = 1e-6 * static_cast<double>(clock.nsecsElapsed() - begun_ns);
  auto answer = std::make_unique<SceneAnswer>();
  answer->picture = caster_.picture();
  answer->picture.took_ms = took_ms;
  answer->meshes = request.meshes;
  answer->number = request.number;
  answer->problem = caster_.problem();
  if (done) learn(level_, pixels, took_ms);
  const std::unique_ptr<SceneAnswer> passed_over(answered_.exchange(answer.release()));
  if (!end_) usleep(static_cast<useconds_t>(std::min(kRest * 1e3 * took_ms, 50'000.0)));
}

}  // namespace fyd::widgets
