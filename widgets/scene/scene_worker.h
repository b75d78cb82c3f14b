// The thread that casts a scene's pictures, at low priority and with at most seven eighths of a core, so that it does
// not disturb the haptic loop. Pictures are as fine as the time allows, coarser while too much moves.
//
// Both sides exchange a latest value without a lock, so the window never waits for this thread.
#pragma once

#include <QThread>
#include <atomic>
#include <memory>
#include <semaphore>

#include "widgets/scene/scene_caster.h"

namespace fyd::widgets {

/// All that a picture needs. Bodies and shapes are shared, so asking again is cheap.
struct SceneRequest {
  std::shared_ptr<const SceneMeshes> meshes;
  std::vector<SceneShape> shapes;
  SceneParts parts;
  SceneShot shot;
  std::uint64_t number = 0;  ///< of the request; the answer's too
  bool finest = false;       ///< nothing moves: take the time for smooth edges
};

struct SceneAnswer {
  ScenePicture picture;
  std::shared_ptr<const SceneMeshes> meshes;  ///< of the picture
  std::uint64_t number = 0;
  QString problem;  ///< Embree's error message; the picture is then an old one
};

class SceneWorker : public QThread {
 public:
  static constexpr double kAim_ms = 13.0;  ///< time of a picture while something moves: 60 a second with a margin
  static constexpr int kNice = 10;
  /// From the finest, for what stands still, to the coarsest.
  static constexpr std::array<SceneFineness, 5> kLevels = {{{1, 4}, {1, 1}, {2, 1}, {4, 1}, {8, 1}}};

  SceneWorker();
  ~SceneWorker() override;

  /// Replaces a request that was not begun yet.
  void ask(std::unique_ptr<SceneRequest> request);
  /// The newest answer since the last call, or null.
  [[nodiscard]] std::unique_ptr<SceneAnswer> take();
  [[nodiscard]] bool busy() const { return busy_.load() || asked_.load() != nullptr; }

 protected:
  void run() override;

 private:
  void serve(const SceneRequest& request);
  [[nodiscard]] std::size_t choose(const SceneRequest& request) const;
  void forget();
  void learn(std::size_t level, std::size_t pixels, double took_ms);

  SceneCaster caster_;
  std::atomic<SceneRequest*> asked_ = nullptr;
  std::atomic<SceneAnswer*> answered_ = nullptr;
  std::atomic<const SceneMeshes*> wanted_ = nullptr;  ///< bodies of the newest request: others need not be built
  std::atomic<bool> busy_ = false;
  std::atomic<bool> end_ = false;
  std::counting_semaphore<> wake_{0};
  std::shared_ptr<const SceneMeshes> failed_;      ///< could not be built: not tried again
  std::array<double, kLevels.size()> pixel_ns_{};  ///< what a pixel of the picture costs the processor
  std::size_t level_ = 1;                          ///< of the last picture
};

}  // namespace fyd::widgets
