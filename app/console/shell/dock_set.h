// The panels of one window: their standard layout, and saving and restoring their layout.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <vector>

namespace fyd::console {

class WindowFollower;

class DockSet {
 public:
  /// How panels at one edge share it.
  enum class Sharing { stacked, tabs };
  /// @param window outlives the set
  explicit DockSet(QMainWindow& window, Sharing sharing = Sharing::stacked);

  /// In the order from top to bottom. @param name in saved layouts: never changed, never translated
  void add(QDockWidget* panel, const QString& name, Qt::DockWidgetArea area, bool shown);
  /// Every panel to its standard place and size.
  void arrange();
  [[nodiscard]] QByteArray save() const { return window_.saveState(kVersion); }
  /// An invalid layout gives the standard one.
  void restore(const QByteArray& layout);

 private:
  struct Panel {
    QDockWidget* dock;
    Qt::DockWidgetArea area;
    bool shown;
  };
  static constexpr int kVersion = 1;  ///< increased when a panel's meaning changes: older layouts are then dropped

  void place(const Panel& panel);
  /// The panels that are seen at the window's sides.
  [[nodiscard]] QList<QDockWidget*> sides() const;

  QMainWindow& window_;
  Sharing sharing_;
  WindowFollower* follower_ = nullptr;  ///< the window's child
  std::vector<Panel> panels_;
};

/// A checkable command that shows and hides a panel, and follows it when it is closed by its cross.
void connectToggle(QAction* command, QDockWidget* panel);

}  // namespace fyd::console
