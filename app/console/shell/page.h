// A place of the window, one entry of its navigation bar: the objects it may use, and calls when it is shown and left.
#pragma once

#include <QWidget>
#include <functional>

#include "app/console/shell/command_registry.h"
#include "app/console/shell/connection_change.h"
#include "app/console/shell/session.h"
#include "app/console/shell/session_feed.h"
#include "app/console/shell/tuning_bridge.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

/// Cause of what is told of an entry for a tuned parameter: it is over with the next value that is taken.
[[nodiscard]] inline QString entryCause(const QString& parameter) { return QStringLiteral("entry ") + parameter; }

/// Objects that the window provides to its places; all of them outlive the places.
struct PageContext {
  Session& session;
  SessionFeed& feed;
  TuningBridge& tuning;
  ConnectionChange& connection;
  QString catalogue;                                            ///< word as after --catalogue; empty: this user's own
  std::function<void(widgets::Severity, const QString&)> tell;  ///< shows a notice, and adds it to the log
  /// The same of something that may pass: it stands in the place of the former one of this cause.
  std::function<void(const QString& cause, widgets::Severity, const QString&)> tell_about;
  std::function<void(const QString& cause)> over;  ///< the cause is gone, and its notices with it
  std::function<void(const QString& text, const QString& file)> written;  ///< the same, with a way to the file's folder
};

/// The state bar with Stop stands above every page; a page has none of its own, and nothing on it is modal.
class Page : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  /// Its commands: in the menus, the palette and by keys only while the page is shown.
  virtual void addCommands(PlaceCommands& commands) { static_cast<void>(commands); }
  virtual void enter() {}  ///< it is shown now
  /// What would be lost if the window closed now, as a phrase; empty: nothing.
  [[nodiscard]] virtual QString unfinished() const { return {}; }
  virtual void leave() {}  ///< another place is shown; a hidden page should use no processor time
};

}  // namespace fyd::console
