#include "app/console/shell/dock_set.h"

#include <QAction>
#include <QScrollArea>
#include <algorithm>

namespace fyd::console {
namespace {

constexpr int kLeastHeight = 176;  // px: space for panels that are filled later, such as the readiness list

/// Height without scrolling.
int heightOf(const QDockWidget& panel) {
  const auto* scroll = qobject_cast<const QScrollArea*>(panel.widget());
  return scroll != nullptr ? scroll->widget()->sizeHint().height() : panel.sizeHint().height();
}

}  // namespace

DockSet::DockSet(QMainWindow& window) : window_(window) {
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
  window_.addDockWidget(area, panel);
  panel->setVisible(shown);
}

void DockSet::arrange() {
  for (const Panel& each : panels_) {
    each.dock->setFloating(false);
    window_.removeDockWidget(each.dock);
  }
  QList<QDockWidget*> upright;
  QList<int> widths;
  QList<int> heights;
  for (const Panel& each : panels_) {
    window_.addDockWidget(each.area, each.dock);
    each.dock->setVisible(each.shown);
    const bool at_side = each.area == Qt::LeftDockWidgetArea || each.area == Qt::RightDockWidgetArea;
    if (!at_side || !each.shown) continue;
    upright << each.dock;
    widths << each.dock->minimumSizeHint().width();
    heights << std::max(heightOf(*each.dock), kLeastHeight);
  }
  const auto resize = [&window = window_, upright, widths, heights] {
    window.resizeDocks(upright, heights, Qt::Vertical);
    window.resizeDocks(upright, widths, Qt::Horizontal);
  };
  resize();
  QMetaObject::invokeMethod(&window_, resize, Qt::QueuedConnection);  // again once the window has its final size
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
