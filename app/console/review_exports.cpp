#include "app/console/review_exports.h"

#include <QFileInfo>

#include "core/session/report.h"
#include "widgets/core_text.h"

namespace fyd::console {
namespace {

using widgets::Severity;

Result<void> write(const std::string& path, const std::string& target, const session::ExportOptions& options) {
  const auto recording = session::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  if (target.ends_with(".html") || target.ends_with(".pdf")) return session::writeReport(**recording, target, false);
  const auto exported = session::exportRecording(**recording, target, options);
  return exported ? Result<void>() : tl::unexpected(exported.error());
}

}  // namespace

void ReviewExports::exportAs(const QString& ending) {
  const QFileInfo file(path_);
  exportTo((file.absolutePath() + QLatin1Char('/') + file.completeBaseName() + QLatin1Char('.') + ending).toStdString(),
           {});
}

// Read again on a thread of its own: what is shown may be hours.
void ReviewExports::exportShown(const ReviewCurves& curves, const QString& target) {
  const widgets::CurveStack& stack = *curves.stack();
  session::ExportOptions options{.from_s = curves.window().from_s(), .to_s = curves.window().to_s()};
  options.fields.emplace_back("t_s");
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (!stack.shown(i)) continue;
    for (const widgets::Trace& trace : stack.setup(i).traces) {
      if (trace.channel < widgets::kCurveChannels)
        options.fields.emplace_back(widgets::curveQuantities()[trace.channel].field);
    }
  }
  exportTo(target.toStdString(), options);
}

void ReviewExports::exportTo(const std::string& target, const session::ExportOptions& options) {
  if (path_.isEmpty()) return;
  tell_(Severity::information, tr("Writing %1 …").arg(QString::fromStdString(target)));
  work_.run([this, path = path_.toStdString(), target, options](const std::stop_token&) -> Background::Finish {
    const auto done = write(path, target, options);
    return [this, done, target] {
      tell_(done ? Severity::information : Severity::warning,
            done ? tr("%1 is written.").arg(QString::fromStdString(target)) : widgets::coreText(done.error().message));
    };
  });
}

}  // namespace fyd::console
