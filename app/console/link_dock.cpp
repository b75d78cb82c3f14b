#include "app/console/link_dock.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/icon.h"
#include "widgets/theme.h"

namespace fyd::console {

using pipeline::SafetyState;
using widgets::kGrid;

LinkDock::LinkDock(QWidget* parent)
    : QDockWidget(tr("Link"), parent), panel_(new widgets::LinkPanel), form_(new widgets::RobotForm) {
  setFeatures(QDockWidget::NoDockWidgetFeatures);
  setTitleBarWidget(titleBar());
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

QWidget* LinkDock::titleBar() {
  auto* bar = new QWidget(this);
  auto* title = new QLabel(windowTitle(), bar);
  title->setFont(widgets::textFont(widgets::TextSize::normal, true));
  auto* close = new QToolButton(bar);
  close->setObjectName(QStringLiteral("link_close"));
  close->setProperty("flat", true);
  close->setIcon(widgets::icon(QStringLiteral("cross")));
  close->setIconSize({2 * kGrid, 2 * kGrid});
  close->setAccessibleName(tr("Close the link's panel"));
  close->setToolTip(close->accessibleName());
  connect(close, &QToolButton::clicked, this, &QDockWidget::hide);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, 0);
  layout->addWidget(title, 1);
  layout->addWidget(close);
  return bar;
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
