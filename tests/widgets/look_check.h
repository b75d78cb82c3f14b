// What a person would see as wrong in a picture of the window: text cut off, text over text, a control outside its
// panel. Found from the widgets' own sizes, so that no stored picture has to be compared.
#pragma once

#include <QStringList>
#include <QWidget>

namespace fyd::tests {

/// @return one sentence for each fault: class, name, text, sizes
[[nodiscard]] QStringList lookFaults(const QWidget& window);

/// Every text that is painted in `widget` and what it holds, also numbers of axes. Plots paint theirs anew from now on.
[[nodiscard]] QStringList paintedTexts(QWidget& widget);
/// Painted texts that lie on each other. @return one sentence for each pair
[[nodiscard]] QStringList textsOverEachOther(QWidget& widget);

/// Controls that a person works with: shown, enabled, no parts of another control.
[[nodiscard]] QList<QWidget*> controlsOf(const QWidget& window);

}  // namespace fyd::tests
