// The parameters an operator tunes: current, previous, saved and default value, and whether the station has confirmed
// the current one; every change can be undone.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/parameter.h"

namespace fyd::widgets {

/// The station's answer to the latest value asked for.
enum class Delivery {
  confirmed,  ///< it uses it
  pending,    ///< no answer yet
  silent,     ///< no answer for too long
  refused,    ///< refused; the value is the one it uses
  other,      ///< it took it, and uses another of its own accord
};

struct TunedParameter {
  Parameter info;  ///< its description; the instance it was read from may be gone, so the field is not used
  double value = 0.0;
  double saved = 0.0;
  double standard = 0.0;   ///< the default
  double was = 0.0;        ///< before its latest change
  double confirmed = 0.0;  ///< the last of those asked for that the station said it uses
  double held = 0.0;       ///< what the station last said it uses, of its own accord too
  Delivery delivery = Delivery::confirmed;
  QString reason = {};  ///< of a refusal
  [[nodiscard]] bool changed() const { return value != saved; }
};

struct Setting {
  std::string id;
  double value = 0.0;
};

/// A change that is not applied before the operator has said so.
struct TuningQuestion {
  QString id = {};     ///< its parameter; empty: several, or a change by undo, redo, A and B
  double value = 0.0;  ///< that the parameter would take
  QString words = {};  ///< what speaks against it, as a sentence
  std::function<void()> apply = {};
  int number = 0;  ///< counts the questions, from 1
};

/// What speaks against using these values beside the others that are felt, as a sentence; empty: nothing.
using TuningDoubt = std::function<QString(std::span<const Setting> next)>;

class TuningModel : public QObject {
  Q_OBJECT
 public:
  explicit TuningModel(QObject* parent = nullptr);

  /// @param current,defaults of the same struct, in the same order; lists are left out, they are not tuned here
  void load(std::span<const Parameter> current, std::span<const Parameter> defaults);

  [[nodiscard]] const TunedParameter* find(std::string_view id) const;
  /// In the order of the description.
  [[nodiscard]] std::span<const TunedParameter> parameters() const { return parameters_; }
  [[nodiscard]] QUndoStack* undoStack() { return &undo_; }
  /// Whether any value differs from the saved profile.
  [[nodiscard]] bool anyChanged() const;

  /// Asked before every change of the operator's. A change with a doubt waits as the question.
  void setDoubt(TuningDoubt doubt) { doubt_ = std::move(doubt); }
  [[nodiscard]] const std::optional<TuningQuestion>& question() const { return question_; }
  /// The operator's answers; without a question nothing happens. Any other change is "leave" as well.
  void applyAnyway();
  void leaveAsItIs();

  /// The operator's change: checked, undoable. Changes of one parameter that follow closely merge, as a slider gives
  /// them.
  /// @return also without an error it may wait as question(); an error naming the allowed range, or that saved values are being felt; nothing is changed then
  Result<void> change(std::string_view id, double value, bool merge = false);
  /// Several at once, as one step of the undo stack; those that are there already are left out.
  /// @param words what the step is called: "Preset soft"
  /// @return the first error; nothing at all is changed then
  Result<void> changeAll(const QString& words, std::span<const Setting> settings);
  void resetToDefault(std::string_view id);
  void revertToSaved(std::string_view id);
  /// Every value back to the saved one, as one step.
  Result<void> revertAll();
  /// While saved values are felt, both only return to the current ones.
  void undo();
  void redo();
  /// No step of the undo stack leads back to a former value of this parameter; the rest of each step stays.
  void forgetChanges(std::string_view id);

  /// A change that came from elsewhere (the robot's operator): shown, not undoable; the station uses it.
  void accept(std::string_view id, double value);
  /// The station's answer to the value asked for.
  void setDelivery(std::string_view id, Delivery delivery);
  void confirm(std::string_view id, double value);
  /// The station says what it uses, of its own accord or late: shown beside the value, which stays and is what is saved.
  void hold(std::string_view id, double value);
  /// The station goes on with the value it last confirmed, and so does the model.
  void refuse(std::string_view id, const QString& reason);

  /// A: the saved values are applied, and nothing can be changed; B: the current ones again. No step of the undo stack.
  /// With a doubt it waits as question().
  void feelSaved(bool saved);
  /// B without a question: for a session that begins anew.
  void returnToCurrent() { switchFelt(false); }
  [[nodiscard]] bool feelingSaved() const { return feeling_saved_; }
  /// The value that is felt now.
  [[nodiscard]] double felt(const TunedParameter& parameter) const {
    return feeling_saved_ ? parameter.saved : parameter.value;
  }

  /// The values are those of the profile on disk now.
  void markSaved();
  /// The same for one value; an unknown id changes nothing.
  void markSaved(std::string_view id);

 signals:
  /// The operator's change, also when undone or redone: to be applied.
  void asked(const QString& id, double value);
  /// Its present value stands: what was said against an entry is out of date.
  void taken(const QString& id);
  /// The parameter has to be shown anew.
  void changed(const QString& id);
  void feelingSavedChanged(bool saved);
  void questionChanged();

 private:
  friend class ChangeCommand;
  [[nodiscard]] TunedParameter* entry(std::string_view id);
  [[nodiscard]] Result<void> check(std::string_view id, double value) const;
  void store(const QString& id, double value, double was);
  void switchFelt(bool saved);
  void push(const QString& words, std::span<const Setting> settings, bool merge);
  /// Undoes or redoes the next step of the stack.
  void step(bool back);
  /// Applies it, or lets it wait when there is a doubt about `next`.
  void propose(std::span<const Setting> next, TuningQuestion change);

  std::vector<TunedParameter> parameters_;
  QUndoStack undo_;
  TuningDoubt doubt_;
  std::optional<TuningQuestion> question_;
  int questions_ = 0;  ///< asked so far
  bool feeling_saved_ = false;
};

}  // namespace fyd::widgets
