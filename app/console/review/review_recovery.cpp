#include "app/console/review/review_recovery.h"

#include <QFileInfo>

#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_delivery.h"
#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

using widgets::Severity;

QString nameOf(const std::string& path) { return QFileInfo(QString::fromStdString(path)).fileName(); }

/// Names as in the manual's page on the recording's file, each once.
QString tablesOf(const std::vector<recording::MissingRows>& missing) {
  QStringList names;
  for (const recording::MissingRows& rows : missing) names << QString::fromStdString(rows.table);
  names.removeDuplicates();
  return names.join(QStringLiteral(", "));
}

}  // namespace

ReviewRecovery::ReviewRecovery(widgets::ProgressBars* bars, QString catalogue, Tell tell, QObject* parent)
    : QObject(parent), catalogue_(std::move(catalogue)), tell_(std::move(tell)), work_(bars) {}

void ReviewRecovery::recover(const QString& path) {
  if (work_.running()) {
    tell_(Severity::information, tr("A recording is being recovered already; wait, or cancel it."));
    return;
  }
  work_.run(tr("Recovering %1").arg(QFileInfo(path).fileName()),
            [this, path, catalogue = catalogue_.toStdString()](const recording::Progress& progress) {
              const auto outcome = guarded([&] { return recording::recover(path.toStdString(), progress); });
              Result<void> entered;
              // A catalogue's server may answer slowly, so it is not asked while the window closes.
              if (outcome && !outcome->file.empty() && progress(1.0))
                entered = guarded([&] { return catalogue::catalogueRecording(catalogue, outcome->file); });
              return [this, path, outcome, entered] {
                finish(path, outcome);
                if (!entered) tell_(Severity::warning, widgets::coreText(entered.error().message));
              };
            });
}

void ReviewRecovery::finish(const QString& asked, const Result<recording::RecoverOutcome>& outcome) {
  if (!outcome) {
    const QString name = QFileInfo(asked).fileName();
    if (work_.cancelled()) {
      tell_(Severity::information, tr("The recovery was cancelled; %1 is as it was.").arg(name));
    } else {
      tell_(Severity::warning, widgets::coreText(outcome.error().message));
    }
    return;
  }
  switch (outcome->result) {
    case recording::RecoverResult::nothing:
      tell_(Severity::warning, tr("Nothing of %1 can be read; it is left as it is: %2")
                                   .arg(QFileInfo(asked).fileName(), widgets::coreText(outcome->first_damage)));
      return;
    case recording::RecoverResult::whole:
      tell_(Severity::information,
            outcome->kept.empty() ? tr("%1 is whole: %2 samples.").arg(nameOf(outcome->file)).arg(outcome->steps)
                                  : tr("%1 is whole: %2 samples. Nothing was lost; the damaged original is kept as %3.")
                                        .arg(nameOf(outcome->file))
                                        .arg(outcome->steps)
                                        .arg(nameOf(outcome->kept)));
      break;
    case recording::RecoverResult::part_lost:
      tell_(Severity::warning,
            (outcome->lost_steps > 0 ? tr("%1: %2 samples are saved, %3 could not be read. The damaged original is "
                                          "kept as %4.")
                                           .arg(nameOf(outcome->file))
                                           .arg(outcome->steps)
                                           .arg(outcome->lost_steps)
                                     : tr("%1: all %2 samples are saved, but not all that belongs to them: %3 could "
                                          "not be read. The damaged original is kept as %4.")
                                           .arg(nameOf(outcome->file))
                                           .arg(outcome->steps)
                                           .arg(tablesOf(outcome->missing)))
                .arg(nameOf(outcome->kept)));
      break;
  }
  emit recovered(asked, QString::fromStdString(outcome->file));
}

}  // namespace fyd::console
