// Every command of the window stands in one table: id, words, icon, keys, menu. The menus, the shortcuts and the
// command palette are made of it; the window says what each id does.
#pragma once

#include <QAction>
#include <QMenuBar>
#include <QObject>
#include <functional>
#include <vector>

namespace fyd::console {

struct CommandInfo {
  const char* id;
  const char* menu;  ///< "Session"
  const char* text;  ///< sentence case; "…" only where more input follows
  const char* icon;
  const char* keys;
  bool checkable = false;
};

/// The table.
[[nodiscard]] const std::vector<CommandInfo>& commandTable();

class CommandRegistry : public QObject {
  Q_OBJECT
 public:
  explicit CommandRegistry(QWidget* window);

  /// Says what a command does. @param run gets the new state of a checkable command, else false
  void on(const QString& id, std::function<void(bool)> run);
  [[nodiscard]] QAction* action(const QString& id) const;
  [[nodiscard]] const std::vector<QAction*>& actions() const { return actions_; }
  void fill(QMenuBar& bar) const;

 private:
  std::vector<QAction*> actions_;
};

}  // namespace fyd::console
