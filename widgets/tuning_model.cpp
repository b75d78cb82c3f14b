#include "widgets/tuning_model.h"

#include <QElapsedTimer>
#include <QUndoCommand>

#include "widgets/number_text.h"

namespace fyd::widgets {

/// One step of the undo stack. Steps of one drag of a slider become one.
class ChangeCommand : public QUndoCommand {
 public:
  ChangeCommand(TuningModel& model, QString id, double from, double to, bool merge)
      : model_(model), id_(std::move(id)), from_(from), to_(to), merge_(merge) {
    setText(TuningModel::tr("%1 to %2").arg(id_, plainNumber(to_)));
    age_.start();
  }
  void undo() override { model_.store(id_, from_); }
  void redo() override { model_.store(id_, to_); }
  int id() const override { return merge_ ? 1 : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    constexpr qint64 kSameDrag_ms = 800;
    const auto* next = static_cast<const ChangeCommand*>(other);
    if (next->id_ != id_ || age_.elapsed() > kSameDrag_ms) return false;
    to_ = next->to_;
    age_.start();
    setText(next->text());
    return true;
  }

 private:
  TuningModel& model_;
  QString id_;
  double from_;
  double to_;
  bool merge_;
  QElapsedTimer age_;
};

TuningModel::TuningModel(QObject* parent) : QObject(parent), undo_(this) {}

void TuningModel::load(std::span<const Parameter> current, std::span<const Parameter> defaults) {
  undo_.clear();
  parameters_.clear();
  for (std::size_t i = 0; i < current.size(); ++i) {
    if (current[i].kind == ParameterKind::list) continue;
    const double value = current[i].value();
    parameters_.push_back({.info = current[i], .value = value, .saved = value, .standard = defaults[i].value()});
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
  for (const TunedParameter& parameter : parameters_) {
    if (parameter.changed()) return true;
  }
  return false;
}

Result<void> TuningModel::change(std::string_view id, double value, bool merge) {
  const TunedParameter* parameter = find(id);
  if (parameter == nullptr) return fail("{}: no such parameter", id);
  const auto checked = checkParameter(parameter->info, value);
  if (!checked) return tl::unexpected(checked.error());
  if (value == parameter->value) return {};
  const QString name = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
  undo_.push(new ChangeCommand(*this, name, parameter->value, value, merge));
  return {};
}

void TuningModel::store(const QString& id, double value) {
  const std::string name = id.toStdString();
  TunedParameter* parameter = entry(name);
  if (parameter == nullptr) return;
  parameter->value = value;
  emit asked(id, value);
  emit changed(id);
}

void TuningModel::accept(std::string_view id, double value) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr || parameter->value == value) return;
  parameter->value = value;
  emit changed(QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())));
}

void TuningModel::resetToDefault(std::string_view id) {
  if (const TunedParameter* parameter = find(id)) (void)change(id, parameter->standard);
}

void TuningModel::markSaved(std::string_view id) {
  TunedParameter* parameter = entry(id);
  if (parameter == nullptr || !parameter->changed()) return;
  parameter->saved = parameter->value;
  emit changed(QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())));
}

void TuningModel::markSaved() {
  for (TunedParameter& parameter : parameters_) parameter.saved = parameter.value;
  for (const TunedParameter& parameter : parameters_) {
    emit changed(QString::fromUtf8(parameter.info.id.data(), static_cast<qsizetype>(parameter.info.id.size())));
  }
}

}  // namespace fyd::widgets
