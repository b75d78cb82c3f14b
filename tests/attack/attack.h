// What the attacks on recordings share: counting what did not hold, and steps that tell their row.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "core/recording/format/recording_format.h"
#include "tests/unit/recording/recording_damage.h"
#include "tests/unit/recording/recording_samples.h"

namespace fyd::attack {

/// Says at the end how many things did not hold; that is the process's exit code.
class Report {
 public:
  void begin(std::string subject) { subject_ = std::move(subject); }
  bool expect(bool holds, const std::string& what) {
    if (holds) return true;
    ++broken_;
    std::printf("BROKEN %s: %s\n", subject_.c_str(), what.c_str());
    return false;
  }
  [[nodiscard]] int exitCode() const { return broken_ == 0 ? 0 : 1; }
  [[nodiscard]] std::size_t broken() const { return broken_; }

 private:
  std::string subject_;
  std::size_t broken_ = 0;
};

inline unsigned long argument(int count, char** words, int index, unsigned long otherwise) {
  return index < count ? std::strtoul(words[index], nullptr, 10) : otherwise;
}

/// Whether what the record does not name as missing is what the plain step of its number was.
inline bool isPlainWhereThere(const recording::StepRecord& record) {
  using recording::Table;
  recording::StepRecord truth = recording::samples::plainStep(record.telemetry.step - 1);
  recording::StepRecord kept = record;
  const auto lost = [&](Table table) { return (record.missing & recording::bitOf(table)) != 0; };
  if (lost(Table::motors)) kept.motors = truth.motors;
  pipeline::Inputs& in = kept.inputs;
  if (lost(Table::finger)) in.finger = truth.inputs.finger;
  if (lost(Table::ir)) in.ir = truth.inputs.ir;
  if (lost(Table::bridge)) in.bridge = truth.inputs.bridge;
  if (lost(Table::motor_feedback)) in.motors = truth.inputs.motors;
  if (lost(Table::robot_state)) in.robot.state = truth.inputs.robot.state;
  if (lost(Table::motor_reference)) in.robot.motor_reference = truth.inputs.robot.motor_reference;
  return static_cast<bool>(recording::samples::sameRecord(kept, truth));
}

}  // namespace fyd::attack
