#include "app/python/common.h"

#include <chrono>
#include <thread>

#include <cxxabi.h>

#include "core/base/parameter.h"
#include "core/texture/surface_model.h"
#include "core/texture/texture_parameters.h"

namespace fyd::python {

OthersGoOn::~OthersGoOn() {
  try {
    PyEval_RestoreThread(state_);
  } catch (const abi::__forced_unwind&) {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

Hdf5Turn::Hdf5Turn() {
  try {
    if (!py::module_::import("sys").attr("modules").contains("h5py")) return;
    h5py_lock_ = py::module_::import("h5py._objects").attr("phil");
    h5py_lock_.attr("acquire")();
  } catch (py::error_already_set& error) {  // as the interpreter ends, or another h5py: there is no such lock
    h5py_lock_ = py::object();
    error.discard_as_unraisable("fyd: h5py's lock");
  }
}

Hdf5Turn::~Hdf5Turn() {
  if (!h5py_lock_) return;
  // By the C interface, for pybind11 can throw even while it takes an error.
  const auto released = py::reinterpret_steal<py::object>(PyObject_CallMethod(h5py_lock_.ptr(), "release", nullptr));
  if (released) return;
  const auto place = py::reinterpret_steal<py::object>(PyUnicode_FromString("fyd: h5py's lock"));
  PyErr_WriteUnraisable(place.ptr());
}

py::str textOf(const std::string& text) {
  PyObject* out = PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
  if (out == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(out);
}

std::vector<py::str> textOf(const std::vector<std::string>& texts) {
  std::vector<py::str> out;
  out.reserve(texts.size());
  for (const std::string& text : texts) out.push_back(textOf(text));
  return out;
}

void refuseMask(const py::handle& given) {
  if (py::hasattr(given, "mask") && py::hasattr(given, "filled") && given.attr("mask").attr("any")().cast<bool>())
    throw py::type_error("a mask hides some of these numbers; expected all, as of filled(numpy.nan)");
}

bool isTruth(const py::handle& value) {
  return py::isinstance<py::bool_>(value) || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
}

bool isRealNumber(const py::handle& value) {
  if (PyFloat_Check(value.ptr()) != 0 || PyLong_Check(value.ptr()) != 0) return true;
  if (PyUnicode_Check(value.ptr()) != 0 || PyComplex_Check(value.ptr()) != 0) return false;
  // NumPy's scalars of every kind, texts and dates too, say that they are a number.
  const py::object dtype = py::getattr(value, "dtype", py::none());
  if (py::hasattr(dtype, "kind"))
    return std::string_view("biuf").find(py::str(dtype.attr("kind")).cast<std::string>()) != std::string_view::npos;
  return py::hasattr(value, "__index__") || py::hasattr(value, "__float__");
}

namespace {

py::array realNumbers(const py::handle& given) {
  refuseMask(given);
  auto array = py::array::ensure(given);
  if (!array) return array;
  const char kind = array.dtype().kind();
  if (std::string_view("biufO").find(kind) == std::string_view::npos)
    throw py::type_error(
        fmt::format("an array of {}; expected real numbers", std::string(py::str(py::object(array.dtype())))));
  if (kind == 'O') {  // NumPy makes numbers of texts in it, and NaN of None
    for (const auto& item : array.attr("flat"))
      if (!isRealNumber(item))
        throw py::type_error(
            fmt::format("an array with {}; expected real numbers", std::string(py::str(py::repr(item)))));
  }
  return array;
}

}  // namespace

Numbers::Numbers(const py::handle& given) : array_t(ensure(realNumbers(given))) {}

std::string shapeOf(const py::array& array) { return py::str(array.attr("shape")); }

std::span<const double> vector(const Numbers& array, const char* name) {
  if (array.ndim() != 1) throw Refusal{fmt::format("{}: shape {}; expected (n,)", name, shapeOf(array))};
  return {array.data(), static_cast<std::size_t>(array.size())};
}

std::span<const Vec3> vectors(const Numbers& array, const char* name) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw Refusal{fmt::format("{}: shape {}; expected (n, 3)", name, shapeOf(array))};
  return {reinterpret_cast<const Vec3*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

Vec3 point(const Numbers& array, const char* name) {
  if (array.ndim() != 1 || array.shape(0) != 3)
    throw Refusal{fmt::format("{}: shape {}; expected (3,)", name, shapeOf(array))};
  return {array.at(0), array.at(1), array.at(2)};
}

py::array_t<double> arrayOf(std::vector<Vec3> values) {
  auto* kept = new std::vector<Vec3>(std::move(values));
  const py::capsule owner(kept, [](void* vector) { delete static_cast<std::vector<Vec3>*>(vector); });
  return py::array_t<double>({static_cast<py::ssize_t>(kept->size()), py::ssize_t{3}},
                             reinterpret_cast<const double*>(kept->data()), owner);
}

double checkedRate(double rate_Hz) {
  texture::TextureParameters parameters;
  const std::vector<Parameter> bound = bindParameters(parameters);
  return valid(checkParameter(*findParameter(bound, "texture.sample_rate_Hz"), rate_Hz));
}

texture::SurfaceModel checkedSurface(const texture::SurfaceModel& surface) {
  return valid(texture::parseSurface(texture::formatSurface(surface), "surface"));
}

}  // namespace fyd::python
