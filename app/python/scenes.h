// A scene that Python touches.
#pragma once

#include "app/python/common.h"
#include "core/scene/felt_scene.h"

namespace fyd::python {

class FeltScene {
 public:
  explicit FeltScene(scene::FeltScene built)
      : start_(std::make_shared<const scene::FeltScene>(std::move(built))), now_(*start_) {}

  /// As it was built.
  [[nodiscard]] std::shared_ptr<const scene::FeltScene> start() const { return start_; }
  template <class Work>
  auto run(Work&& work) {
    return now_.run(std::forward<Work>(work));
  }

 private:
  std::shared_ptr<const scene::FeltScene> start_;
  Shared<scene::FeltScene> now_;
};

}  // namespace fyd::python
