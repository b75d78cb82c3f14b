// A scene that Python touches.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/python/common.h"
#include "core/scene/felt_scene.h"

namespace fyd::python {

class FeltScene {
 public:
  explicit FeltScene(scene::FeltScene built)
      : start_(std::make_shared<const scene::FeltScene>(std::move(built))), now_(Now{*start_}) {}

  /// As it was built.
  [[nodiscard]] std::shared_ptr<const scene::FeltScene> start() const { return start_; }
  scene::SceneTouch step(const Vec3& probe_mm, double time_s) {
    return now_.run([&](Now& now) { return now.step(probe_mm, time_s); });
  }
  /// Steps along a way; each(touch, texture_g) after each step. @throws Refusal that names the first row whose time is
  /// not after the one before and after the last step, and steps nothing then
  template <class Each>
  void run(std::span<const Vec3> probe_mm, std::span<const double> time_s, Each&& each) {
    now_.run([&](Now& now) {
      now.checkTimes(time_s);
      for (std::size_t i = 0; i < probe_mm.size(); ++i) {
        const scene::SceneTouch touch = now.step(probe_mm[i], time_s[i]);
        each(touch, now.felt.texture_g());
      }
    });
  }
  void reset() {
    now_.run([this](Now& now) { now = Now{*start_}; });
  }

 private:
  struct Now {
    scene::FeltScene felt;
    double last_s = -std::numeric_limits<double>::infinity();  // of the steps with a time

    scene::SceneTouch step(const Vec3& probe_mm, double time_s) {
      if (std::isfinite(time_s)) last_s = std::max(last_s, time_s);
      return felt.step(probe_mm, time_s);
    }
    void checkTimes(std::span<const double> time_s) const {
      double before_s = last_s;
      for (std::size_t i = 0; i < time_s.size(); ++i) {
        if (!std::isfinite(time_s[i])) continue;
        if (time_s[i] <= before_s)
          throw Refusal{
              fmt::format("time_s: row {} is {} s; expected more than {} s, {}", i, time_s[i], before_s,
                          before_s == last_s ? "the last step's, or reset() first" : "that of the row before")};
        before_s = time_s[i];
      }
    }
  };
  std::shared_ptr<const scene::FeltScene> start_;
  Shared<Now> now_;
};

}  // namespace fyd::python
