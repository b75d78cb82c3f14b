#include "app/console/shell/dock_set.h"

#include <QAction>
#include <QChildEvent>
#include <QResizeEvent>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>
#include <functional>

#include "app/console/shell/side_dock.h"

namespace fyd::console {
namespace {

constexpr double kShareOfWidth = 0.16;  // of a large window's, for the panels at each side
constexpr int kLeastHeight = 176;       // px: space for panels that are filled later, such as the readiness list

/// Height without scrolling, at this width.
int heightOf(const QDockWidget& panel, int width) {
  const auto* scroll = qobject_cast<const QScrollArea*>(panel.widget());
  if (scroll == nullptr) return panel.sizeHint().height();
  const QWidget* body = scroll->widget();
  return body->hasHeightForWidth() ? body->heightForWidth(width) + panel.titleBarWidget()->sizeHint().height()
                                   : body->sizeHint().height();
}

/// Width of a panel at the side that nobody has moved.
int standardWidth(const QDockWidget& panel, int window_width) {
  return std::max(panel.minimumSizeHint().width(), static_cast<int>(kShareOfWidth * window_width));
}

/// Names the tab bars that the window makes for panels at one place, and gives panels that nobody has moved their share
/// of a window that gets another width.
class WindowFollower : public QObject {
 public:
  using Unmoved = std::function<QList<QDockWidget*>(int width)>;
  WindowFollower(QMainWindow* window, Unmoved unmoved)
      : QObject(window), window_(*window), unmoved_(std::move(unmoved)) {
    constexpr int kSettled_ms = 50;
    settled_.setSingleShot(true);
    settled_.setInterval(kSettled_ms);
    connect(&settled_, &QTimer::timeout, this, &WindowFollower::resize);
  }

  bool eventFilter(QObject* window, QEvent* event) override {
    if (event->type() == QEvent::Resize) follow(static_cast<QResizeEvent*>(event)->oldSize().width());
    if (event->type() == QEvent::ChildPolished) {
      auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
      if (tabs != nullptr && tabs->accessibleName().isEmpty()) tabs->setAccessibleName(SideDock::tr("Panels"));
    }
    return QObject::eventFilter(window, event);
  }

 private:
  void follow(int former_width) {
    if (former_width <= 0 || !window_.isVisible()) return;
    // A window comes to its size by steps, and its own layout follows the last of them.
    if (following_.isEmpty()) following_ = unmoved_(former_width);
    if (!following_.isEmpty()) settled_.start();
  }
  void resize() {
    const QList<QDockWidget*> panels = std::exchange(following_, {});
    QList<int> widths;
    for (const QDockWidget* panel : panels) widths << standardWidth(*panel, window_.width());
    window_.resizeDocks(panels, widths, Qt::Horizontal);
  }

  QMainWindow& window_;
  Unmoved unmoved_;
  QList<QDockWidget*> following_;
  QTimer settled_;
};

}  // namespace

DockSet::DockSet(QMainWindow& window, Sharing sharing) : window_(window), sharing_(sharing) {
  window_.installEventFilter(new WindowFollower(&window_, [this](int width) { return unmoved(width); }));
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
  // Side panels extend to the window's lower edge, so that bottom panels do not shorten them.
  for (const Qt::Corner corner : {Qt::BottomLeftCorner, Qt::TopLeftCorner}) {
    window_.setCorner(corner, Qt::LeftDockWidgetArea);
  }
  for (const Qt::Corner corner : {Qt::BottomRightCorner, Qt::TopRightCorner}) {
    window_.setCorner(corner, Qt::RightDockWidgetArea);
  }
}

void DockSet::add(QDockWidget* panel, const QString& name, Qt::DockWidgetArea area, bool shown) {
  panel->setObjectName(name);
  panels_.push_back({panel, area, shown});
  place(panels_.back());
}

void DockSet::place(const Panel& panel) {
  window_.addDockWidget(panel.area, panel.dock);
  const auto beside = std::ranges::find(panels_, panel.area, &Panel::area);
  if (sharing_ == Sharing::tabs && beside->dock != panel.dock) window_.tabifyDockWidget(beside->dock, panel.dock);
  panel.dock->setVisible(panel.shown);
}

void DockSet::arrange() {
  for (const Panel& each : panels_) {
    each.dock->setFloating(false);
    window_.removeDockWidget(each.dock);
  }
  QList<QDockWidget*> upright;
  for (const Panel& each : panels_) {
    place(each);
    const bool at_side = each.area == Qt::LeftDockWidgetArea || each.area == Qt::RightDockWidgetArea;
    if (!at_side || !each.shown) continue;
    upright << each.dock;
  }
  const auto resize = [&window = window_, upright] {
    QList<int> widths;
    QList<int> heights;
    for (const QDockWidget* panel : upright) {
      widths << standardWidth(*panel, window.width());
      heights << std::max(heightOf(*panel, widths.last()), kLeastHeight);
    }
    window.resizeDocks(upright, heights, Qt::Vertical);
    window.resizeDocks(upright, widths, Qt::Horizontal);
  };
  resize();
  QMetaObject::invokeMethod(&window_, resize, Qt::QueuedConnection);  // again once the window has its final size
}

QList<QDockWidget*> DockSet::unmoved(int width) const {
  QList<QDockWidget*> out;
  for (const Panel& each : panels_) {
    const bool at_side = each.area == Qt::LeftDockWidgetArea || each.area == Qt::RightDockWidgetArea;
    if (!at_side || !each.shown || each.dock->isFloating() || !each.dock->isVisible()) continue;
    constexpr int kRounding_px = 2;
    if (std::abs(each.dock->width() - standardWidth(*each.dock, width)) <= kRounding_px) out << each.dock;
  }
  return out;
}

void DockSet::restore(const QByteArray& layout) {
  if (layout.isEmpty() || !window_.restoreState(layout, kVersion)) arrange();
}

void connectToggle(QAction* command, QDockWidget* panel) {
  QObject::connect(command, &QAction::triggered, panel, [panel](bool shown) {
    panel->setVisible(shown);
    if (shown) panel->raise();
  });
  // A panel of a place that is left is not visible either, but it is not closed.
  const auto follow = [command, panel] { command->setChecked(!panel->isHidden()); };
  QObject::connect(panel, &QDockWidget::visibilityChanged, command, follow);
  follow();
}

}  // namespace fyd::console
