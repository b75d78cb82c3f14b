// The window's frame: the rail of places at the left, the state bar with Stop above whatever place is shown.
#pragma once

#include <QStackedWidget>
#include <QWidget>
#include <map>

#include "app/console/command_registry.h"
#include "app/console/page.h"
#include "widgets/rail.h"
#include "widgets/state_bar.h"

namespace fyd::console {

class Frame : public QWidget {
  Q_OBJECT
 public:
  /// Makes every place, and a command for each.
  Frame(const PageContext& context, CommandRegistry& commands, QWidget* parent = nullptr);

  /// Shows a place; an unknown one changes nothing.
  void go(const QString& place);
  [[nodiscard]] const QString& place() const { return place_; }
  [[nodiscard]] Page* page(const QString& place) const;
  [[nodiscard]] widgets::StateBar* stateBar() const { return state_bar_; }
  [[nodiscard]] widgets::Rail* rail() const { return rail_; }
  [[nodiscard]] QStackedWidget* stack() const { return stack_; }

 private:
  CommandRegistry& commands_;
  widgets::Rail* rail_;
  widgets::StateBar* state_bar_;
  QStackedWidget* stack_;
  std::map<QString, Page*> pages_;
  QString place_;
};

}  // namespace fyd::console
