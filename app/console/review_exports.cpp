#include "app/console/review_exports.h"

#include <QFileInfo>

#include "core/session/report.h"
#include "widgets/core_text.h"

namespace fyd::console {
namespace {

using widgets::Severity;

Result<void> write(const std::string& path, const std::string& target, session::ExportOptions options,
                   const session::Progress& progress) {
  const auto recording = session::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  if (target.ends_with(".html") || target.ends_with(".pdf")) {
    return session::writeReport(**recording, target, false, progress);
  }
  options.progress = progress;
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
  const QString name = QString::fromStdString(target);
  if (works_.contains(target)) {
    tell_(Severity::information, tr("%1 is being written already.").arg(name));
    return;
  }
  auto* work = works_[target] = new LongWork(bars_, this);
  work->run(tr("Writing %1").arg(QFileInfo(name).fileName()),
            [this, path = path_.toStdString(), target, options](const session::Progress& progress) {
              const auto done = write(path, target, options, progress);
              return [this, done, target] { finish(target, done); };
            });
}

void ReviewExports::finish(const std::string& target, const Result<void>& done) {
  LongWork* work = works_.extract(target).mapped();
  work->deleteLater();  // it is still telling that it has ended
  const QString name = QString::fromStdString(target);
  if (done) {
    tell_(Severity::information, tr("%1 is written.").arg(name));
  } else if (work->cancelled()) {
    tell_(Severity::information, tr("%1 was cancelled; no file is left.").arg(name));
  } else {
    tell_(Severity::warning, widgets::coreText(done.error().message));
  }
}

void ReviewExports::drop() {
  for (auto& [target, work] : works_) work->drop();
}

}  // namespace fyd::console
