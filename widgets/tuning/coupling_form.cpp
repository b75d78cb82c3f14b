#include "widgets/tuning/coupling_form.h"

#include <QVBoxLayout>
#include <cmath>

#include "core/teleop/coupling/touchpad_coupling.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::widgets {
namespace {

using teleop::TouchpadCouplingChoice;

constexpr std::string_view kCoupling = "pipeline.coupling";

QString meaning(TouchpadCouplingChoice choice) {
  switch (choice) {
    case TouchpadCouplingChoice::direct:
      return CouplingForm::tr("The cloth follows the robot's stiffness as it comes.");
    case TouchpadCouplingChoice::spring:
      return CouplingForm::tr("The cloth is as stiff as the robot's force over your indentation. A late force shakes.");
    case TouchpadCouplingChoice::tdpa:
      return CouplingForm::tr("As spring, but softer where the cloth would give back more than the finger put in.");
    case TouchpadCouplingChoice::model:
      return CouplingForm::tr(
          "The robot's stiffness is kept here. Under a finger that rests, the cloth only softens; it "
          "stiffens when you lift or move on.");
  }
  return {};
}

}  // namespace

CouplingForm::CouplingForm(TuningModel& model, QWidget* parent)
    : QFrame(parent), model_(model), hint_(new QLabel(this)), energy_(new QLabel(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Coupling"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid / 2, kGrid);  // the row reserves space for its mark in front
  layout->setSpacing(kGrid / 2);
  if (const TunedParameter* coupling = model_.find(kCoupling)) {
    row_ = new TuningRow(model_, QString::fromLatin1(kCoupling.data(), static_cast<int>(kCoupling.size())),
                         tunedName(coupling->info), Quantity::stiffness, this);
    layout->addWidget(row_);
  }
  for (QLabel* label : {hint_, energy_}) {
    label->setFont(textFont(TextSize::small));
    label->setProperty("role", "muted");
    label->setWordWrap(true);
    label->setContentsMargins(kGrid, 0, kGrid / 2, 0);
    layout->addWidget(label);
  }
  connect(&model_, &TuningModel::changed, this, &CouplingForm::refresh);
  connect(&model_, &TuningModel::feelingSavedChanged, this, &CouplingForm::refresh);
  setEnergy(std::nan(""), std::nan(""));
  refresh();
}

void CouplingForm::setForce(Force force) {
  if (force == force_) return;
  force_ = force;
  refresh();
}

void CouplingForm::setEnergy(double put_in_mJ, double withheld_mJ) {
  const double beyond_mJ = put_in_mJ > 0.0 ? 0.0 : -put_in_mJ;  // NaN stays
  energy_->setText(tr("Last touch: %1 given back beyond what was put in, %2 withheld")
                       .arg(quantityText(beyond_mJ, 1, tr("mJ")), quantityText(withheld_mJ, 1, tr("mJ"))));
}

void CouplingForm::refresh() {
  const TunedParameter* coupling = model_.find(kCoupling);
  if (coupling == nullptr) return;
  const auto choice = static_cast<TouchpadCouplingChoice>(static_cast<int>(model_.felt(*coupling)));
  QString words = meaning(choice);
  const bool by_force = choice == TouchpadCouplingChoice::spring || choice == TouchpadCouplingChoice::tdpa;
  if (by_force && force_ == Force::not_told) {
    words += QLatin1Char(' ') + tr("This robot tells no force: its stiffness is taken instead.");
  }
  if (hint_->text() != words) hint_->setText(words);
}

}  // namespace fyd::widgets
