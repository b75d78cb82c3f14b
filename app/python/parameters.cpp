#include "app/python/parameters.h"

#include <fmt/format.h>

#include "core/base/profile_text.h"

namespace fyd::python {
namespace {

struct Described {
  std::string id, name, unit, help, kind, allowed;
  py::object minimum, maximum, initial;
  bool live = false;
  py::tuple choices;
};

constexpr std::array<const char*, 6> kKinds = {"real", "integer", "boolean", "choice", "list", "text"};

Described describedParameter(const std::string& id) {
  const ParameterSet fresh;
  const Parameter& parameter = fresh.find(id);
  Described out{.id = std::string(parameter.id),
                .name = std::string(parameter.info.name),
                .unit = std::string(parameter.info.unit),
                .help = std::string(parameter.info.help),
                .kind = kKinds.at(static_cast<std::size_t>(parameter.kind)),
                .allowed = describeRange(parameter).text(),
                .minimum = py::float_(parameter.info.minimum),
                .maximum = py::float_(parameter.info.maximum),
                .initial = valueOf(parameter),
                .live = parameter.info.live,
                .choices = py::tuple(parameter.choices.size())};
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) out.choices[i] = std::string(parameter.choices[i]);
  return out;
}

void update(ParameterSet& set, const py::dict& values) {
  // All or nothing: on a copy first. Each value is looked at once, for an iterator has nothing for a second look.
  const ParameterSet trial(set.values());
  for (const auto& [id, value] : values) assign(trial.find(idOf(id)), value);
  set.take(trial.values());
}

}  // namespace

const Parameter& ParameterSet::find(const std::string& id) const {
  const Parameter* found = findParameter(bound_, id);
  if (found == nullptr) throw Refusal{fmt::format("{}: the step has no parameter of this name", id)};
  return *found;
}

namespace {

/// An integer of Python's may be larger than any double.
double numberOf(const Parameter& parameter, const py::handle& value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number != -1.0 || PyErr_Occurred() == nullptr) return number;
  if (PyErr_ExceptionMatches(PyExc_OverflowError) == 0) throw py::error_already_set();
  PyErr_Clear();
  throw Refusal{fmt::format("{}: an integer of more than 308 digits; expected {}", parameter.id,
                            describeRange(parameter).text())};
}

std::string numberText(const Parameter& parameter, const py::handle& value) {
  const auto number = py::reinterpret_borrow<py::object>(value);
  if (!isTruth(value) && isRealNumber(value)) {
    if (py::hasattr(value, "__index__")) {
      const py::int_ whole(number);
      (void)numberOf(parameter, whole);
      return py::repr(whole);
    }
    return py::repr(py::float_(number));
  }
  throw py::type_error(fmt::format("{}: {}: no number, truth value, text or list of numbers", parameter.id,
                                   std::string(py::repr(value))));
}

/// Of an array without an axis its only value, which NumPy gives back for one that is read out of a file or a sum.
py::object plain(const py::handle& value) {
  refuseMask(value);
  const bool one = py::isinstance<py::array>(value) && py::reinterpret_borrow<py::array>(value).ndim() == 0;
  return one ? py::object(value.attr("__getitem__")(py::tuple())) : py::reinterpret_borrow<py::object>(value);
}

/// None: no text, or with half of a surrogate pair, as the name of a file that is no UTF-8 has it.
std::optional<std::string> utf8Of(const py::handle& value) {
  if (!py::isinstance<py::str>(value)) return std::nullopt;
  const auto bytes = py::reinterpret_steal<py::object>(PyUnicode_AsUTF8String(value.ptr()));
  if (bytes) return std::string(py::reinterpret_borrow<py::bytes>(bytes));
  PyErr_Clear();
  return std::nullopt;
}

}  // namespace

std::string idOf(const py::handle& key) {
  if (auto id = utf8Of(key)) return *std::move(id);
  throw py::type_error(fmt::format("{}: expected a name, as \"control.kp\"", std::string(py::repr(key))));
}

std::string written(const Parameter& parameter, const py::handle& given) {
  const py::object value = plain(given);
  if (isTruth(value)) return PyObject_IsTrue(value.ptr()) == 1 ? "true" : "false";
  if (auto text = utf8Of(value)) return *std::move(text);
  // Of bytes and dicts the items are numbers that nobody gave as a list.
  const bool other = py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
                     py::isinstance<py::bytearray>(value) || py::isinstance<py::dict>(value);
  if (py::hasattr(value, "__iter__") && !other) {
    // Numbers only, for a list may contain itself; and one more than a list holds, which is then told of.
    std::string out;
    std::size_t count = 0;
    for (const auto& item : value) {
      out += fmt::format("{}{}", out.empty() ? "" : ", ", numberText(parameter, item));
      if (++count > kParameterListCapacity) break;
    }
    return fmt::format("[{}]", out);
  }
  return numberText(parameter, value);
}

void assign(const Parameter& parameter, const py::handle& given) {
  const py::object value = plain(given);
  const bool number = py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value);
  if (number && !py::isinstance<py::bool_>(value) &&
      (parameter.kind == ParameterKind::real || parameter.kind == ParameterKind::integer)) {
    // As a number: NaN and infinity are told as what they are.
    parameter.set(valid(checkParameter(parameter, numberOf(parameter, value))));
  } else {
    valid(assignParameter(parameter, written(parameter, value)));
  }
}

py::object valueOf(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::real: return py::float_(parameter.value());
    case ParameterKind::integer: return py::int_(static_cast<long>(parameter.value()));
    case ParameterKind::boolean: return py::bool_(parameter.value() != 0.0);
    case ParameterKind::choice:
      return py::str(std::string(parameter.choices[static_cast<std::size_t>(parameter.value())]));
    case ParameterKind::text: return py::str(parameter.text());
    case ParameterKind::list: break;
  }
  py::tuple out(parameter.list().size());
  for (std::size_t i = 0; i < parameter.list().size(); ++i) out[i] = parameter.list()[i];
  return out;
}

std::optional<std::string> idAt(std::uint16_t index) {
  const ParameterSet fresh;
  if (index >= fresh.bound().size()) return std::nullopt;
  return std::string(fresh.bound()[index].id);
}

std::optional<std::string> idOfEvent(const pipeline::Event& event) {
  return event.namesParameter() ? idAt(event.index) : std::nullopt;
}

pipeline::Parameters orDefaults(const ParameterSet* parameters) {
  return parameters == nullptr ? pipeline::Parameters() : parameters->values();
}

void addParameters(py::module_& module) {
  py::class_<Described>(module, "ParameterInfo", "What a parameter means, and what it may be.")
      .def_readonly("id", &Described::id, "\"module.name\" [—]")
      .def_readonly("name", &Described::name, "Short, for people; empty where it never changes live [—]")
      .def_readonly("unit", &Described::unit, "Unit of the value; \"1\" for a plain number [—]")
      .def_readonly("minimum", &Described::minimum, "Smallest value [in its unit]")
      .def_readonly("maximum", &Described::maximum, "Largest value [in its unit]")
      .def_readonly("default", &Described::initial, "Value of a new set [in its unit]")
      .def_readonly("help", &Described::help, "One sentence [—]")
      .def_readonly("live", &Described::live, "Whether it may change while the step renders [—]")
      .def_readonly("choices", &Described::choices, "The words of a choice [—]")
      .def_readonly("kind", &Described::kind, "real, integer, boolean, choice, list or text [—]")
      .def_readonly("allowed", &Described::allowed, "What may be given, as a phrase [—]");

  py::class_<ParameterSet>(
      module, "Parameters",
      "The step's parameters: a mapping from id (\"control.kp\") to value. Each is checked when it "
      "is set: InvalidValue names id, value and range.")
      .def(py::init([](const std::optional<py::dict>& values) {
             auto out = std::make_unique<ParameterSet>();
             if (values) update(*out, *values);
             return out;
           }),
           py::arg("values") = py::none(),
           "The defaults, and these values in their place. Units: each parameter's own.")
      .def(
          "__getitem__", [](const ParameterSet& set, const std::string& id) { return valueOf(set.find(id)); },
          py::arg("id"))
      .def(
          "__setitem__",
          [](ParameterSet& set, const std::string& id, const py::object& value) { assign(set.find(id), value); },
          py::arg("id"), py::arg("value"))
      .def(
          "__contains__",
          [](const ParameterSet& set, const py::object& id) {
            const auto text = utf8Of(id);
            return text && findParameter(set.bound(), *text) != nullptr;
          },
          py::arg("id"))
      .def("__len__", [](const ParameterSet& set) { return set.bound().size(); })
      .def(
          "__eq__",
          [](const ParameterSet& set, const py::object& other) -> py::object {
            if (!py::isinstance<ParameterSet>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(formatProfile(set.bound()) == formatProfile(other.cast<const ParameterSet&>().bound()));
          },
          py::arg("other"))
      .def("__iter__", [](const py::object& set) { return py::iter(set.attr("keys")()); })
      .def(
          "keys",
          [](const ParameterSet& set) {
            std::vector<std::string> out;
            for (const Parameter& each : set.bound()) out.emplace_back(each.id);
            return out;
          },
          "Ids of all parameters, in the order of the profile. Units: none.")
      .def(
          "values",
          [](const ParameterSet& set) {
            std::vector<py::object> out;
            for (const Parameter& each : set.bound()) out.push_back(valueOf(each));
            return out;
          },
          "Values of all parameters, in the order of their ids. Units: each parameter's own.")
      .def(
          "items",
          [](const ParameterSet& set) {
            std::vector<std::pair<std::string, py::object>> out;
            for (const Parameter& each : set.bound()) out.emplace_back(each.id, valueOf(each));
            return out;
          },
          "(Id, value) of all parameters, in that order. Units: each parameter's own.")
      .def(
          "get",
          [](const ParameterSet& set, const std::string& id, const py::object& otherwise) {
            const Parameter* found = findParameter(set.bound(), id);
            return found == nullptr ? otherwise : valueOf(*found);
          },
          py::arg("id"), py::arg("default") = py::none(),
          "Value of a parameter; `default` when there is none of this id. Units: the parameter's own.")
      .def("update", &update, py::arg("values"),
           "Sets several; none of them when one is not possible. Units: each parameter's own.")
      .def(
          "copy", [](const ParameterSet& set) { return std::make_unique<ParameterSet>(set.values()); },
          "A set of its own with the same values. Units: none.")
      .def(py::pickle(
          [](const ParameterSet& set) {
            py::dict out;
            for (const Parameter& each : set.bound()) out[py::str(std::string(each.id))] = valueOf(each);
            return out;
          },
          [](const py::dict& values) {
            auto out = std::make_unique<ParameterSet>();
            update(*out, values);
            return out;
          }))
      .def(
          "profile", [](const ParameterSet& set) { return formatProfile(set.bound()); },
          "All of them as the TOML text of a profile. Units: each in its comment.")
      .def_static(
          "from_profile",
          [](const std::string& text, const std::string& name) {
            auto out = std::make_unique<ParameterSet>();
            valid(parseProfile(text, name, out->bound()));
            return out;
          },
          py::arg("text"), py::arg("name") = "profile",
          "The defaults, and in their place what a TOML text of the step's parameters says; `name` begins each "
          "message. "
          "Units: each parameter's own.")
      .def_static("info", &describedParameter, py::arg("id"),
                  "What a parameter means, and what it may be. Units: none.");
}

}  // namespace fyd::python
