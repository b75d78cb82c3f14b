#include "widgets/tuning/tuning_model.h"

#include <QElapsedTimer>
#include <QUndoCommand>

#include "widgets/basics/number_text.h"

namespace fyd::widgets {
namespace {

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

struct Change {
  QString id;
  double from;
  double to;
};

}  // namespace

/// One step of the undo stack. Steps of one drag of a slider become one.
class ChangeCommand : public QUndoCommand {
 public:
  ChangeCommand(TuningModel& model, const QString& words, std::vector<Change> changes, bool merge)
      : QUndoCommand(words), model_(model), changes_(std::move(changes)), merge_(merge) {
    age_.start();
  }
  void undo() override {
    for (auto each = changes_.rbegin(); each != changes_.rend(); ++each) model_.store(each->id, each->from, each->to);
  }
  void redo() override {
    for (const Change& each : changes_) model_.store(each.id, each.to, each.from);
  }
  /// The values that its parameters have before or after it.
  [[nodiscard]] std::vector<Setting> values(bool before) const {
    std::vector<Setting> out;
    for (const Change& each : changes_)
      out.push_back({.id = each.id.toStdString(), .value = before ? each.from : each.to});
    return out;
  }
  /// This parameter is no longer changed by it.
  void leaveOut(const QString& id) {
    std::erase_if(changes_, [&](const Change& each) { return each.id == id; });
    if (changes_.empty()) setObsolete(true);
  }
  int id() const override { return merge_ ? 1 : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    constexpr qint64 kSameDrag_ms = 800;
    if (changes_.empty()) return false;
    const Change& next = static_cast<const ChangeCommand*>(other)->changes_.front();
    Change& own = changes_.front();
    if (next.id != own.id || age_.elapsed() > kSameDrag_ms) return false;
    own.to = next.to;
    model_.entry(own.id.toStdString())->was = own.from;
    emit model_.changed(own.id);
    age_.start();
    setText(other->text());
    return true;
  }

 private:
  TuningModel& model_;
  std::vector<Change> changes_;
  bool merge_;
  QElapsedTimer age_;
};

TuningModel::TuningModel(QObject* parent) : QObject(parent), undo_(this) {
  connect(&undo_, &QUndoStack::indexChanged, this, &TuningModel::leaveAsItIs);
}

void TuningModel::load(std::span<const Parameter> current, std::span<const Parameter> defaults) {
  leaveAsItIs();
  undo_.clear();
  parameters_.clear();
  for (std::size_t i = 0; i < current.size(); ++i) {
    if (!current[i].isNumber()) continue;
    const double value = current[i].value();
    parameters_.push_back({.info = current[i],
                           .value = value,
                           .saved = value,
                           .standard = defaults[i].value(),
                           .was = value,
                           .confirmed = value,
                           .held = value});
    parameters_.back().info.field = nullptr;
  }
}

TunedParameter* TuningModel::entry(std::string_view id) {
  for (TunedParameter& parameter : parameters_) {
    if (parameter.info.id == id) return &parameter;
  }
  return nullptr;
}

const TunedParameter* TuningModel::find(std::string_view id) const { return const_cast<TuningModel*>(this)->entry(id); }

bool TuningModel::anyChanged() const {
  return std::ranges::any_of(parameters_, [](const TunedParameter& parameter) { return parameter.changed(); });
}

Result<void> TuningModel::check(std::string_view id, double value) const {
  const TunedParameter* parameter = find(id);
  if (parameter == nullptr) return fail("{}: no such parameter", id);
  if (!parameter->info.info.live) return fail("{} cannot change while the station runs", id);
  if (const auto checked = checkParameter(parameter->info, value); !checked) return tl::unexpected(checked.error());
  return {};
}

Result<void> TuningModel::change(std::string_view id, double value, bool merge) {
  if (auto good = check(id, value); !good) return good;
  if (feeling_saved_) return fail("{}: saved values are felt now; go back to the current ones to change it", id);
  const TunedParameter& parameter = *find(id);
  const QString name = fromView(id);
  if (value == parameter.value) {
    leaveAsItIs();
    emit taken(name);
    return {};
  }
  const Setting next{.id = std::string(id), .value = value};
  propose({&next, 1}, {.id = name, .value = value, .apply = [this, name, next, merge] {
                         push(tr("%1 to %2").arg(name, plainNumber(next.value)), {&next, 1}, merge);
                       }});
  return {};
}

Result<void> TuningModel::changeAll(const QString& words, std::span<const Setting> settings) {
  if (feeling_saved_) return fail("saved values are felt now; go back to the current ones to change any");
  std::vector<Setting> next;
  for (const Setting& setting : settings) {
    if (auto good = check(setting.id, setting.value); !good) return good;
    if (find(setting.id)->value != setting.value) next.push_back(setting);
  }
  if (!next.empty()) propose(next, {.apply = [this, words, next] { push(words, next, false); }});
  return {};
}

void TuningModel::push(const QString& words, std::span<const Setting> settings, bool merge) {
  std::vector<Change> changes;
  changes.reserve(settings.size());
  for (const Setting& setting : settings) {
    changes.push_back({.id = QString::fromStdString(setting.id), .from = find(setting.id)->value, .to = setting.value});
  }
  undo_.push(new ChangeCommand(*this, words, std::move(changes), merge));
}

void TuningModel::propose(std::span<const Setting> next, TuningQuestion change) {
  change.words = doubt_ ? doubt_(next) : QString();
  if (change.words.isEmpty()) {
    leaveAsItIs();
    change.apply();
    return;
  }
  change.number = ++questions_;
  question_ = std::move(change);
  emit questionChanged();
}

void TuningModel::applyAnyway() {
  if (!question_) return;
  const auto apply = std::move(question_->apply);
  leaveAsItIs();
  apply();
}

void TuningModel::leaveAsItIs() {
  if (!question_) return;
  question_.reset();
  emit questionChanged();
}

void TuningModel::store(const QString& id, double value, double was) {
  TunedParameter* parameter = entry(id.toStdString());
  if (parameter == nullptr) return;
  parameter->value = value;
  parameter->was = was;
  emit asked(id, value);
  if (parameter->delivery != Delivery::refused) emit taken(id);
  emit changed(id);
}

void TuningModel::accept(std::string_view id, double value) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr) return;
  const bool news = parameter->value != value || parameter->delivery != Delivery::confirmed;
  if (parameter->value != value) parameter->was = parameter->value;
  parameter->value = parameter->confirmed = parameter->held = value;
  parameter->delivery = Delivery::confirmed;
  if (news) emit changed(fromView(id));
}

void TuningModel::setDelivery(std::string_view id, Delivery delivery) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr || parameter->delivery == delivery) return;
  parameter->delivery = delivery;
  emit changed(fromView(id));
}

void TuningModel::confirm(std::string_view id, double value) {
  if (TunedParameter* parameter = entry(id)) parameter->confirmed = parameter->held = value;
  setDelivery(id, Delivery::confirmed);
}

void TuningModel::hold(std::string_view id, double value) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr) return;
  if (value == felt(*parameter)) {
    confirm(id, value);
    return;
  }
  const bool news = parameter->held != value || parameter->delivery != Delivery::other;
  parameter->held = value;
  parameter->delivery = Delivery::other;
  if (news) emit changed(fromView(id));
}

void TuningModel::refuse(std::string_view id, const QString& reason) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr) return;
  if (!feeling_saved_) parameter->value = parameter->confirmed;
  parameter->delivery = Delivery::refused;
  parameter->reason = reason;
  emit changed(fromView(id));
}

void TuningModel::resetToDefault(std::string_view id) {
  if (const TunedParameter* parameter = find(id)) (void)change(id, parameter->standard);
}

void TuningModel::revertToSaved(std::string_view id) {
  if (const TunedParameter* parameter = find(id)) (void)change(id, parameter->saved);
}

Result<void> TuningModel::revertAll() {
  std::vector<Setting> settings;
  for (const TunedParameter& parameter : parameters_) {
    if (parameter.changed()) settings.push_back({.id = std::string(parameter.info.id), .value = parameter.saved});
  }
  return changeAll(tr("all back to the saved values"), settings);
}

void TuningModel::undo() {
  if (feeling_saved_) {
    feelSaved(false);
  } else {
    step(true);
  }
}

void TuningModel::redo() {
  if (feeling_saved_) {
    feelSaved(false);
  } else {
    step(false);
  }
}

void TuningModel::step(bool back) {
  const auto take = [this, back] { back ? undo_.undo() : undo_.redo(); };
  const auto next_command = [this, back] { return undo_.command(back ? undo_.index() - 1 : undo_.index()); };
  while (next_command() != nullptr && next_command()->isObsolete()) take();  // which only drops it
  const QUndoCommand* command = next_command();
  if (command == nullptr) return;
  const auto* change = dynamic_cast<const ChangeCommand*>(command);
  const std::vector<Setting> next = change != nullptr ? change->values(back) : std::vector<Setting>{};
  propose(next, {.apply = take});
}

void TuningModel::forgetChanges(std::string_view id) {
  leaveAsItIs();
  const QString name = fromView(id);
  for (int i = 0; i < undo_.count(); ++i) {
    // The stack shows its commands only as const.
    if (auto* change = dynamic_cast<ChangeCommand*>(const_cast<QUndoCommand*>(undo_.command(i))))
      change->leaveOut(name);
  }
}

void TuningModel::feelSaved(bool saved) {
  if (saved == feeling_saved_) return;
  std::vector<Setting> next;
  for (const TunedParameter& parameter : parameters_) {
    if (!parameter.changed()) continue;
    next.push_back({.id = std::string(parameter.info.id), .value = saved ? parameter.saved : parameter.value});
  }
  propose(next, {.apply = [this, saved] { switchFelt(saved); }});
}

void TuningModel::switchFelt(bool saved) {
  leaveAsItIs();
  if (saved == feeling_saved_) return;
  feeling_saved_ = saved;
  emit feelingSavedChanged(saved);
  for (const TunedParameter& parameter : parameters_) {
    if (!parameter.changed()) continue;
    emit asked(fromView(parameter.info.id), felt(parameter));
    emit changed(fromView(parameter.info.id));
  }
}

void TuningModel::markSaved(std::string_view id) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr || !parameter->changed()) return;
  parameter->saved = parameter->value;
  emit changed(fromView(id));
}

void TuningModel::markSaved() {
  for (TunedParameter& parameter : parameters_) parameter.saved = parameter.value;
  for (const TunedParameter& parameter : parameters_) emit changed(fromView(parameter.info.id));
}

}  // namespace fyd::widgets
