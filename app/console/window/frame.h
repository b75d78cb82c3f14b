// The window's frame: the navigation bar at the left; beside it the state bar with Stop, below that a line that guides
// when there is one, the shown place with the window's panels around it, and the notices at the lower edge. Panels open below the state bar, so nothing in it
// moves; a place that needs more room than there is scrolls.
#pragma once

#include <QMainWindow>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QWidget>
#include <map>

#include "app/console/shell/command_registry.h"
#include "app/console/shell/page.h"
#include "widgets/basics/navigation_bar.h"
#include "widgets/status/guide_strip.h"
#include "widgets/status/notice_stack.h"
#include "widgets/status/state_bar.h"

namespace fyd::console {

class Frame : public QWidget {
  Q_OBJECT
 public:
  /// Makes every place, and a command for each.
  Frame(const PageContext& context, CommandRegistry& commands, QWidget* parent = nullptr);

  /// Puts a line above the places, below the state bar.
  void addStrip(widgets::GuideStrip* strip);
  /// Shows a place; an unknown one changes nothing.
  void go(const QString& place);
  [[nodiscard]] const QString& place() const { return place_; }
  [[nodiscard]] Page* page(const QString& place) const;
  /// The shown place's button in the navigation bar.
  [[nodiscard]] QWidget* placeButton() const;
  [[nodiscard]] widgets::StateBar* stateBar() const { return state_bar_; }
  [[nodiscard]] widgets::NavigationBar* navigationBar() const { return navigation_bar_; }
  [[nodiscard]] widgets::NoticeStack* notices() const { return notices_; }
  /// Where the window's panels open, around the places.
  [[nodiscard]] QMainWindow* panelArea() const { return panel_area_; }
  [[nodiscard]] QStackedWidget* stack() const { return stack_; }

 private:
  CommandRegistry& commands_;
  QVBoxLayout* strips_ = nullptr;
  widgets::NavigationBar* navigation_bar_ = nullptr;
  widgets::StateBar* state_bar_ = nullptr;
  widgets::NoticeStack* notices_ = nullptr;
  QMainWindow* panel_area_ = nullptr;
  QScrollArea* area_ = nullptr;  ///< around the places
  QStackedWidget* stack_ = nullptr;
  std::map<QString, Page*> pages_;
  QString place_;
};

}  // namespace fyd::console
