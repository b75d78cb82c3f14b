#include "widgets/tuning/tuning_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/vertical_scroll.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::widgets {

TuningPanel::TuningPanel(TuningModel& model, const std::vector<TuningSection>& sections, const QString& target_id,
                         QWidget* parent)
    : QFrame(parent),
      model_(model),
      from_robot_(new QRadioButton(tr("from robot"), this)),
      by_hand_(new QRadioButton(tr("by hand"), this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Tuning"));
  auto* scroll = makeVerticalScroll(this);
  auto* body = new QWidget(scroll);
  auto* rows = new QVBoxLayout(body);
  rows->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  rows->setSpacing(kGrid / 2);
  for (const TuningSection& section : sections) addSection(rows, section, target_id);
  rows->addStretch(1);
  scroll->setWidget(body);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scroll, 1);
  preset_ = new QToolButton(this);
  foot_ = new TuningFoot(model_, TuningFoot::Rows::two, preset_, this);
  layout->addWidget(foot_);
  connect(foot_, &TuningFoot::saveAsked, this, &TuningPanel::saveAsked);
  preset_->setObjectName(QStringLiteral("preset_button"));
  preset_->setIcon(icon(QStringLiteral("preset")));
  preset_->setToolTip(tr("Use a preset's values"));
  preset_->setAccessibleName(preset_->toolTip());
  preset_->setPopupMode(QToolButton::InstantPopup);
  preset_->hide();  // until setPresetMenu gives it a menu
}

QWidget* TuningPanel::buildTargetChoice() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(kGrid + kGrid / 2, 0, 0, 0);
  auto* name = new QLabel(tr("Target"), row);
  layout->addWidget(name);
  layout->addStretch(1);
  layout->addWidget(from_robot_);
  layout->addWidget(by_hand_);
  from_robot_->setObjectName(QStringLiteral("target_from_robot"));
  by_hand_->setObjectName(QStringLiteral("target_by_hand"));
  from_robot_->setAccessibleName(tr("Stiffness target from the robot"));
  by_hand_->setAccessibleName(tr("Stiffness target by hand"));
  from_robot_->setToolTip(tr("Follow the stiffness of what the robot touches."));
  by_hand_->setToolTip(tr("Hold the stiffness set below, whatever the robot touches."));
  from_robot_->setChecked(true);
  connect(from_robot_, &QRadioButton::clicked, this, &TuningPanel::targetFromRobotAsked);
  connect(by_hand_, &QRadioButton::clicked, this, &TuningPanel::targetByHandAsked);
  return row;
}

void TuningPanel::addSection(QVBoxLayout* layout, const TuningSection& section, const QString& target_id) {
  auto* title = new QLabel(section.title, this);
  title->setFont(textFont(TextSize::normal, true));
  title->setContentsMargins(kGrid + kGrid / 2, rows_.empty() ? 0 : kGrid, 0, 0);
  layout->addWidget(title);
  for (const TuningSection::Row& entry : section.rows) {
    const TunedParameter* tuned = model_.find(entry.id.toStdString());
    if (tuned == nullptr) continue;
    if (entry.id == target_id) layout->addWidget(buildTargetChoice());
    const QString label = entry.label.isEmpty() ? tunedName(tuned->info) : entry.label;
    auto* row = new TuningRow(model_, entry.id, label, section.quantity, this);
    connect(row, &TuningRow::refused, this, &TuningPanel::refused);
    connect(row, &TuningRow::entered, this, &TuningPanel::entered);
    layout->addWidget(row);
    rows_.push_back(row);
  }
}

void TuningPanel::setPresetMenu(QMenu* menu) {
  preset_->setMenu(menu);
  preset_->setVisible(menu != nullptr);
}

void TuningPanel::showTargetByHand(bool by_hand) { (by_hand ? by_hand_ : from_robot_)->setChecked(true); }

TuningRow* TuningPanel::row(const QString& id) const {
  for (TuningRow* row : rows_) {
    if (row->id() == id) return row;
  }
  return nullptr;
}

}  // namespace fyd::widgets
