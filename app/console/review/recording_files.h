// Recordings by hand: chosen in a dialog that is not modal, dropped onto the window, or of those opened lately.
#pragma once

#include <QObject>
#include <QStringList>
#include <functional>

class QMenu;

namespace fyd::console {

using TakeFile = std::function<void(const QString& path)>;

/// Asks for a recording's file; nothing is called when none is chosen.
void askForRecording(QWidget* parent, const QString& title, const QString& folder, TakeFile take);

/// The recordings opened last, the newest first; remembered in a file.
class RecentRecordings : public QObject {
  Q_OBJECT
 public:
  static constexpr qsizetype kMost = 12;

  using QObject::QObject;
  /// Reads what was remembered there, and remembers there. Without it they are forgotten at the end.
  void keepIn(const QString& file);
  void add(const QString& path);
  [[nodiscard]] const QStringList& paths() const { return paths_; }
  /// Filled each time it opens; a file that is not there any more is shown so, and may be asked for all the same.
  void fill(QMenu& menu, TakeFile take);

 private:
  QString file_;
  QStringList paths_;
};

/// Takes the one file that is dropped anywhere on a window.
class FileDrop : public QObject {
 public:
  FileDrop(QWidget& window, TakeFile take);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  TakeFile take_;
};

}  // namespace fyd::console
