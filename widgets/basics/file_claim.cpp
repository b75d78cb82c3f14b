#include "widgets/basics/file_claim.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

/// Hidden, in the file's folder: all who open the file find it, on whichever computer.
QString lockFileOf(const QString& file_path) {
  const QFileInfo file(file_path);
  return file.absoluteDir().filePath(QStringLiteral(".%1.lock").arg(file.fileName()));
}

}  // namespace

FileClaim::FileClaim(const QString& file_path) : path_(file_path), lock_(lockFileOf(file_path)), known_(content()) {
  lock_.setStaleLockTime(0);  // a program may run for days; one that has died is recognised by its number
  take();
}

void FileClaim::take() {
  // Where no lock can be made, as in a folder that is not there yet or that is read-only, nobody is kept out.
  if (!lock_.isLocked()) (void)lock_.tryLock(0);
}

QString FileClaim::otherProgram() {
  take();
  if (lock_.isLocked() || lock_.error() != QLockFile::LockFailedError) return {};
  qint64 process = 0;
  QString host, program;
  if (!lock_.getLockInfo(&process, &host, &program)) return tr("another console");
  return tr("another console, process %1 on %2").arg(process).arg(host);
}

QString FileClaim::whyNot() {
  const QString file = QDir::toNativeSeparators(path_);
  if (const QString other = otherProgram(); !other.isEmpty()) {
    return tr("%1 is in use by %2: close that one first").arg(file, other);
  }
  if (const QByteArray now = content(); now != known_) {
    known_ = now;
    return tr("%1 was changed by something else since this console read it. Do it again to overwrite that").arg(file);
  }
  return {};
}

void FileClaim::written() { known_ = content(); }

QByteArray FileClaim::content() const {
  QFile file(path_);
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256);
}

}  // namespace fyd::widgets
