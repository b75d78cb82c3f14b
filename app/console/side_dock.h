// A panel at the window's right edge: a title, a cross that closes it, and a body that scrolls when there is no room.
#pragma once

#include <QDockWidget>
#include <vector>

namespace fyd::console {

class SideDock : public QDockWidget {
  Q_OBJECT
 public:
  /// @param name of the closing button, for tests; @param close_words what it says to screen readers
  SideDock(const QString& title, const QString& name, const QString& close_words, const std::vector<QWidget*>& parts,
           QWidget* parent = nullptr);

 private:
  QWidget* titleBar(const QString& name, const QString& close_words);
};

}  // namespace fyd::console
