// The mean of signals over the last readings, their spread, and whether they are steady.
#pragma once

#include <QString>
#include <deque>
#include <vector>

#include "app/console/calibrate/calibrate_step.h"

namespace fyd::console {

class CalibrationAverage {
 public:
  /// @param readings the mean is taken of, at least 1
  void restart(int readings);
  /// One reading of all signals, those that turn on the turn nearest to the last reading's; the oldest beyond the number
  /// wanted is dropped.
  void add(std::vector<double> reading, const std::vector<CalibrationSignal>& wanted);
  [[nodiscard]] bool full() const { return static_cast<int>(kept_.size()) >= wanted_; }
  [[nodiscard]] double progress() const { return static_cast<double>(kept_.size()) / wanted_; }
  [[nodiscard]] bool empty() const { return kept_.empty(); }
  [[nodiscard]] std::vector<std::vector<double>> readings() const { return {kept_.begin(), kept_.end()}; }

  /// Of what turns, from 0 to below its turn.
  [[nodiscard]] std::vector<double> mean() const;
  /// Standard deviation of one reading; 0 with fewer than two.
  [[nodiscard]] std::vector<double> spread() const;
  /// Which signal is not steady and by how much; empty while all are steady.
  [[nodiscard]] QString moving(const std::vector<CalibrationSignal>& wanted) const;

 private:
  [[nodiscard]] std::vector<double> meanOf(std::size_t from, std::size_t to) const;
  int wanted_ = 1;
  std::deque<std::vector<double>> kept_;
  std::vector<double> turns_;  ///< of each signal, 0: it does not turn
};

}  // namespace fyd::console
