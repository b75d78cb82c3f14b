#include "app/console/window/focus_guard.h"

#include <QApplication>
#include <QDockWidget>
#include <QFocusEvent>
#include <QPointer>
#include <QTimer>

#include "app/console/shell/page.h"
#include "app/console/window/frame.h"

namespace fyd::console {
namespace {

/// The place, the panel, or the part of the frame that a control stands in.
const QWidget* panelOf(const QWidget* control) {
  const QWidget* part = control;
  for (const QWidget* each = control; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    if (qobject_cast<const Page*>(each) != nullptr || qobject_cast<const QDockWidget*>(each) != nullptr) return each;
    if (qobject_cast<const Frame*>(each) != nullptr) return part;
    part = each;
  }
  return part;
}

}  // namespace

FocusGuard::FocusGuard(std::function<QWidget*()> harmless, QObject* parent)
    : QObject(parent), harmless_(std::move(harmless)) {
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, &FocusGuard::moved);
}

bool FocusGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn) {
    as_by_tab_ = static_cast<QFocusEvent*>(event)->reason() == Qt::TabFocusReason;
  }
  return QObject::eventFilter(watched, event);
}

void FocusGuard::moved(QWidget* from, QWidget* to) {
  if (from == nullptr || to == nullptr || !as_by_tab_ || panelOf(from) == panelOf(to)) return;
  // The control becomes hidden or disabled after its focus has gone.
  QTimer::singleShot(0, this, [this, from = QPointer(from), to = QPointer(to)] {
    if (from.isNull() || to.isNull() || QApplication::focusWidget() != to) return;
    if (!from->isEnabled() || !from->isVisible()) harmless_()->setFocus(Qt::OtherFocusReason);
  });
}

}  // namespace fyd::console
