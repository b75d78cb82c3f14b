#include "app/console/shell/curve_saver.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

using widgets::Severity;

/// @return what went wrong; empty: nothing
QString writeFile(const QString& path, const QByteArray& bytes) {
  const QString folder = QFileInfo(path).absolutePath();
  if (!QDir().mkpath(folder)) return CurveSaver::tr("%1: this folder cannot be made").arg(folder);
  QSaveFile file(path);
  const bool good = file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
  return good ? QString() : CurveSaver::tr("%1 is not written: %2").arg(path, file.errorString());
}

}  // namespace

QString CurveSaver::pathFor(const QString& ending) const {
  const QString base = folder_ + QLatin1Char('/') + stem_ + QLatin1Char(' ') +
                       QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH-mm-ss"));
  QString path = base + QLatin1Char('.') + ending;
  for (int next = 2; QFileInfo::exists(path); ++next) {
    path = base + QStringLiteral(" (%1).").arg(next) + ending;
  }
  return path;
}

void CurveSaver::savePicture(const widgets::CurveStack& stack, widgets::PictureKind kind) {
  const QString title =
      stem_ + QStringLiteral(", ") + QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
  auto picture = widgets::pictureOf(stack, kind, title);
  if (!picture) {
    tell_(Severity::warning, widgets::coreText(picture.error().message));
    return;
  }
  write(widgets::wordOf(kind), [bytes = std::move(*picture)] { return bytes; });
}

void CurveSaver::saveTable(widgets::CurveTable table) {
  if (table.rows.time_s.empty()) {
    tell_(Severity::warning, tr("There are no values to save yet."));
    return;
  }
  write(QStringLiteral("csv"), [table = std::move(table)] { return widgets::csvOf(table); });
}

void CurveSaver::write(const QString& ending, std::function<QByteArray()> bytes) {
  if (work_.running()) {
    tell_(Severity::information, tr("The file before is still being written; try again."));
    return;
  }
  const QString path = pathFor(ending);
  work_.run([this, path, bytes = std::move(bytes)](const std::stop_token&) -> Background::Finish {
    const auto written = guarded([&]() -> Result<QString> { return writeFile(path, bytes()); });
    return [this, path, problem = written ? *written : widgets::coreText(written.error().message)] {
      if (problem.isEmpty()) {
        tell_(Severity::information, tr("%1 is written.").arg(path));
      } else {
        tell_(Severity::warning, problem);
      }
    };
  });
}

}  // namespace fyd::console
