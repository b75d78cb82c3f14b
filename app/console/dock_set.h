// The panels of one window and their standard places: what "Standard layout" returns to, and what is saved of them.
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <vector>

namespace fyd::console {

class DockSet {
 public:
  /// @param window outlives the set
  explicit DockSet(QMainWindow& window);

  /// In the order from top to bottom. @param name in saved layouts: never changed, never translated
  void add(QDockWidget* panel, const QString& name, Qt::DockWidgetArea area, bool shown);
  /// Every panel to its standard place and size.
  void arrange();
  [[nodiscard]] QByteArray save() const { return window_.saveState(kVersion); }
  /// What is no layout of these panels gives the standard one.
  void restore(const QByteArray& layout);

 private:
  struct Panel {
    QDockWidget* dock;
    Qt::DockWidgetArea area;
    bool shown;
  };
  static constexpr int kVersion = 1;  ///< goes up when a panel's meaning changes: older layouts are dropped then

  QMainWindow& window_;
  std::vector<Panel> panels_;
};

/// A checkable command that shows and hides a panel, and follows it when it is closed by its cross.
void connectToggle(QAction* command, QDockWidget* panel);

}  // namespace fyd::console
