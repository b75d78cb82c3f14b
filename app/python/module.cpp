// The compiled half of `import fyd`: what the library computes. app/python/fyd/__init__.py is the other.
#include "app/python/common.h"

namespace fyd::python {
namespace {

void addErrors(py::module_& module) {
  // Kept for the life of the process, as the module itself is.
  static auto* const error = new py::object(py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
      "fyd.Error", "Something could not be done; the text names the thing, its value and what was expected.",
      PyExc_Exception, nullptr)));
  static auto* const invalid = new py::object(py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
      "fyd.InvalidValue", "A value that was given is not possible; the text names it and what is.",
      py::make_tuple(*error, py::handle(PyExc_ValueError)).ptr(), nullptr)));
  module.attr("Error") = *error;
  module.attr("InvalidValue") = *invalid;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const Failure& failure) {
      PyErr_SetObject(error->ptr(), textOf(failure.text).ptr());
    } catch (const Refusal& refusal) {
      PyErr_SetObject(invalid->ptr(), textOf(refusal.text).ptr());
    }
  });
}

}  // namespace

PYBIND11_MODULE(_fyd, module) {
  module.doc() = "What the library of the FYD Touchpad computes; import fyd, not this.";
  module.attr("__version__") = FYD_VERSION;
  addErrors(module);
  // A type stands before the functions that name it: pybind11 writes their signatures.
  addValues(module);
  addInputs(module);
  addParameters(module);
  addRecordings(module);
  addReplay(module);
  addSensing(module);
  addTextures(module);
  addPrediction(module);
  addScenes(module);
  addPipeline(module);
}

}  // namespace fyd::python
