#include "app/console/operate_page.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

namespace fyd::console {
namespace {

using widgets::kGrid;
using widgets::Quantity;

std::vector<widgets::TuningSection> sections() {
  return {
      {OperatePage::tr("Softness"),
       Quantity::stiffness,
       {{QLatin1String(kHandTarget), OperatePage::tr("By hand")},
        {QStringLiteral("control.kp"), OperatePage::tr("Kp")},
        {QStringLiteral("control.ki"), OperatePage::tr("Ki")},
        {QStringLiteral("control.kd"), OperatePage::tr("Kd")}}},
      {OperatePage::tr("Texture"),
       Quantity::vibration,
       {{QStringLiteral("texture.method"), OperatePage::tr("Method")},
        {QStringLiteral("texture.k_vib"), OperatePage::tr("Gain k_vib")},
        {QStringLiteral("texture.dead_zone_percent"), OperatePage::tr("Dead zone")},
        {QStringLiteral("texture.maximum_percent"), OperatePage::tr("Maximum")}}},
  };
}

/// A column that scrolls when the window is small instead of squeezing what is in it.
QWidget* column(QWidget* parent, const std::vector<QWidget*>& parts, int width) {
  auto* scroll = new QScrollArea(parent);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* body = new QWidget(scroll);
  auto* layout = new QVBoxLayout(body);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  for (QWidget* part : parts) layout->addWidget(part);
  layout->addStretch(1);
  scroll->setWidget(body);
  scroll->setFixedWidth(width);
  return scroll;
}

}  // namespace

OperatePage::OperatePage(widgets::TuningModel& tuning, QWidget* parent)
    : QWidget(parent),
      state_bar_(new widgets::StateBar(this)),
      camera_(new widgets::CameraPanel(this)),
      readiness_(new widgets::ReadinessList(this)),
      curves_(new widgets::CurveView(this)),
      tuning_(new widgets::TuningPanel(tuning, sections(), QLatin1String(kHandTarget), this)) {
  auto* panel = new QFrame(this);
  panel->setProperty("surface", "panel");
  auto* panel_layout = new QVBoxLayout(panel);
  panel_layout->setContentsMargins(0, 0, 0, 0);
  panel_layout->addWidget(curves_);

  auto* below = new QHBoxLayout;
  below->setSpacing(kGrid);
  below->addWidget(column(this, {camera_, readiness_}, 33 * kGrid));
  below->addWidget(panel, 1);
  tuning_->setFixedWidth(33 * kGrid);
  below->addWidget(tuning_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(state_bar_);
  layout->addLayout(below, 1);
}

}  // namespace fyd::console
