#include "app/console/tune_page.h"

#include <QHBoxLayout>
#include <QTabBar>
#include <QVBoxLayout>

#include "app/console/tuning_readback_lines.h"
#include "widgets/core_text.h"
#include "widgets/icon.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

using widgets::kGrid;
using widgets::Severity;

/// What a proposal replaces, and where it stands in the parameters.
struct TunedGain {
  const char* id;
  double control::ControlParameters::*field;
};
constexpr std::array kTunedGains = {
    TunedGain{"control.kp", &control::ControlParameters::kp},
    TunedGain{"control.ki", &control::ControlParameters::ki_per_s},
    TunedGain{"control.kd", &control::ControlParameters::kd_s},
    TunedGain{"control.measurement_lag_s", &control::ControlParameters::measurement_lag_s},
    TunedGain{"control.measurement_delay_s", &control::ControlParameters::measurement_delay_s},
    TunedGain{"control.noise_correlation_s", &control::ControlParameters::noise_correlation_s},
};

/// The control parameters with the model's values, saved or current.
control::ControlParameters withValues(control::ControlParameters parameters, const widgets::TuningModel& model,
                                      double widgets::TunedParameter::*which) {
  for (const Parameter& parameter : bindParameters(parameters)) {
    if (const widgets::TunedParameter* tuned = model.find(parameter.id)) parameter.set(tuned->*which);
  }
  return parameters;
}

}  // namespace

TunePage::TunePage(const PageContext& context, QWidget* parent)
    : Page(parent),
      context_(context),
      model_(context.tuning.model()),
      list_(new widgets::TuningList(model_, this)),
      compare_(new widgets::TuningCompare(model_, this)),
      response_(new widgets::TuningResponse(this)),
      differences_(new widgets::TuningDifferences(model_, this)),
      presets_(new widgets::TuningPresetList(this)),
      proposal_(new widgets::TuningProposal(this)),
      readback_(new widgets::TuningReadback(this)),
      tabs_(new QTabWidget(this)),
      live_(new QLabel(this)) {
  build();
  connectModel();
  connectPresets();
  connectStudy();
}

void TunePage::build() {
  auto* left = new QFrame(this);
  left->setProperty("surface", "panel");
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(list_, 1);
  column->addWidget(buildFoot());
  auto* above = new QFrame(this);
  above->setProperty("surface", "panel");
  auto* above_layout = new QVBoxLayout(above);
  above_layout->setContentsMargins(0, 0, 0, 0);
  above_layout->addWidget(response_);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setAccessibleName(tr("Differences, presets, auto-tune, read back"));
  tabs_->addTab(differences_, tr("Differences"));
  tabs_->addTab(presets_, tr("Presets"));
  tabs_->addTab(proposal_, tr("Auto-tune"));
  tabs_->addTab(readback_, tr("Read back"));
  auto* right = new QVBoxLayout;
  right->setSpacing(kGrid);
  right->addWidget(above, 1);
  right->addWidget(tabs_, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(left, 1);
  layout->addLayout(right, 1);

  if (context_.session.simulated()) sources_.push_back(TuneSource::simulation);
  sources_.push_back(TuneSource::session);
  QStringList names;
  for (const TuneSource source : sources_) {
    names << (source == TuneSource::simulation ? tr("From the simulated touchpad, 12 s of virtual time")
                                               : tr("From the last minute of this session"));
  }
  proposal_->setSources(names);
}

QWidget* TunePage::buildFoot() {
  auto* foot = new QWidget(this);
  auto* layout = new QHBoxLayout(foot);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid);
  layout->setSpacing(kGrid / 2);
  const auto button = [&](const char* name, const QString& symbol, const QString& words) {
    auto* made = new QToolButton(foot);
    made->setObjectName(QLatin1String(name));
    made->setIcon(widgets::icon(symbol));
    made->setAccessibleName(words);
    layout->addWidget(made);
    return made;
  };
  undo_ = button("tune_undo", QStringLiteral("undo"), tr("Undo"));
  redo_ = button("tune_redo", QStringLiteral("redo"), tr("Redo"));
  layout->addSpacing(kGrid);
  layout->addWidget(compare_);
  layout->addSpacing(kGrid);
  live_->setObjectName(QStringLiteral("tune_live"));
  live_->setFont(widgets::textFont(widgets::TextSize::small));
  live_->setProperty("role", "muted");
  live_->setAccessibleName(tr("Stiffness, measured and target"));
  live_->setToolTip(live_->accessibleName());
  layout->addWidget(live_, 1);
  save_ = new QPushButton(tr("Save profile"), foot);
  save_->setObjectName(QStringLiteral("tune_save"));
  save_->setIcon(widgets::icon(QStringLiteral("save")));
  save_->setAutoDefault(false);
  layout->addWidget(save_);
  connect(undo_, &QToolButton::clicked, &model_, &widgets::TuningModel::undo);
  connect(redo_, &QToolButton::clicked, &model_, &widgets::TuningModel::redo);
  connect(save_, &QPushButton::clicked, &context_.tuning, &TuningBridge::save);
  return foot;
}

void TunePage::connectModel() {
  const auto refuse = [this](const QString& why) { context_.tell(Severity::warning, why); };
  connect(list_, &widgets::TuningList::refused, this, refuse);
  connect(differences_, &widgets::TuningDifferences::refused, this, refuse);
  connect(&model_, &widgets::TuningModel::changed, this, [this](const QString& id) {
    refreshFoot();
    if (shown_ && id.startsWith(QLatin1String("control."))) studyValues();
  });
  connect(&model_, &widgets::TuningModel::feelingSavedChanged, this, &TunePage::refreshFoot);
  constexpr int kRead_ms = 500;
  reading_.setInterval(kRead_ms);
  connect(&reading_, &QTimer::timeout, this, &TunePage::readBack);
  connect(model_.undoStack(), &QUndoStack::indexChanged, this, &TunePage::refreshFoot);
  connect(&context_.feed, &SessionFeed::telemetry, this, [this](std::span<const pipeline::TelemetrySample> samples) {
    study_.listen(samples);
    newest_ = samples.back();
    if (shown_) showLive(samples);
  });
  refreshFoot();
}

void TunePage::connectPresets() {
  TuningPresets* files = &context_.tuning.presets();
  const auto show = [this, files] { presets_->setNames(files->names()); };
  connect(files, &TuningPresets::changed, this, show);
  connect(presets_, &widgets::TuningPresetList::saveAsked, this,
          [this, files](const QString& name) { showTaken(files->save(name)); });
  connect(presets_, &widgets::TuningPresetList::loadAsked, this,
          [this, files](const QString& name) { showTaken(files->load(name)); });
  connect(presets_, &widgets::TuningPresetList::renameAsked, this,
          [this, files](const QString& from, const QString& to) { showTaken(files->rename(from, to)); });
  connect(presets_, &widgets::TuningPresetList::removeAsked, this,
          [this, files](const QString& name) { showTaken(files->remove(name)); });
  show();
}

void TunePage::showTaken(const Result<void>& taken) {
  presets_->setProblem(taken ? QString() : widgets::coreText(taken.error().message));
}

void TunePage::connectStudy() {
  using widgets::TuningResponse;
  connect(&study_, &LoopStudy::respondingChanged, response_, &TuningResponse::setBusy);
  connect(&study_, &LoopStudy::responses, this,
          [this](const widgets::ResponseView& current, const widgets::ResponseView& saved) {
            response_->setResponse(TuningResponse::current, current);
            response_->setResponse(TuningResponse::saved, saved);
          });
  connect(&study_, &LoopStudy::tuningChanged, proposal_, &widgets::TuningProposal::showRunning);
  connect(&study_, &LoopStudy::progressed, proposal_, &widgets::TuningProposal::showProgress);
  connect(&study_, &LoopStudy::proposed, this, &TunePage::showProposal);
  connect(&study_, &LoopStudy::failed, proposal_, &widgets::TuningProposal::clear);
  connect(proposal_, &widgets::TuningProposal::startAsked, this, [this](int source) {
    response_->clearResponse(TuningResponse::proposed);
    study_.autoTune(sources_.at(static_cast<std::size_t>(source)), context_.session.currentProfile());
  });
  connect(proposal_, &widgets::TuningProposal::cancelAsked, this, [this] {
    study_.cancel();
    proposal_->clear(tr("Cancelled; nothing was changed."));
  });
  connect(proposal_, &widgets::TuningProposal::acceptAsked, this, &TunePage::acceptProposal);
  connect(proposal_, &widgets::TuningProposal::discardAsked, this,
          [this] { discardProposal(tr("Discarded; nothing was changed.")); });
}

void TunePage::refreshFoot() {
  const QUndoStack* stack = model_.undoStack();
  const bool saved = model_.feelingSaved();
  undo_->setEnabled(stack->canUndo() || saved);
  redo_->setEnabled(stack->canRedo() || saved);
  undo_->setToolTip(stack->canUndo() ? tr("Undo %1 (Ctrl+Z)").arg(stack->undoText()) : tr("Nothing to undo"));
  redo_->setToolTip(stack->canRedo() ? tr("Redo %1 (Ctrl+Shift+Z)").arg(stack->redoText()) : tr("Nothing to redo"));
  save_->setText(model_.anyChanged() ? tr("• Save profile") : tr("Save profile"));
  save_->setToolTip(model_.anyChanged() ? tr("Marked values differ from the profile (Ctrl+S)")
                                        : tr("Nothing differs from the profile (Ctrl+S)"));
}

void TunePage::studyValues() {
  const control::ControlParameters base = context_.session.currentProfile().step.control;
  study_.setValues(withValues(base, model_, &widgets::TunedParameter::value),
                   withValues(base, model_, &widgets::TunedParameter::saved));
  QString words = study_.proposal() ? tr("On the cloth that auto-tune identified, 30 % softer than its law says.")
                                    : tr("On a cloth 30 % softer than its law says, with the sensors that the profile "
                                         "describes. Auto-tune finds out more.");
  if (base.mode == control::ControlMode::thesis) {
    words += QLatin1Char(' ') + tr("The touchpad runs mode thesis; these courses are of mode default.");
  }
  response_->setGround(words);
}

void TunePage::showProposal(const widgets::ResponseView& response) {
  const control::TuneProposal& found = *study_.proposal();
  std::vector<widgets::ProposalLine> lines;
  for (const TunedGain& gain : kTunedGains) {
    const widgets::TunedParameter* tuned = std::as_const(model_).find(gain.id);
    if (tuned == nullptr) continue;
    const std::string_view unit = tuned->info.info.unit;
    lines.push_back({.id = QLatin1String(gain.id),
                     .unit = unit == "1" ? QString() : QString::fromStdString(std::string(unit)),
                     .present = tuned->value,
                     .proposed = found.proposed.*gain.field});
  }
  const control::IdentifiedFabric& fabric = found.fabric;
  proposal_->showProposal(
      lines,
      tr("Cloth %1 times its law's stiffness; sensors %2 s late with a lag of %3 s, noise %4 %. The courses above "
         "show what the proposal would do. Nothing is changed yet.")
          .arg(widgets::numberText(fabric.scale, 2), widgets::numberText(fabric.delay_s, 2),
               widgets::numberText(fabric.lag_s, 2), widgets::numberText(100 * fabric.residual_rms_relative, 1)));
  response_->setResponse(widgets::TuningResponse::proposed, response);
  studyValues();
}

void TunePage::acceptProposal() {
  if (!study_.proposal()) return;
  std::vector<widgets::Setting> settings;
  for (const TunedGain& gain : kTunedGains) {
    settings.push_back({.id = gain.id, .value = study_.proposal()->proposed.*gain.field});
  }
  if (const auto ok = model_.changeAll(tr("auto-tune"), settings); !ok) {
    context_.tell(Severity::warning, tr("The proposal was not taken: %1").arg(widgets::coreText(ok.error().message)));
    return;
  }
  response_->clearResponse(widgets::TuningResponse::proposed);
  proposal_->clear(tr("Accepted: the proposed values are in use. Undo takes them back, Save profile keeps them."));
  studyValues();
}

void TunePage::discardProposal(const QString& words) {
  study_.discard();
  response_->clearResponse(widgets::TuningResponse::proposed);
  proposal_->clear(words);
  studyValues();
}

void TunePage::showLive(std::span<const pipeline::TelemetrySample> samples) {
  const pipeline::TelemetrySample& newest = samples.back();
  const double measured = newest.stiffness_observable ? newest.stiffness_N_per_mm : std::nan("");
  live_->setText(
      tr("%1 / %2 N/mm").arg(widgets::numberText(measured, 2), widgets::numberText(newest.target_N_per_mm, 2)));
}

void TunePage::findParameter() {
  list_->search()->setFocus(Qt::ShortcutFocusReason);
  list_->search()->selectAll();
}

void TunePage::enter() {
  shown_ = true;
  presets_->setNames(context_.tuning.presets().names());  // another program may have written one
  studyValues();
  readBack();
  reading_.start();
}

void TunePage::leave() {
  shown_ = false;
  reading_.stop();
}

void TunePage::readBack() { readback_->setLines(readbackLines(model_, newest_, context_.session.devices())); }

void TunePage::addCommands(PlaceCommands& commands) {
  widgets::TuningModel* model = &model_;
  commands.add({"tune.undo", "Edit", "Undo", "undo", "Ctrl+Z"}, [model](bool) { model->undo(); });
  commands.add({"tune.redo", "Edit", "Redo", "redo", "Ctrl+Shift+Z"}, [model](bool) { model->redo(); });
  commands.add({"tune.compare", "Edit", "Feel saved or current values", "", "Ctrl+B"},
               [model](bool) { model->feelSaved(!model->feelingSaved()); });
  commands.add({"tune.find", QT_TRANSLATE_NOOP("Commands", "Tune"), QT_TRANSLATE_NOOP("Commands", "Find a parameter…"),
                "search", "Ctrl+F"},
               [this](bool) { findParameter(); });
  commands.add({"tune.only_changed", "Tune", QT_TRANSLATE_NOOP("Commands", "Only what differs"), "", "Ctrl+Shift+F"},
               [this](bool) { list_->onlyChanged()->toggle(); });
  const auto press = [&](const char* id, const char* words, const char* icon, const char* keys, QWidget* tab,
                         QPushButton* button) {
    commands.add({id, "Tune", words, icon, keys}, [this, tab, button](bool) {
      tabs_->setCurrentWidget(tab);
      button->click();
    });
  };
  press("tune.revert_selected", QT_TRANSLATE_NOOP("Commands", "Selected values back to saved"), "saved", "",
        differences_, differences_->revertButton());
  press("tune.revert_all", QT_TRANSLATE_NOOP("Commands", "All values back to saved"), "saved", "Ctrl+Shift+R",
        differences_, differences_->revertAllButton());
  commands.add({"tune.preset_name", "Tune", QT_TRANSLATE_NOOP("Commands", "Save a preset…"), "preset", "Ctrl+Shift+P"},
               [this](bool) {
                 tabs_->setCurrentWidget(presets_);
                 presets_->nameField()->setFocus(Qt::ShortcutFocusReason);
               });
  press("tune.preset_load", QT_TRANSLATE_NOOP("Commands", "Load the chosen preset"), "preset", "", presets_,
        presets_->loadButton());
  press("tune.preset_rename", QT_TRANSLATE_NOOP("Commands", "Rename the chosen preset"), "", "", presets_,
        presets_->renameButton());
  press("tune.preset_delete", QT_TRANSLATE_NOOP("Commands", "Delete the chosen preset"), "", "", presets_,
        presets_->removeButton());
  press("tune.auto_tune", QT_TRANSLATE_NOOP("Commands", "Auto-tune"), "", "Ctrl+U", proposal_,
        proposal_->startButton());
  press("tune.auto_tune_cancel", QT_TRANSLATE_NOOP("Commands", "Cancel auto-tune"), "", "", proposal_,
        proposal_->cancelButton());
  press("tune.auto_tune_accept", QT_TRANSLATE_NOOP("Commands", "Accept the proposed values"), "check", "", proposal_,
        proposal_->acceptButton());
  press("tune.auto_tune_discard", QT_TRANSLATE_NOOP("Commands", "Discard the proposed values"), "cross", "", proposal_,
        proposal_->discardButton());
}

}  // namespace fyd::console
