// The step's parameters as Python has them.
#pragma once

#include "app/python/common.h"
#include "core/pipeline/outputs.h"
#include "core/pipeline/parameters.h"

namespace fyd::python {

/// A mapping from id to value; ranges, units and help are those of the descriptions.
class ParameterSet {
 public:
  explicit ParameterSet(const pipeline::Parameters& values = {})
      : values_(std::make_unique<pipeline::Parameters>(values)), bound_(bindParameters(*values_)) {}

  [[nodiscard]] const pipeline::Parameters& values() const { return *values_; }
  [[nodiscard]] const std::vector<Parameter>& bound() const { return bound_; }
  /// @throws Refusal when there is none
  [[nodiscard]] const Parameter& find(const std::string& id) const;
  void take(const pipeline::Parameters& values) { *values_ = values; }

 private:
  std::unique_ptr<pipeline::Parameters> values_;  // bound_ points into it
  std::vector<Parameter> bound_;
};

/// The name of a parameter or key. @throws type_error for what is no text
[[nodiscard]] std::string idOf(const py::handle& key);
/// "2.5", "true", "dft321" or "[1, 2]", as assignParameter reads it. @throws Refusal for a number beyond any double
[[nodiscard]] std::string written(const Parameter& parameter, const py::handle& value);
/// @throws Refusal with id, value and range
void assign(const Parameter& parameter, const py::handle& value);
[[nodiscard]] py::object valueOf(const Parameter& parameter);
/// "control.kp" by its number, as the library counts the step's parameters; none: it has no such parameter.
[[nodiscard]] std::optional<std::string> idAt(std::uint16_t index);
/// Of the parameter that an event names, if it names one.
[[nodiscard]] std::optional<std::string> idOfEvent(const pipeline::Event& event);
inline constexpr const char* kIdOfEvent =
    "Id of the parameter that changed or was refused; None: it is another event, or this library has no such parameter "
    "[—]";
/// Parameters of None are the defaults.
[[nodiscard]] pipeline::Parameters orDefaults(const ParameterSet* parameters);

}  // namespace fyd::python
