// Claims a file for this program: two that have it open know of each other, and neither overwrites what the other, or
// an editor, wrote.
#pragma once

#include <QByteArray>
#include <QLockFile>
#include <QString>

namespace fyd::widgets {

class FileClaim {
 public:
  /// Claims the file for this program, unless another one that still runs has it.
  explicit FileClaim(const QString& file_path);

  /// Which program has it instead, in words; empty: none. Looks again, because that one may have ended.
  [[nodiscard]] QString otherProgram();
  /// Why the file must not be written now, in words; empty: it may be. A file that was changed elsewhere is named
  /// once: to ask again is to overwrite it.
  [[nodiscard]] QString whyNot();
  /// The file is now as this program has written it.
  void written();

 private:
  [[nodiscard]] QByteArray content() const;
  void take();

  QString path_;
  QLockFile lock_;
  QByteArray known_;  ///< digest of the file as this program read, wrote or was warned of it; empty: none
};

}  // namespace fyd::widgets
