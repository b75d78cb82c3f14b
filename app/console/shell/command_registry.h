// Every command of the window: id, words, icon, keys, menu. The menus, the shortcuts and the command palette are made
// of them. Those of the whole window stand in one table; each place adds its own, which exist only while it is shown,
// so that the space bar may pause the curves in one place and play a recording in another.
#pragma once

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QObject>
#include <functional>
#include <utility>
#include <vector>

namespace fyd::console {

struct CommandInfo {
  const char* id = "";
  const char* menu = "";  ///< "Session"
  const char* text = "";  ///< sentence case; "…" only where more input follows
  const char* icon = "";
  const char* keys = "";
  bool checkable = false;
};

/// The commands of the whole window.
[[nodiscard]] const std::vector<CommandInfo>& commandTable();

class CommandRegistry : public QObject {
  Q_OBJECT
 public:
  explicit CommandRegistry(QWidget* window);

  /// @param run gets the new state of a checkable command, else false
  /// @param place the command exists only while this place is shown; empty: always
  QAction* add(const CommandInfo& info, std::function<void(bool)> run, const QString& place = {});
  /// Sets the action of a command of the table.
  void on(const QString& id, std::function<void(bool)> run);
  [[nodiscard]] QAction* action(const QString& id) const;
  /// All, also those of places that are not shown; these are not visible.
  [[nodiscard]] const std::vector<QAction*>& actions() const { return actions_; }
  /// The place a command belongs to; empty: to the window.
  [[nodiscard]] static QString placeOf(const QAction& action) { return action.property("place").toString(); }
  void showPlace(const QString& place);
  /// Fills the menus; to be called after the last command was added.
  void fill(QMenuBar& bar);

 private:
  QAction* make(const CommandInfo& info);
  void hideEmptyMenus();

  QWidget* window_ = nullptr;
  std::vector<QAction*> actions_;
  std::vector<QMenu*> menus_;
};

/// Adds commands for one place.
class PlaceCommands {
 public:
  PlaceCommands(CommandRegistry& registry, QString place) : registry_(registry), place_(std::move(place)) {}
  QAction* add(const CommandInfo& info, std::function<void(bool)> run) {
    return added_.emplace_back(registry_.add(info, std::move(run), place_));
  }
  [[nodiscard]] const std::vector<QAction*>& added() const { return added_; }

 private:
  CommandRegistry& registry_;
  QString place_;
  std::vector<QAction*> added_;
};

}  // namespace fyd::console
