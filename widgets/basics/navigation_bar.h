// The navigation bar at the window's left edge: icon and name of each page, the present one marked.
#pragma once

#include <QAction>
#include <QFrame>
#include <QToolButton>
#include <QVBoxLayout>

namespace fyd::widgets {

class NavigationBar : public QFrame {
  Q_OBJECT
 public:
  explicit NavigationBar(QWidget* parent = nullptr);
  /// @param place checkable; its icon and text are the button's, its keys stand in the tool tip
  QToolButton* add(QAction* place);

 private:
  QVBoxLayout* layout_ = nullptr;
  int width_ = 0;  ///< px, of every button
};

}  // namespace fyd::widgets
