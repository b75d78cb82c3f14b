#include "app/console/shell/side_dock.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/vertical_scroll.h"

namespace fyd::console {

using widgets::kGrid;

SideDock::SideDock(const QString& title, const QString& name, const QString& close_words, QWidget* body,
                   QWidget* parent)
    : QDockWidget(title, parent) {
  setTitleBarWidget(titleBar(name, close_words));
  if (body->minimumWidth() == 0) body->setMinimumWidth(kPanelWidth);
  setWidget(body);
}

SideDock::SideDock(const QString& title, const QString& name, const QString& close_words,
                   const std::vector<QWidget*>& parts, QWidget* parent)
    : QDockWidget(title, parent) {
  setTitleBarWidget(titleBar(name, close_words));
  auto* scroll = widgets::makeVerticalScroll(this);
  auto* body = new QWidget(scroll);
  auto* layout = new QVBoxLayout(body);
  layout->setContentsMargins(0, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  for (QWidget* part : parts) layout->addWidget(part);
  layout->addStretch(1);
  scroll->setWidget(body);
  // It does not scroll horizontally: its width fits the contents and the scroll bar in every language.
  const int needed = body->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width();
  scroll->setMinimumWidth(std::max(kPanelWidth, needed));
  setWidget(scroll);
}

QWidget* SideDock::titleBar(const QString& name, const QString& close_words) {
  auto* bar = new QWidget(this);
  auto* title = new QLabel(windowTitle(), bar);
  title->setFont(widgets::textFont(widgets::TextSize::normal, true));
  auto* close = new QToolButton(bar);
  close->setObjectName(name);
  close->setProperty("flat", true);
  close->setIcon(widgets::icon(QStringLiteral("cross")));
  close->setIconSize({2 * kGrid, 2 * kGrid});
  close->setAccessibleName(close_words);
  close->setToolTip(close_words);
  connect(close, &QToolButton::clicked, this, &QDockWidget::hide);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, 0);
  layout->addWidget(title, 1);
  layout->addWidget(close);
  return bar;
}

}  // namespace fyd::console
