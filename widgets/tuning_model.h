// The parameters an operator tunes: what is, what was saved, what the default is; every change can be taken back.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/parameter.h"

namespace fyd::widgets {

struct TunedParameter {
  Parameter info;  ///< its description; the instance it was read from may be gone, so the field is not used
  double value = 0.0;
  double saved = 0.0;
  double standard = 0.0;  ///< the default
  [[nodiscard]] bool changed() const { return value != saved; }
};

class TuningModel : public QObject {
  Q_OBJECT
 public:
  explicit TuningModel(QObject* parent = nullptr);

  /// @param current,defaults of the same struct, in the same order; lists are left out, they are not tuned here
  void load(std::span<const Parameter> current, std::span<const Parameter> defaults);

  [[nodiscard]] const TunedParameter* find(std::string_view id) const;
  [[nodiscard]] QUndoStack* undoStack() { return &undo_; }
  /// Whether any value differs from the saved profile.
  [[nodiscard]] bool anyChanged() const;

  /// The operator's change: checked, undoable. Changes of one parameter that follow closely merge, as a slider gives
  /// them.
  /// @return an error naming the allowed range; nothing is changed then
  Result<void> change(std::string_view id, double value, bool merge = false);
  /// A change that came from elsewhere (the robot's operator): shown, not undoable.
  void accept(std::string_view id, double value);
  void resetToDefault(std::string_view id);
  /// The values are those of the profile on disk now.
  void markSaved();
  /// The same of one value; an unknown id changes nothing.
  void markSaved(std::string_view id);

 signals:
  /// The operator's change, also when undone or redone: to be applied.
  void asked(const QString& id, double value);
  /// Something to show anew.
  void changed(const QString& id);

 private:
  friend class ChangeCommand;
  TunedParameter* entry(std::string_view id);
  void store(const QString& id, double value);

  std::vector<TunedParameter> parameters_;
  QUndoStack undo_;
};

}  // namespace fyd::widgets
