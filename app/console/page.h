// A place of the window, one entry of its rail: what it may use, and when it is told that it is looked at.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/console/command_registry.h"
#include "app/console/session.h"
#include "app/console/session_feed.h"
#include "app/console/tuning_bridge.h"
#include "widgets/notice_stack.h"

namespace fyd::console {

/// What the window lends its places; all of it outlives them.
struct PageContext {
  Session& session;
  SessionFeed& feed;
  TuningBridge& tuning;
  QString catalogue;  ///< word as after --catalogue; empty: this user's own
  std::function<void(widgets::Severity, const QString&)> tell;  ///< slides in as a notice, and goes to the log
};

/// The state bar with Stop stands above every page; a page has none of its own, and nothing on it is modal.
class Page : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  /// Its commands: in the menus, the palette and by keys only while the page is shown.
  virtual void addCommands(PlaceCommands& commands) { static_cast<void>(commands); }
  virtual void enter() {}  ///< it is shown now
  virtual void leave() {}  ///< another place is shown; a hidden page should cost nothing
};

/// How a place is offered.
struct PlaceInfo {
  const char* id;    ///< "devices", of --page; its command is "place.devices"
  const char* word;  ///< beside the icon, until the icon is learned
  const char* icon;
  const char* keys;
  Page* (*make)(const PageContext& context, QWidget* parent);
};

/// In the rail's order. A place appears when it exists.
[[nodiscard]] const std::vector<PlaceInfo>& places();

}  // namespace fyd::console
