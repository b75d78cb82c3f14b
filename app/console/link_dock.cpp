#include "app/console/link_dock.h"

#include <QScrollArea>
#include <QVBoxLayout>

#include "widgets/theme.h"

namespace fyd::console {

using pipeline::SafetyState;
using widgets::kGrid;

LinkDock::LinkDock(QWidget* parent)
    : QDockWidget(tr("Link"), parent), panel_(new widgets::LinkPanel), form_(new widgets::RobotForm) {
  setFeatures(QDockWidget::DockWidgetClosable);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setFixedWidth(37 * kGrid);
  auto* body = new QWidget(scroll);
  auto* layout = new QVBoxLayout(body);
  layout->setContentsMargins(0, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(panel_);
  layout->addWidget(form_);
  layout->addStretch(1);
  scroll->setWidget(body);
  setWidget(scroll);
}

void LinkDock::showState(SafetyState state) {
  can_move_ = state == SafetyState::active || state == SafetyState::held;
  refresh();
}

void LinkDock::showSilence(bool silent) {
  silent_ = silent;
  refresh();
}

void LinkDock::restart(bool open) {
  closed_ = !open;
  can_move_ = true;
  refresh();
}

bool LinkDock::mayReconnect() const { return closed_ || (!can_move_ && !silent_); }

}  // namespace fyd::console
