#include "widgets/scene/scene_worker.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

namespace fyd::widgets {
namespace {

constexpr double kRest = 0.15;        // pause after a picture, as a share of the time it took
constexpr double kStay = 1.1;         // of kAim_ms: up to here the last picture's level is kept, against flicker
constexpr double kLearn = 0.2;        // weight of a measurement above the known cost
constexpr double kForget = 0.999;     // decay per picture: a level that was too slow is tried again some seconds later
constexpr double kCoarsest_px = 4.0;  // largest block side, in widget pixels: coarser pictures are unrecognisable
constexpr double kFill_ns = 3.0;      // a pixel
constexpr double kRay_ns = 18.0;
constexpr double kLearnFrom = 0.3;  // share of the picture's pixels: below it fixed costs dominate

/// Processor time of this thread. Wall time would make pictures coarse because of the load of other programs.
double processor_ms() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

/// Estimated cost of a pixel; too low on purpose, so that each level is tried.
double guess_ns(SceneFineness f) { return kFill_ns + kRay_ns * f.samples / (f.block * f.block); }

}  // namespace

SceneWorker::SceneWorker() {
  setObjectName(QStringLiteral("scene"));
  forget();
}

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

std::size_t SceneWorker::choose(const SceneRequest& request) const {
  if (request.finest) return 0;
  std::size_t coarsest = 0;
  for (std::size_t level = 0; level < kLevels.size(); ++level) {
    if (kLevels[level].block > kCoarsest_px * request.shot.pixel_ratio) break;
    coarsest = level;
    const double expected_ms =
        1e-6 * pixel_ns_[level] * static_cast<double>(caster_.pixelsToCast(request.shot, kLevels[level]));
    if (expected_ms <= (level == level_ ? kStay : 1.0) * kAim_ms) return level;
  }
  return coarsest;
}

void SceneWorker::forget() {
  for (std::size_t level = 0; level < kLevels.size(); ++level) pixel_ns_[level] = guess_ns(kLevels[level]);
}

void SceneWorker::learn(std::size_t level, std::size_t pixels, double took_ms) {
  for (std::size_t each = 0; each < kLevels.size(); ++each) {
    pixel_ns_[each] = std::max(guess_ns(kLevels[each]), kForget * pixel_ns_[each]);
  }
  const QSize size = caster_.picture().shot.size_px;
  if (static_cast<double>(pixels) < kLearnFrom * size.width() * size.height()) return;
  const double measured_ns = 1e6 * took_ms / static_cast<double>(pixels);
  double& known_ns = pixel_ns_[level];
  known_ns = std::min(measured_ns, known_ns + kLearn * (measured_ns - known_ns));  // one slow picture is weak evidence
}

void SceneWorker::serve(const SceneRequest& request) {
  if (request.meshes && request.meshes != caster_.meshes() && request.meshes != failed_) {
    const SceneMeshes* mine = request.meshes.get();
    if (!caster_.build(request.meshes, [this, mine] { return !end_ && wanted_ == mine; })) {
      if (end_ || wanted_ != mine) return;
      failed_ = request.meshes;
    }
    forget();
  }
  const double begun_ms = processor_ms();
  caster_.move(request.parts, request.shapes, request.shot);
  level_ = choose(request);
  const std::size_t pixels = caster_.pixelsToCast(request.shot, kLevels[level_]);
  // A newer request cancels the long work for smooth edges.
  const bool done = caster_.cast(request.shot, kLevels[level_],
                                 [&] { return !end_ && !(request.finest && asked_.load() != nullptr); });
  if (!done && caster_.problem().isEmpty()) return;
  const double took_ms = processor_ms() - begun_ms;
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
