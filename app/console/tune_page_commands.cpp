// The commands of the place "Tune".
#include "app/console/tune_page.h"

namespace fyd::console {

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
