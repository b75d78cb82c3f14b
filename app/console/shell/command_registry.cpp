#include "app/console/shell/command_registry.h"

#include <QCoreApplication>
#include <algorithm>

#include "widgets/basics/icon.h"

namespace fyd::console {
namespace {

/// The title with "&" before the letter that opens its menu with Alt: its first one that no menu before it has.
QString withLetter(const QString& title, QString& taken) {
  for (qsizetype i = 0; i < title.size(); ++i) {
    if (!title[i].isLetter() || taken.contains(title[i], Qt::CaseInsensitive)) continue;
    taken += title[i];
    return QString(title).insert(i, QLatin1Char('&'));
  }
  return title;
}

}  // namespace

const std::vector<CommandInfo>& commandTable() {
  // No command arms: the one that is found leads to the button, which must be held. Esc is handled by the KeyGuard, also in dialogs.
  static const std::vector<CommandInfo> kTable = {
      {"session.stop", QT_TRANSLATE_NOOP("Commands", "Session"), QT_TRANSLATE_NOOP("Commands", "Stop"), "stop", "Esc"},
      {"session.arm", "Session", QT_TRANSLATE_NOOP("Commands", "Arm: go to the button that is held"), "arm", ""},
      {"session.tare", "Session", QT_TRANSLATE_NOOP("Commands", "Tare"), "tare", "Ctrl+T"},
      {"session.next_trial", "Session", QT_TRANSLATE_NOOP("Commands", "Next trial"), "", "Ctrl+Shift+M"},
      {"session.save_profile", "Session", QT_TRANSLATE_NOOP("Commands", "Save profile"), "save", "Ctrl+S"},
      {"session.quit", "Session", QT_TRANSLATE_NOOP("Commands", "Quit"), "", "Ctrl+Q"},
      {"view.log", QT_TRANSLATE_NOOP("Commands", "View"), QT_TRANSLATE_NOOP("Commands", "Log"), "log", "Ctrl+L", true},
      {"view.link", "View", QT_TRANSLATE_NOOP("Commands", "Link"), "link", "Ctrl+Shift+L", true},
      {"view.notices_read", "View", QT_TRANSLATE_NOOP("Commands", "Dismiss all notices"), "check", "Ctrl+D"},
      {"view.theme_dark", "View", QT_TRANSLATE_NOOP("Commands", "Dark theme"), "theme", ""},
      {"view.theme_light", "View", QT_TRANSLATE_NOOP("Commands", "Light theme"), "theme", ""},
      {"view.theme_system", "View", QT_TRANSLATE_NOOP("Commands", "Theme of the system"), "theme", ""},
      {"view.layouts", "View", QT_TRANSLATE_NOOP("Commands", "Layouts…"), "", "Ctrl+Shift+Y"},
      {"view.layout_standard", "View", QT_TRANSLATE_NOOP("Commands", "Standard layout"), "", ""},
      {"view.language_en", "View", QT_TRANSLATE_NOOP("Commands", "Language: English"), "", ""},
      {"view.language_it", "View", QT_TRANSLATE_NOOP("Commands", "Language: Italian"), "", ""},
      {"view.language_fr", "View", QT_TRANSLATE_NOOP("Commands", "Language: French"), "", ""},
      {"help.context", QT_TRANSLATE_NOOP("Commands", "Help"),
       QT_TRANSLATE_NOOP("Commands", "Help for what is in focus"), "info", "F1"},
      {"help.manual", "Help", QT_TRANSLATE_NOOP("Commands", "Manual"), "", "Shift+F1", true},
      {"help.first_steps", "Help", QT_TRANSLATE_NOOP("Commands", "First steps"), "", ""},
      {"view.palette", "View", QT_TRANSLATE_NOOP("Commands", "Find a command…"), "search", "Ctrl+K"},
  };
  return kTable;
}

CommandRegistry::CommandRegistry(QWidget* window) : QObject(window), window_(window) {
  for (const CommandInfo& info : commandTable()) make(info);
}

QAction* CommandRegistry::make(const CommandInfo& info) {
  auto* action = new QAction(QCoreApplication::translate("Commands", info.text), window_);
  action->setObjectName(QLatin1String(info.id));
  action->setProperty("menu", QLatin1String(info.menu));
  action->setProperty("keys", QLatin1String(info.keys));
  action->setIcon(widgets::icon(QLatin1String(info.icon)));
  action->setIconVisibleInMenu(true);
  action->setCheckable(info.checkable);
  if (QLatin1String(info.keys) != QLatin1String("Esc")) action->setShortcut(QKeySequence(QLatin1String(info.keys)));
  action->setShortcutContext(Qt::WindowShortcut);
  window_->addAction(action);
  actions_.push_back(action);
  return action;
}

QAction* CommandRegistry::add(const CommandInfo& info, std::function<void(bool)> run, const QString& place) {
  QAction* action = make(info);
  action->setProperty("place", place);
  action->setVisible(place.isEmpty());
  connect(action, &QAction::triggered, this, std::move(run));
  return action;
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

void CommandRegistry::showPlace(const QString& place) {
  // Invisible commands have no keys either. Commands are hidden before others are shown, so that two never share keys.
  for (const bool visible : {false, true}) {
    for (QAction* each : actions_) {
      const QString own = placeOf(*each);
      if (!own.isEmpty() && (own == place) == visible) each->setVisible(visible);
    }
  }
  hideEmptyMenus();
}

void CommandRegistry::fill(QMenuBar& bar) {
  // The window's first menu, the places' in their order, and view and help at the end.
  QStringList names;
  const QStringList last = {QStringLiteral("View"), QStringLiteral("Help")};
  for (const QAction* each : actions_) {
    const QString name = each->property("menu").toString();
    if (!last.contains(name) && !names.contains(name)) names << name;
  }
  QString letters;
  for (const QString& name : names << last) {
    QMenu* menu = bar.addMenu(withLetter(QCoreApplication::translate("Commands", name.toUtf8().constData()), letters));
    menus_.push_back(menu);
    // The places stand first in the view's menu.
    for (const bool place : {true, false}) {
      for (QAction* each : actions_) {
        if (each->property("menu").toString() != name) continue;
        if (each->objectName().startsWith(QLatin1String("place.")) == place) menu->addAction(each);
      }
    }
  }
  for (QAction* each : actions_) {
    if (each->shortcut().isEmpty() && !each->property("keys").toString().isEmpty()) {
      each->setText(each->text() + QLatin1Char('\t') + each->property("keys").toString());
    }
  }
  hideEmptyMenus();
}

void CommandRegistry::hideEmptyMenus() {
  for (QMenu* menu : menus_) {
    const auto actions = menu->actions();
    menu->menuAction()->setVisible(
        std::any_of(actions.begin(), actions.end(), [](const QAction* each) { return each->isVisible(); }));
  }
}

}  // namespace fyd::console
