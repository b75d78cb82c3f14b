// Where the visible controls stand, as JSON: for tests and for tools that press them.
#pragma once

#include <QByteArray>

class QWidget;

namespace fyd::console {

/// {"window": {"width", "height"}, "controls": [{"name", "id", "kind", "x", "y", "width", "height"}]}, in logical px from
/// the window's upper left corner. Controls are what is visible and has a name for screen readers; `id` is the one in
/// the program, empty where there is none.
[[nodiscard]] QByteArray dumpGeometry(const QWidget& window);

}  // namespace fyd::console
