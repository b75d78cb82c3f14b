#include "app/console/review/review_exports.h"

#include <QFileInfo>

#include "core/export/touch_gesture.h"
#include "core/report/report.h"
#include "core/station/profile/replace_file.h"
#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

using widgets::Severity;

Result<void> write(const ShownRecording& shown, const std::string& target, exports::ExportOptions options,
                   const recording::Progress& progress) {
  const auto recording = shown.open();
  if (!recording) return tl::unexpected(recording.error());
  if (target.ends_with(".html") || target.ends_with(".pdf")) {
    return report::writeReport(**recording, target, false, progress);
  }
  options.progress = progress;
  const auto exported = exports::exportRecording(**recording, target, options);
  return exported ? Result<void>() : tl::unexpected(exported.error());
}

Result<void> writeCard(const ShownRecording& shown, const std::string& target, const exports::Touch& touch,
                       std::size_t number) {
  const auto recording = shown.open();
  if (!recording) return tl::unexpected(recording.error());
  const std::string name = exports::touchName(shown.path.toStdString(), number);
  const auto card = exports::gestureOf(**recording, touch, name, name);
  if (!card) return tl::unexpected(card.error());
  const auto text = sim::formatGesture(*card);
  return text ? station::replaceFile(target, *text) : tl::unexpected(text.error());
}

}  // namespace

std::string ReviewExports::targetFor(const QString& ending, const QString& of) const {
  const QFileInfo file(shown_.path);
  return (file.absolutePath() + QLatin1Char('/') + file.completeBaseName() + of + QLatin1Char('.') + ending)
      .toStdString();
}

void ReviewExports::exportAs(const QString& ending) { exportTo(targetFor(ending), {}); }

void ReviewExports::exportStretch(const QString& ending, double from_s, double to_s) {
  // Names of files have a point in every language.
  const auto text = [](double time_s) { return QString::number(time_s, 'f', 3); };
  exportTo(targetFor(ending, QStringLiteral(" %1-%2 s").arg(text(from_s), text(to_s))),
           {.from_s = from_s, .to_s = to_s});
}

// Reads the data again on its own thread, because the shown time may be hours.
void ReviewExports::exportShown(const ReviewCurves& curves, const QString& target) {
  const widgets::CurveStack& stack = *curves.stack();
  exports::ExportOptions options{.from_s = curves.window().from_s(), .to_s = curves.window().to_s()};
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

void ReviewExports::exportTo(const std::string& target, const exports::ExportOptions& options) {
  if (shown_.isNone()) return;
  run(target, [shown = shown_, target, options](const recording::Progress& progress) {
    return write(shown, target, options, progress);
  });
}

void ReviewExports::exportCard(const exports::Touch& touch, int number) {
  if (shown_.isNone()) return;
  const QFileInfo file(shown_.path);
  const QString base =
      tr("%1 touch %2").arg(file.absolutePath() + QLatin1Char('/') + file.completeBaseName()).arg(number);
  QString target = base + QStringLiteral(".gesture");
  for (int next = 2; QFileInfo::exists(target); ++next) target = base + QStringLiteral(" (%1).gesture").arg(next);
  run(
      target.toStdString(),
      [shown = shown_, target = target.toStdString(), touch, number](const recording::Progress&) {
        return writeCard(shown, target, touch, static_cast<std::size_t>(number));
      },
      tr("The simulated finger plays it: Operate, Finger, Gesture card."));
}

void ReviewExports::run(const std::string& target, Write write, const QString& then) {
  const QString name = QString::fromStdString(target);
  if (works_.contains(target)) {
    tell_(Severity::information, tr("%1 is being written already.").arg(name));
    return;
  }
  auto* work = works_[target] = new LongWork(bars_, this);
  work->run(tr("Writing %1").arg(QFileInfo(name).fileName()),
            [this, target, write = std::move(write), then](const recording::Progress& progress) {
              const auto done = guarded([&] { return write(progress); });
              return [this, done, target, then] { finish(target, done, then); };
            });
}

void ReviewExports::finish(const std::string& target, const Result<void>& done, const QString& then) {
  LongWork* work = works_.extract(target).mapped();
  work->deleteLater();  // it is still emitting the signal that it has ended
  const QString name = QString::fromStdString(target);
  if (done) {
    const QString written = tr("%1 is written.").arg(name);
    tell_(Severity::information, then.isEmpty() ? written : written + QLatin1Char(' ') + then);
    emit this->written(name);
  } else if (work->cancelled()) {
    tell_(Severity::information, tr("%1 was cancelled; no file is left.").arg(name));
  } else {
    tell_(Severity::warning, widgets::coreText(done.error().message));
    emit failed(widgets::coreText(done.error().message));
  }
}

QStringList ReviewExports::underWay() const {
  QStringList out;
  for (const auto& [target, work] : works_) out << QFileInfo(QString::fromStdString(target)).fileName();
  return out;
}

void ReviewExports::drop() {
  for (auto& [target, work] : works_) work->drop();
}

}  // namespace fyd::console
