#include "widgets/devices/device_text.h"

#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::widgets {
namespace {

constexpr QChar kBreak(u'\u200b');  // a line may break there; invisible

QString unitText(const std::string& unit) {
  if (unit == "degC") return QStringLiteral("°C");
  if (unit == "deg") return QStringLiteral("°");
  return coreText(unit);
}

int decimalsOf(const std::string& unit) {
  if (unit == "counts" || unit == "px" || unit.empty()) return 0;
  if (unit == "mV/V") return 4;
  return 1;
}

}  // namespace

QString deviceWord(const Message& words) {
  QString text = coreText(words);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString deviceValue(double number, const std::string& unit) {
  return quantityText(number, decimalsOf(unit), unitText(unit));
}

QString breakable(QString path) {
  for (const QChar after : {QLatin1Char('/'), QLatin1Char('-')}) path.replace(after, QString(after) + kBreak);
  return path;
}

QString asEntered(QString text) { return text.remove(kBreak).trimmed(); }

}  // namespace fyd::widgets
