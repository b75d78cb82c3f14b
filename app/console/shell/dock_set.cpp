#include "app/console/shell/dock_set.h"

#include <QAction>
#include <QChildEvent>
#include <QHash>
#include <QResizeEvent>
#include <QScrollArea>
#include <QSet>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>
#include <functional>

#include "app/console/shell/side_dock.h"
#include "widgets/basics/theme.h"

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

}  // namespace

/// Names the tab bars that the window makes for panels at one place, and gives the panels at its sides their share of a
/// window that gets another width. A width that was drawn by hand, at the edge between panels, is left alone.
class WindowFollower : public QObject {
 public:
  using Panels = std::function<QList<QDockWidget*>()>;
  /// @param sides the panels that are seen at the window's sides
  WindowFollower(QMainWindow* window, Panels sides) : QObject(window), window_(*window), sides_(std::move(sides)) {
    settled_.setSingleShot(true);
    settled_.setInterval(kSettled_ms);
    connect(&settled_, &QTimer::timeout, this, &WindowFollower::share);
  }

  /// The panels were put to their standard widths.
  void forget() {
    drawn_.clear();
    restored_ = false;
  }
  /// The panels were put to widths of an earlier time: which of them were drawn by hand is seen from them.
  void lookAgain() {
    forget();
    restored_ = true;
  }

  bool eventFilter(QObject* window, QEvent* event) override {
    switch (event->type()) {
      case QEvent::Resize: follow(static_cast<QResizeEvent*>(event)->oldSize().width()); break;
      case QEvent::MouseButtonPress: pressed_ = widths(); break;
      case QEvent::MouseButtonRelease: QTimer::singleShot(kSettled_ms, this, &WindowFollower::noteDrawn); break;
      case QEvent::ChildPolished: {
        auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child());
        if (tabs != nullptr && tabs->accessibleName().isEmpty()) tabs->setAccessibleName(SideDock::tr("Panels"));
        break;
      }
      default: break;
    }
    return QObject::eventFilter(window, event);
  }

 private:
  static constexpr int kSettled_ms = 50;
  static constexpr int kByHand_px = 2 * widgets::kGrid;  ///< less is rounding, and no intention

  [[nodiscard]] QHash<QDockWidget*, int> widths() const {
    QHash<QDockWidget*, int> out;
    for (QDockWidget* panel : sides_()) out[panel] = panel->width();
    return out;
  }
  [[nodiscard]] bool hasShareOf(const QDockWidget* panel, int window_width) const {
    return std::abs(panel->width() - standardWidth(*panel, window_width)) <= kByHand_px;
  }
  void noteDrawn() {
    for (const auto& [panel, width] : pressed_.asKeyValueRange()) {
      if (panel->width() == width) continue;
      if (hasShareOf(panel, window_.width())) {
        drawn_.remove(panel);
      } else {
        drawn_.insert(panel);
      }
    }
    pressed_.clear();
  }
  void follow(int former_width) {
    if (former_width <= 0 || !window_.isVisible()) return;
    if (std::exchange(restored_, false)) {
      for (QDockWidget* panel : sides_()) {
        if (!hasShareOf(panel, former_width)) drawn_.insert(panel);
      }
    }
    settled_.start();  // a window comes to its size by steps, and its own layout follows the last of them
  }
  void share() {
    QList<QDockWidget*> panels;
    QList<int> shares;
    for (QDockWidget* panel : sides_()) {
      if (drawn_.contains(panel)) continue;
      panels << panel;
      shares << standardWidth(*panel, window_.width());
    }
    window_.resizeDocks(panels, shares, Qt::Horizontal);
  }

  QMainWindow& window_;
  Panels sides_;
  QTimer settled_;
  QSet<QDockWidget*> drawn_;          ///< by hand
  QHash<QDockWidget*, int> pressed_;  ///< widths when the mouse was pressed at an edge
  bool restored_ = false;
};

DockSet::DockSet(QMainWindow& window, Sharing sharing)
    : window_(window), sharing_(sharing), follower_(new WindowFollower(&window_, [this] { return sides(); })) {
  window_.installEventFilter(follower_);
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
  follower_->forget();
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

QList<QDockWidget*> DockSet::sides() const {
  QList<QDockWidget*> out;
  for (const Panel& each : panels_) {
    const bool at_side = each.area == Qt::LeftDockWidgetArea || each.area == Qt::RightDockWidgetArea;
    if (at_side && each.shown && !each.dock->isFloating() && each.dock->isVisible()) out << each.dock;
  }
  return out;
}

void DockSet::restore(const QByteArray& layout) {
  if (layout.isEmpty() || !window_.restoreState(layout, kVersion)) return arrange();
  follower_->lookAgain();
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
