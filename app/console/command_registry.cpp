#include "app/console/command_registry.h"

#include <QMenu>

#include "widgets/icon.h"

namespace fyd::console {

const std::vector<CommandInfo>& commandTable() {
  // Arming is no command: it must be held, and a menu cannot be. Esc is heard by the KeyGuard, also in dialogs.
  static const std::vector<CommandInfo> kTable = {
      {"session.stop", QT_TRANSLATE_NOOP("Commands", "Session"), QT_TRANSLATE_NOOP("Commands", "Stop"), "stop", "Esc"},
      {"session.tare", "Session", QT_TRANSLATE_NOOP("Commands", "Tare"), "tare", "Ctrl+T"},
      {"session.target_from_robot", "Session", QT_TRANSLATE_NOOP("Commands", "Target from robot"), "robot", "Ctrl+R"},
      {"session.target_by_hand", "Session", QT_TRANSLATE_NOOP("Commands", "Target by hand"), "", "Ctrl+H"},
      {"session.save_profile", "Session", QT_TRANSLATE_NOOP("Commands", "Save profile"), "save", "Ctrl+S"},
      {"session.quit", "Session", QT_TRANSLATE_NOOP("Commands", "Quit"), "", "Ctrl+Q"},
      {"edit.undo", QT_TRANSLATE_NOOP("Commands", "Edit"), QT_TRANSLATE_NOOP("Commands", "Undo"), "undo", "Ctrl+Z"},
      {"edit.redo", "Edit", QT_TRANSLATE_NOOP("Commands", "Redo"), "redo", "Ctrl+Shift+Z"},
      {"curves.pause", QT_TRANSLATE_NOOP("Commands", "Curves"), QT_TRANSLATE_NOOP("Commands", "Pause or follow"),
       "pause", "Space"},
      {"curves.follow", "Curves", QT_TRANSLATE_NOOP("Commands", "Follow the newest values"), "follow", "F"},
      {"curves.span_5", "Curves", QT_TRANSLATE_NOOP("Commands", "Show 5 s"), "", "Ctrl+1"},
      {"curves.span_10", "Curves", QT_TRANSLATE_NOOP("Commands", "Show 10 s"), "", "Ctrl+2"},
      {"curves.span_30", "Curves", QT_TRANSLATE_NOOP("Commands", "Show 30 s"), "", "Ctrl+3"},
      {"curves.span_60", "Curves", QT_TRANSLATE_NOOP("Commands", "Show 60 s"), "", "Ctrl+4"},
      {"view.mask", QT_TRANSLATE_NOOP("Commands", "View"), QT_TRANSLATE_NOOP("Commands", "Finger mask"), "mask", "M",
       true},
      {"view.log", "View", QT_TRANSLATE_NOOP("Commands", "Log"), "log", "Ctrl+L", true},
      {"view.link", "View", QT_TRANSLATE_NOOP("Commands", "Link"), "link", "Ctrl+Shift+L", true},
      {"view.notices_read", "View", QT_TRANSLATE_NOOP("Commands", "Dismiss all notices"), "check", "Ctrl+D"},
      {"view.theme_dark", "View", QT_TRANSLATE_NOOP("Commands", "Dark theme"), "theme", ""},
      {"view.theme_light", "View", QT_TRANSLATE_NOOP("Commands", "Light theme"), "theme", ""},
      {"view.theme_system", "View", QT_TRANSLATE_NOOP("Commands", "Theme of the system"), "theme", ""},
      {"view.palette", "View", QT_TRANSLATE_NOOP("Commands", "Find a command…"), "search", "Ctrl+K"},
  };
  return kTable;
}

CommandRegistry::CommandRegistry(QWidget* window) : QObject(window) {
  for (const CommandInfo& info : commandTable()) {
    auto* action = new QAction(QCoreApplication::translate("Commands", info.text), window);
    action->setObjectName(QLatin1String(info.id));
    action->setProperty("menu", QLatin1String(info.menu));
    action->setProperty("keys", QLatin1String(info.keys));
    action->setIcon(widgets::icon(QLatin1String(info.icon)));
    action->setIconVisibleInMenu(true);
    action->setCheckable(info.checkable);
    if (QLatin1String(info.keys) != QLatin1String("Esc")) action->setShortcut(QKeySequence(QLatin1String(info.keys)));
    action->setShortcutContext(Qt::WindowShortcut);
    window->addAction(action);
    actions_.push_back(action);
  }
}

void CommandRegistry::on(const QString& id, std::function<void(bool)> run) {
  if (QAction* found = action(id)) connect(found, &QAction::triggered, this, std::move(run));
}

QAction* CommandRegistry::action(const QString& id) const {
  for (QAction* each : actions_) {
    if (each->objectName() == id) return each;
  }
  return nullptr;
}

void CommandRegistry::fill(QMenuBar& bar) const {
  QString name;
  QMenu* menu = nullptr;
  for (QAction* each : actions_) {
    if (const QString wanted = each->property("menu").toString(); wanted != name || menu == nullptr) {
      name = wanted;
      menu = bar.addMenu(QCoreApplication::translate("Commands", name.toUtf8().constData()));
    }
    if (each->shortcut().isEmpty() && !each->property("keys").toString().isEmpty()) {
      each->setText(each->text() + QLatin1Char('\t') + each->property("keys").toString());
    }
    menu->addAction(each);
  }
}

}  // namespace fyd::console
