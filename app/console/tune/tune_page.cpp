#include "app/console/tune/tune_page.h"

#include <QHBoxLayout>
#include <QTabBar>
#include <QVBoxLayout>

#include "app/console/tune/tuning_readback_lines.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {

using widgets::kGrid;
using widgets::Severity;

TunePage::TunePage(const PageContext& context, QWidget* parent)
    : Page(parent),
      context_(context),
      model_(context.tuning.model()),
      list_(new widgets::TuningList(model_, this)),
      response_(new widgets::TuningResponse(this)),
      differences_(new widgets::TuningDifferences(model_, this)),
      presets_(new widgets::TuningPresetList(this)),
      proposal_(new widgets::TuningProposal(this)),
      readback_(new widgets::TuningReadback(this)),
      tabs_(new QTabWidget(this)),
      live_(new QLabel(this)),
      foot_(new widgets::TuningFoot(model_, widgets::TuningFoot::Rows::one, live_, this)),
      gains_(new GainStudy(context, response_, proposal_, this)) {
  build();
  connectModel();
  connectPresets();
}

void TunePage::build() {
  auto* left = new QFrame(this);
  left->setProperty("surface", "panel");
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(list_, 1);
  column->addWidget(foot_);
  live_->setObjectName(QStringLiteral("tune_live"));
  live_->setFont(widgets::textFont(widgets::TextSize::small));
  live_->setProperty("role", "muted");
  live_->setAccessibleName(tr("Stiffness, measured and target"));
  live_->setToolTip(live_->accessibleName());
  connect(foot_, &widgets::TuningFoot::saveAsked, &context_.tuning, &TuningBridge::save);
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
}

void TunePage::connectModel() {
  connect(list_, &widgets::TuningList::refused, this, [this](const QString& why, const QString& parameter) {
    context_.tell_about(entryCause(parameter), Severity::warning, why);
  });
  connect(list_, &widgets::TuningList::entered, response_, &widgets::TuningResponse::takeFocus);
  const QString felt = QStringLiteral("saved values felt");
  connect(differences_, &widgets::TuningDifferences::refused, this,
          [this, felt](const QString& why) { context_.tell_about(felt, Severity::warning, why); });
  connect(&model_, &widgets::TuningModel::feelingSavedChanged, this, [this, felt] { context_.over(felt); });
  connect(&model_, &widgets::TuningModel::changed, this, [this](const QString& id) {
    if (shown_ && id.startsWith(QLatin1String("control."))) gains_->studyValues();
  });
  constexpr int kRead_ms = 500;
  reading_.setInterval(kRead_ms);
  connect(&reading_, &QTimer::timeout, this, &TunePage::readBack);
  connect(&context_.feed, &SessionFeed::telemetry, this, [this](std::span<const pipeline::TelemetrySample> samples) {
    context_.tuning.judge().listen(samples);
    gains_->listen(samples);
    newest_ = samples.back();
    if (shown_) showLive(samples);
  });
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

void TunePage::showLive(std::span<const pipeline::TelemetrySample> samples) {
  const pipeline::TelemetrySample& newest = samples.back();
  const double measured = newest.stiffness_observable ? newest.stiffness_N_per_mm : std::nan("");
  live_->setText(
      tr("%1 / %2 N/mm").arg(widgets::numberText(measured, 2), widgets::numberText(newest.target_N_per_mm, 2)));
}

void TunePage::enter() {
  shown_ = true;
  presets_->setNames(context_.tuning.presets().names());  // another program may have written one
  gains_->studyValues();
  readBack();
  reading_.start();
}

void TunePage::leave() {
  shown_ = false;
  reading_.stop();
}

void TunePage::readBack() {
  readback_->setLines(readbackLines(model_, newest_, context_.session.devices()));
  gains_->followTouchpad();
}

void TunePage::findParameter() {
  list_->search()->setFocus(Qt::ShortcutFocusReason);
  list_->search()->selectAll();
}

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
