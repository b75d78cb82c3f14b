// An experiment's trials, one key press each: says which condition is next and puts the markers into the recording.
#pragma once

#include <QObject>
#include <QStringList>
#include <vector>

#include "app/console/command_registry.h"
#include "app/console/page.h"
#include "core/session/trials.h"

namespace fyd::console {

struct TrialWords {
  QStringList conditions;  ///< none: no trials
  int repetitions = 1;
  std::uint64_t seed = 1;
};

class TrialRun : public QObject {
  Q_OBJECT
 public:
  TrialRun(const PageContext& context, QObject* parent);
  void addCommands(CommandRegistry& commands);

  /// Orders the trials; none is under way then.
  /// @return an error for conditions or numbers that make no order
  [[nodiscard]] Result<void> plan(const TrialWords& words);
  /// Ends the trial under way and begins the next. Nothing happens while nothing is recorded: a trial without its
  /// marker would be lost.
  void next();
  [[nodiscard]] const std::vector<session::Trial>& trials() const { return trials_; }
  /// Trials begun so far.
  [[nodiscard]] std::size_t begun() const { return begun_; }

 private:
  /// @return whether the marker is in the recording; otherwise the operator was told
  bool mark(session::NoteKind kind, const session::Trial& trial);

  PageContext context_;
  std::vector<session::Trial> trials_;
  std::size_t begun_ = 0;
  bool under_way_ = false;
};

}  // namespace fyd::console
