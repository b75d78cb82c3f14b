#include "app/console/review/recording_files.h"

#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QSettings>

#include "core/recording/file/recording_place.h"

namespace fyd::console {
namespace {

const QString kKey = QStringLiteral("review/recent");

/// Empty: not one file of this computer.
QString droppedFile(const QDropEvent& event) {
  const QList<QUrl> urls = event.mimeData()->urls();
  return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

}  // namespace

void askForRecording(QWidget* parent, const QString& title, const QString& folder, TakeFile take) {
  auto* dialog = new QFileDialog(parent, title, folder,
                                 RecentRecordings::tr("Recordings (*.h5 *.h5.partial *.h5.damaged*);;All files (*)"));
  dialog->setObjectName(QStringLiteral("recording_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setModal(false);  // nothing is modal while a device can move
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, std::move(take));
  dialog->show();
}

void RecentRecordings::keepIn(const QString& file) {
  file_ = file;
  const QSettings kept(file_, QSettings::IniFormat);
  paths_ = kept.value(kKey).toStringList().mid(0, kMost);
  paths_.removeAll(QString());
}

void RecentRecordings::add(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  paths_.removeAll(whole);
  paths_.prepend(whole);
  paths_ = paths_.mid(0, kMost);
  if (!file_.isEmpty()) QSettings(file_, QSettings::IniFormat).setValue(kKey, paths_);
}

void RecentRecordings::fill(QMenu& menu, TakeFile take) {
  menu.setToolTipsVisible(true);
  connect(&menu, &QMenu::aboutToShow, this, [this, &menu, take = std::move(take)] {
    menu.clear();
    for (const QString& path : paths_) {
      const QString name = QFileInfo(path).fileName();
      const std::string there = recording::existingName(path.toStdString());  // also one that is still being recorded
      QAction* action = menu.addAction(
          QFileInfo::exists(QString::fromStdString(there)) ? name : tr("%1 (not there any more)").arg(name));
      action->setToolTip(path);
      connect(action, &QAction::triggered, this, [take, path] { take(path); });
    }
    if (paths_.isEmpty()) menu.addAction(tr("No recording was opened yet"))->setEnabled(false);
  });
}

FileDrop::FileDrop(QWidget& window, TakeFile take) : QObject(&window), take_(std::move(take)) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove && event->type() != QEvent::Drop) {
    return QObject::eventFilter(watched, event);
  }
  auto* drop = static_cast<QDropEvent*>(event);
  const QString file = droppedFile(*drop);
  if (file.isEmpty()) return false;
  drop->acceptProposedAction();
  if (event->type() == QEvent::Drop) take_(file);
  return true;
}

}  // namespace fyd::console
