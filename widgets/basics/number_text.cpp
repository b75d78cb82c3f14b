#include "widgets/basics/number_text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

const QChar kMinus(0x2212);

/// Of the language that was chosen; thousands are never grouped.
QString withDecimalSign(QString text) { return text.replace(QLatin1Char('.'), QLocale().decimalPoint()); }

}  // namespace

QString numberText(double value, int decimals) {
  if (!std::isfinite(value)) return kNoValue;
  const double step = std::pow(10.0, -decimals);
  if (std::abs(value) < 0.5 * step) value = 0.0;
  QString text = QString::number(value, 'f', decimals);
  if (text.startsWith(QLatin1Char('-'))) text[0] = kMinus;
  return withDecimalSign(text);
}

QString quantityText(double value, int decimals, const QString& unit) {
  const QString text = numberText(value, decimals);
  return text == kNoValue || unit.isEmpty() ? text : text + QLatin1Char(' ') + unit;
}

int decimalsOfUncertainty(double uncertainty) {
  constexpr double kMost = 9.0;
  if (!std::isfinite(uncertainty) || uncertainty <= 0.0) return 0;
  return static_cast<int>(std::clamp(1.0 - std::floor(std::log10(uncertainty)), 0.0, kMost));
}

QString rowText(const QStringList& numbers) {
  const bool comma = QLocale().decimalPoint() == QLatin1String(",");
  return numbers.join(comma ? QStringLiteral("; ") : QStringLiteral(", "));
}

QString ageText(double age_ms) {
  if (!std::isfinite(age_ms)) return kNoValue;
  if (age_ms < 999.5) return tr("%1 ms").arg(std::lround(std::max(0.0, age_ms)));
  if (age_ms < 59950.0) return tr("%1 s").arg(numberText(age_ms / 1000.0, 1));
  return durationText(age_ms / 1000.0);
}

QString durationText(double seconds) {
  if (!std::isfinite(seconds)) return kNoValue;
  const auto whole = static_cast<qint64>(std::floor(std::max(0.0, seconds)));
  if (whole < 60) return tr("%1 s").arg(whole);
  if (whole < 3600) return tr("%1 min %2 s").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
  return tr("%1 h %2 min").arg(whole / 3600).arg(whole / 60 % 60, 2, 10, QLatin1Char('0'));
}

QString plainNumber(double value) {
  // 12 digits hide rounding errors of a value that a slider computed.
  return std::isfinite(value) ? withDecimalSign(QString::number(value, 'g', 12)) : kNoValue;
}

double readNumber(const QString& text) {
  QString plain = text.trimmed();
  plain.replace(kMinus, QLatin1Char('-'));
  plain.replace(QLatin1Char(','), QLatin1Char('.'));
  bool ok = false;
  const double value = QLocale::c().toDouble(plain, &ok);
  return ok ? value : std::numeric_limits<double>::quiet_NaN();
}

double readTime_s(const QString& text) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kParts = 60.0;  // of a minute and of an hour
  const QStringList parts = text.trimmed().split(QLatin1Char(':'));
  if (parts.size() > 3) return kNone;
  double time_s = 0.0;
  for (const QString& part : parts) {
    const bool first = &part == &parts.front();
    const bool last = &part == &parts.back();
    const double value = readNumber(part);
    const bool whole = value == std::floor(value);
    if (!std::isfinite(value) || value < 0.0 || (!first && value >= kParts) || (!last && !whole)) return kNone;
    time_s = time_s * kParts + value;
  }
  return time_s;
}

}  // namespace fyd::widgets
