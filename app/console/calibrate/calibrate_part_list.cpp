#include "app/console/calibrate/calibrate_part_list.h"

#include "app/console/calibrate/calibrate_records.h"
#include "app/console/shell/calibration_ages.h"
#include "core/station/profile/calibration_file.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

QString signOf(PartState::Kind kind) {
  switch (kind) {
    case PartState::Kind::fine: return QStringLiteral("●");
    case PartState::Kind::ageing: return QStringLiteral("◐");
    case PartState::Kind::old: return QStringLiteral("!");
    case PartState::Kind::outdated: return QStringLiteral("↻");
    case PartState::Kind::changed: return QStringLiteral("≠");
    case PartState::Kind::never: break;
  }
  return QStringLiteral("○");
}

}  // namespace

CalibrationPartList::CalibrationPartList(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("calibration_parts"));
  setAccessibleName(tr("Parts and the age of their calibration"));
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void CalibrationPartList::setSteps(const std::vector<std::unique_ptr<CalibrationStep>>& steps) {
  clear();
  for (std::size_t i = 0; i < steps.size(); ++i) addItem(new QListWidgetItem);
}

void CalibrationPartList::refresh(const std::vector<std::unique_ptr<CalibrationStep>>& steps,
                                  const QString& profile_path, const station::Profile& profile) {
  auto records = station::loadCalibrationRecords(profile_path.toStdString());
  if (records) records = station::recordsFor(std::move(*records), profile.calibrated_on);
  const std::string today = nowUtc();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    PartState state{PartState::Kind::old, {}};
    if (records) {
      state = partStateOf(*records, steps[i]->procedure(), steps[i]->sensor(), profile, today);
    } else {
      state.words = widgets::coreText(records.error().message);
    }
    QListWidgetItem* shown = item(static_cast<int>(i));
    shown->setText(signOf(state.kind) + QLatin1Char(' ') + steps[i]->name() + QLatin1Char('\n') + state.words);
    shown->setToolTip(state.words);
    shown->setForeground(isDoubtful(state.kind) ? widgets::theme().warning : widgets::theme().text);
  }
}

}  // namespace fyd::console
