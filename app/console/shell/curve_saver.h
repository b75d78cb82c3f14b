// Saves the shown curves as PNG, SVG or PDF, or as a CSV table. The drawing is made on the window's thread, which takes
// as long as a few redraws, and written on another. No file is overwritten, and errors are shown as a notice.
#pragma once

#include <QObject>

#include "app/console/shell/background.h"
#include "app/console/shell/page.h"
#include "widgets/curves/curve_picture.h"

namespace fyd::console {

class CurveSaver : public QObject {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  CurveSaver(Tell tell, QObject* parent) : QObject(parent), tell_(std::move(tell)) {}

  /// Where files go; the folder is made when it is not there.
  void setFolder(const QString& folder) { folder_ = folder; }
  [[nodiscard]] QString folder() const { return folder_; }
  /// First part of the files' names; date and time follow.
  void setStem(const QString& stem) { stem_ = stem; }

  void savePicture(const widgets::CurveStack& stack, widgets::PictureKind kind);
  void saveTable(widgets::CurveTable table);
  /// `stem date time.ending`, not there yet.
  [[nodiscard]] QString pathFor(const QString& ending) const;

 private:
  void write(const QString& ending, std::function<QByteArray()> bytes);

  Tell tell_;
  QString folder_;
  QString stem_ = QStringLiteral("curves");
  Background work_;
};

}  // namespace fyd::console
