#include "app/console/shell/tuning_presets.h"

#include <QMenu>
#include <QUndoCommand>
#include <algorithm>
#include "widgets/basics/core_text.h"

namespace fyd::console {

using widgets::Severity;

/// Undo step of written or deleted files. The first redo does nothing, because the files were changed already.
class PresetCommand : public QUndoCommand {
 public:
  PresetCommand(TuningPresets& presets, const QString& words, std::vector<TuningPresets::Step> steps)
      : QUndoCommand(words), presets_(presets), steps_(std::move(steps)) {}
  void undo() override {
    for (const TuningPresets::Step& step : steps_) put(step.name, step.before);
    emit presets_.changed();
  }
  void redo() override {
    if (!done_) {
      done_ = true;
      return;
    }
    for (const TuningPresets::Step& step : steps_) put(step.name, step.after);
    emit presets_.changed();
  }

 private:
  void put(const std::string& name, const std::optional<std::string>& text) {
    if (const auto ok = presets_.put(name, text); !ok) {
      emit presets_.told(Severity::error, widgets::coreText(ok.error().message));
    }
  }

  TuningPresets& presets_;
  std::vector<TuningPresets::Step> steps_;
  bool done_ = false;
};

TuningPresets::TuningPresets(Session& session, widgets::TuningModel& model, std::string folder, QObject* parent)
    : QObject(parent), session_(session), model_(model), folder_(std::move(folder)) {}

QStringList TuningPresets::names() const {
  QStringList out;
  for (const std::string& name : station::presetNames(folder_)) out << QString::fromStdString(name);
  return out;
}

station::Profile TuningPresets::current() const {
  station::Profile profile = session_.currentProfile();
  const auto bound = bindParameters(profile);
  for (const widgets::TunedParameter& tuned : model_.parameters()) {
    if (const Parameter* parameter = findParameter(bound, tuned.info.id);
        parameter != nullptr && tuned.info.info.live) {
      parameter->set(tuned.value);
    }
  }
  return profile;
}

std::optional<std::string> TuningPresets::present(const std::string& name) const {
  auto text = station::readPreset(folder_, name);
  return text ? std::optional(std::move(*text)) : std::nullopt;
}

Result<void> TuningPresets::put(const std::string& name, const std::optional<std::string>& text) {
  return text ? station::writePreset(folder_, name, *text) : station::removePreset(folder_, name);
}

Result<void> TuningPresets::perform(const QString& words, std::vector<Step> steps) {
  for (const Step& step : steps) {
    if (auto ok = put(step.name, step.after); !ok) return ok;
  }
  model_.undoStack()->push(new PresetCommand(*this, words, std::move(steps)));
  emit changed();
  return {};
}

Result<void> TuningPresets::save(const QString& name) {
  const std::string key = name.toStdString();
  if (auto good = station::checkPresetName(key); !good) return good;
  return perform(tr("saving of preset %1").arg(name),
                 {{.name = key, .before = present(key), .after = station::formatPreset(current())}});
}

Result<void> TuningPresets::load(const QString& name) {
  const std::string key = name.toStdString();
  const auto text = station::readPreset(folder_, key);
  if (!text) return tl::unexpected(text.error());
  auto profile = station::parsePreset(*text, key + ".toml", current());
  if (!profile) return tl::unexpected(profile.error());
  std::vector<widgets::Setting> settings;
  for (const Parameter& parameter : bindParameters(*profile)) {
    if (!station::isInPreset(parameter)) continue;
    settings.push_back({.id = std::string(parameter.id), .value = parameter.value()});
  }
  return model_.changeAll(tr("preset %1").arg(name), settings);
}

Result<void> TuningPresets::rename(const QString& from, const QString& to) {
  const std::string former = from.toStdString();
  const std::string key = to.toStdString();
  if (auto good = station::checkPresetName(key); !good) return good;
  if (present(key)) return fail("preset '{}': there is one of this name; delete it first or choose another name", key);
  const auto text = station::readPreset(folder_, former);
  if (!text) return tl::unexpected(text.error());
  return perform(tr("renaming of preset %1").arg(from), {{.name = key, .before = std::nullopt, .after = *text},
                                                         {.name = former, .before = *text, .after = std::nullopt}});
}

Result<void> TuningPresets::remove(const QString& name) {
  const std::string key = name.toStdString();
  const auto text = station::readPreset(folder_, key);
  if (!text) return tl::unexpected(text.error());
  return perform(tr("deleting of preset %1").arg(name), {{.name = key, .before = *text, .after = std::nullopt}});
}

void TuningPresets::feed(QMenu& menu) {
  connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
    menu.clear();
    const QStringList all = names();
    if (all.isEmpty()) menu.addAction(tr("No preset yet; the place Tune saves one"))->setEnabled(false);
    for (const QString& name : all) {
      connect(menu.addAction(name), &QAction::triggered, this, [this, name] {
        if (const auto ok = load(name); !ok) emit told(Severity::warning, widgets::coreText(ok.error().message));
      });
    }
  });
}

}  // namespace fyd::console
