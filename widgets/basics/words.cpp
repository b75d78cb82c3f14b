#include "widgets/basics/words.h"

#include <QCoreApplication>

namespace fyd::widgets {

QString tr(const char* text) { return QCoreApplication::translate("FYD", text); }

}  // namespace fyd::widgets
