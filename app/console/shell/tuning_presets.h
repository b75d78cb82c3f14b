// Presets of the window: named sets of live parameters in files beside the profile. Loading, saving, renaming and
// deleting are steps of the same undo stack as every other change of a value.
#pragma once

#include <QObject>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "app/console/shell/session.h"
#include "core/station/profile/tuning_presets.h"
#include "widgets/status/notice_stack.h"
#include "widgets/tuning/tuning_model.h"

class QMenu;

namespace fyd::console {

class TuningPresets : public QObject {
  Q_OBJECT
 public:
  TuningPresets(Session& session, widgets::TuningModel& model, std::string folder, QObject* parent = nullptr);

  [[nodiscard]] QStringList names() const;
  /// The current values under this name; one of that name is replaced.
  Result<void> save(const QString& name);
  /// @return an error with file, line and value when the file is bad; nothing is changed then
  Result<void> load(const QString& name);
  /// @return an error also when there is one of the new name
  Result<void> rename(const QString& from, const QString& to);
  Result<void> remove(const QString& name);

  /// Fills the menu anew each time it opens; a name loads.
  void feed(QMenu& menu);

 signals:
  void changed();
  void told(fyd::widgets::Severity severity, const QString& text);

 private:
  friend class PresetCommand;
  struct Step {
    std::string name;
    std::optional<std::string> before;  ///< none: there was no such file
    std::optional<std::string> after;
  };

  Result<void> put(const std::string& name, const std::optional<std::string>& text);
  Result<void> perform(const QString& words, std::vector<Step> steps);
  [[nodiscard]] std::optional<std::string> present(const std::string& name) const;
  /// The session's profile with the current values, also while the saved ones are felt.
  [[nodiscard]] station::Profile current() const;

  Session& session_;
  widgets::TuningModel& model_;
  std::string folder_;
};

}  // namespace fyd::console
