// An experiment's trials, one key press each: tells the next condition and puts the markers into the recording.
#pragma once

#include <QObject>
#include <QStringList>
#include <string>
#include <vector>

#include "app/console/shell/command_registry.h"
#include "app/console/shell/options.h"
#include "app/console/shell/page.h"
#include "core/experiment/trials.h"

namespace fyd::console {

class TrialRun : public QObject {
  Q_OBJECT
 public:
  TrialRun(const PageContext& context, QObject* parent);
  void addCommands(CommandRegistry& commands);

  /// Makes the order of the trials and ends a run under way.
  /// @return an error for conditions or numbers that allow no order
  [[nodiscard]] Result<void> plan(const TrialWords& words);
  /// Ends the trial under way and begins the next. Nothing happens while nothing is recorded: a trial without its
  /// marker would be lost. Of a trial whose recording has ended, the next recording says nothing.
  void next();
  [[nodiscard]] const std::vector<experiment::Trial>& trials() const { return trials_; }
  /// Trials begun so far.
  [[nodiscard]] std::size_t begun() const { return begun_; }

 private:
  /// @return whether the marker is in the recording; otherwise a notice was shown
  bool mark(recording::NoteKind kind, const experiment::Trial& trial);

  PageContext context_;
  std::vector<experiment::Trial> trials_;
  std::size_t begun_ = 0;
  bool under_way_ = false;
  std::string recording_;  ///< into which the trial under way was begun
};

}  // namespace fyd::console
