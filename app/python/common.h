// What every part of the Python module needs: errors as exceptions, work without the interpreter's lock, arrays.
#pragma once

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/vec3.h"

namespace fyd::texture {
struct SurfaceModel;
}

namespace fyd::python {

namespace py = pybind11;

/// fyd.Error: something could not be done; the text is the library's own.
struct Failure {
  std::string text;
};
/// fyd.InvalidValue, which is a fyd.Error and a ValueError: an argument cannot be taken.
struct Refusal {
  std::string text;
};

template <class T>
T done(Result<T> result) {
  if (!result) throw Failure{result.error().text()};
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}
template <class T>
T valid(Result<T> result) {
  if (!result) throw Refusal{result.error().text()};
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// @throws py::value_error as Python's own open: the system would take what stands before the null for the path
[[nodiscard]] inline std::string pathOf(std::string path) {
  if (path.find('\0') != std::string::npos) throw py::value_error("embedded null byte");
  return path;
}
/// A str, bytes or os.PathLike. @throws py::value_error as above, TypeError as Python's own open
[[nodiscard]] inline std::string pathOf(const py::object& path) {
  return pathOf(py::bytes(py::module_::import("os").attr("fsencode")(path)).cast<std::string>());
}

/// While it lives, the interpreter's lock is released, so other Python threads go on. A thread that wants the lock back
/// when the interpreter has ended meanwhile waits for the process's end, as from Python 3.14 on: earlier ones end the
/// thread instead, by unwinding through whatever stands there, and no destructor of C++ lets that through.
class OthersGoOn {
 public:
  OthersGoOn() : state_(PyEval_SaveThread()) {}
  ~OthersGoOn();
  OthersGoOn(const OthersGoOn&) = delete;
  OthersGoOn& operator=(const OthersGoOn&) = delete;

 private:
  PyThreadState* state_;
};

/// An object of the library that one thread at a time may use: other Python threads go on meanwhile, and those that
/// want the same object wait for their turn.
template <class T>
class Shared {
 public:
  template <class... Arguments>
  explicit Shared(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

  /// Runs work(T&), which touches no Python object, without the interpreter's lock.
  template <class Work>
  auto run(Work&& work) {
    const OthersGoOn others_go_on;
    const std::lock_guard turn(mutex_);
    return work(value_);
  }

 private:
  T value_;
  std::mutex mutex_;
};

/// While it lives, no thread of this process is inside HDF5 through h5py: both use the same library, not every build of
/// which is thread-safe, and each of the two locks only its own calls. Taken before the interpreter's lock is released.
class Hdf5Turn {
 public:
  Hdf5Turn();
  ~Hdf5Turn();
  Hdf5Turn(const Hdf5Turn&) = delete;
  Hdf5Turn& operator=(const Hdf5Turn&) = delete;

 private:
  py::object h5py_lock_;  // none: h5py is not loaded
};

/// Text of files and of the system, which may be anything: bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] py::str textOf(const std::string& text);
[[nodiscard]] std::vector<py::str> textOf(const std::vector<std::string>& texts);

/// @throws py::type_error for an array whose mask hides something: what takes arrays would take what lies beneath
void refuseMask(const py::handle& given);
/// Python's bool or NumPy's.
[[nodiscard]] bool isTruth(const py::handle& value);
/// Whether Python and NumPy make a real number of it and nothing of it is lost or read out of a text: neither a complex
/// number, nor a date or a span of time, both of which NumPy would convert.
[[nodiscard]] bool isRealNumber(const py::handle& value);

/// An array of numbers, or what makes one: none of it is left out in silence, neither what a mask hides nor the
/// imaginary part of a complex number. @throws py::type_error
class Numbers : public py::array_t<double, py::array::c_style | py::array::forcecast> {
 public:
  Numbers() = default;
  /// Null where `given` makes no array of numbers.
  explicit Numbers(const py::handle& given);
};

/// @param name of the argument, for the message
[[nodiscard]] std::span<const double> vector(const Numbers& array, const char* name);
/// Rows of three numbers. The array's own memory.
[[nodiscard]] std::span<const Vec3> vectors(const Numbers& array, const char* name);
[[nodiscard]] Vec3 point(const Numbers& array, const char* name);
/// "(3, 4)"
[[nodiscard]] std::string shapeOf(const py::array& array);

/// An array of the vector's own memory, which it keeps.
template <class T>
[[nodiscard]] py::array_t<T> arrayOf(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  return py::array_t<T>(static_cast<py::ssize_t>(kept->size()), kept->data(), owner);
}
/// The same, as rows of three.
[[nodiscard]] py::array_t<double> arrayOf(std::vector<Vec3> values);

/// An enum that is made of the numbers it has; pybind11's own takes any.
template <class T>
py::enum_<T> enumOf(py::module_& module, const char* name, const char* help) {
  py::enum_<T> type(module, name, help);
  const py::handle self(type.ptr());
  py::delattr(self, "__init__");
  type.def(py::init([self](std::underlying_type_t<T> number) {
             for (const auto& [word, entry] : self.attr("__members__").template cast<py::dict>())
               if (entry.template cast<T>() == static_cast<T>(number)) return static_cast<T>(number);
             throw py::value_error(fmt::format("{}: no {}", number, std::string(py::str(self.attr("__name__")))));
           }),
           py::arg("value"));
  return type;
}

/// Sample rate of textures, by its parameter's range.
[[nodiscard]] double checkedRate(double rate_Hz);
/// As a file of it would be read: what is set by hand may be anything.
[[nodiscard]] texture::SurfaceModel checkedSurface(const texture::SurfaceModel& surface);

// Each part of the module.
void addValues(py::module_& module);
void addInputs(py::module_& module);
void addParameters(py::module_& module);
void addRecordings(py::module_& module);
void addReplay(py::module_& module);
void addSensing(py::module_& module);
void addTextures(py::module_& module);
void addPrediction(py::module_& module);
void addScenes(py::module_& module);
void addPipeline(py::module_& module);

}  // namespace fyd::python

template <>
struct pybind11::detail::type_caster<fyd::python::Numbers> {
  PYBIND11_TYPE_CASTER(fyd::python::Numbers, handle_type_name<array_t<double>>::name);
  bool load(handle from, bool /*convert*/) {
    value = fyd::python::Numbers(from);
    return static_cast<bool>(value);
  }
};
