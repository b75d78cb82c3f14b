// A panel of the window: a title to drag it by (a double click lets it float), a button that closes it, and a body that
// scrolls when there is not enough space.
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
  /// A body that scrolls by itself.
  SideDock(const QString& title, const QString& name, const QString& close_words, QWidget* body, QWidget* parent);

  static constexpr int kPanelWidth = 240;  ///< px, at least

 private:
  QWidget* titleBar(const QString& name, const QString& close_words);
};

}  // namespace fyd::console
