// The finger detector on NumPy's pictures.
#include "app/python/described.h"
#include "app/python/parameters.h"
#include "core/sensing/finger_detector.h"

#include <fmt/format.h>

#include <cstdlib>

namespace fyd::python {
namespace {

using sensing::FingerDetection;
using Detector = Shared<sensing::FingerDetector>;
using Pixels = py::array_t<std::uint8_t, py::array::c_style>;

/// A picture as the detector takes it: a view, where the pixels of a row follow each other and no rows overlap, and a
/// copy otherwise.
struct Seen {
  py::array kept;
  ImageView view;
};

Seen seen(const py::array& picture) {
  refuseMask(picture);
  const bool fits = picture.dtype().equal(py::dtype::of<std::uint8_t>()) &&
                    (picture.ndim() == 2 || (picture.ndim() == 3 && (picture.shape(2) == 1 || picture.shape(2) == 3)));
  if (!fits)
    throw Refusal{
        fmt::format("picture: an array of {}, shape {}; expected uint8 of shape (height, width) for grey, or "
                    "(height, width, 3) for blue, green, red",
                    std::string(py::str(picture.dtype())), shapeOf(picture))};
  constexpr py::ssize_t kMost = 1 << 15;
  if (picture.shape(0) > kMost || picture.shape(1) > kMost)
    throw Refusal{fmt::format("picture: shape {}; at most {} px a side", shapeOf(picture), kMost)};
  const int channels = picture.ndim() == 2 ? 1 : static_cast<int>(picture.shape(2));
  const bool rows_are_dense =
      picture.strides(1) == channels && (picture.ndim() == 2 || channels == 1 || picture.strides(2) == 1);
  const bool rows_are_apart = std::abs(picture.strides(0)) >= picture.shape(1) * channels;
  Seen out{rows_are_dense && rows_are_apart ? picture : py::array(Pixels::ensure(picture)), {}};
  out.view = {.data = static_cast<const std::uint8_t*>(out.kept.data()),
              .width = static_cast<int>(out.kept.shape(1)),
              .height = static_cast<int>(out.kept.shape(0)),
              .stride = out.kept.strides(0),
              .channels = channels};
  return out;
}

}  // namespace

void addSensing(py::module_& module) {
  py::class_<Detector>(module, "FingerDetector",
                       "Finds the finger in pictures of the cloth seen from below. It learns the light and follows the "
                       "finger from picture to picture.")
      .def(py::init([](const ParameterSet* parameters) {
             return std::make_unique<Detector>(orDefaults(parameters).sensing.finger);
           }),
           py::arg("parameters") = py::none(), "By the parameters sensing.finger_… and sensing.roi_… Units: their own.")
      .def(
          "detect",
          [](Detector& detector, const py::array& picture) {
            const Seen one = seen(picture);
            return detector.run([&](sensing::FingerDetector& each) { return each.detect(one.view); });
          },
          py::arg("picture"),
          "Where the finger is in a picture, uint8 of shape (height, width) or (height, width, 3): position [mm], area "
          "[px] and [mm²]. A picture that shows none says why.")
      .def(
          "detect_all",
          [](Detector& detector, const py::sequence& pictures) {
            std::vector<Seen> all;
            all.reserve(pictures.size());
            for (const auto& picture : pictures) all.push_back(seen(picture.cast<py::array>()));
            std::vector<FingerDetection> found(all.size());
            detector.run([&](sensing::FingerDetector& each) {
              for (std::size_t i = 0; i < all.size(); ++i) found[i] = each.detect(all[i].view);
            });
            return columnsOf(std::move(found));
          },
          py::arg("pictures"),
          "One after the other; columns by name, as FingerDetection's values, in [mm], [px] and [mm²]. Other threads "
          "go "
          "on meanwhile.")
      .def(
          "reset", [](Detector& detector) { detector.run([](sensing::FingerDetector& each) { each.reset(); }); },
          "Forgets light and last finger, as for a picture on its own. Units: none.")
      .def_property_readonly(
          "region_px",
          [](Detector& detector) {
            const auto r = detector.run([](sensing::FingerDetector& each) { return each.region(); });
            return py::make_tuple(r.x, r.y, r.width, r.height);
          },
          "Left edge, upper edge, width and height of what was looked at in the last picture [px]")
      .def(
          "overlay",
          [](Detector& detector) {
            const auto r = detector.run([](sensing::FingerDetector& each) { return each.region(); });
            py::array_t<std::uint8_t> mask({r.height, r.width});
            std::fill_n(mask.mutable_data(), mask.size(), std::uint8_t{0});
            const std::span<std::uint8_t> pixels(mask.mutable_data(), static_cast<std::size_t>(mask.size()));
            detector.run([&](sensing::FingerDetector& each) { each.drawOverlay(pixels); });
            return mask;
          },
          "Of the last picture's region: 255 where the finger is, 128 where else it is dark, 0 for cloth [grey "
          "value].");
}

}  // namespace fyd::python
