// Numbers and times as an operator reads them. A missing value is "—", never 0.
#pragma once

#include <QString>
#include <QStringList>

namespace fyd::widgets {

inline const QString kNoValue = QStringLiteral("—");

/// Fixed decimals, a true minus sign; "—" for NaN and infinities; no "−0.00".
[[nodiscard]] QString numberText(double value, int decimals);
/// numberText and the unit after a space; the unit is left off with the value.
[[nodiscard]] QString quantityText(double value, int decimals, const QString& unit);
/// Decimals that show two digits of a standard uncertainty, in it and in its value.
[[nodiscard]] int decimalsOfUncertainty(double uncertainty);
/// Numbers in a row: a semicolon between them where a comma is their decimal sign.
[[nodiscard]] QString rowText(const QStringList& numbers);
/// An age: "4 ms", "1.2 s", "3 min"; "—" for NaN.
[[nodiscard]] QString ageText(double age_ms);
/// A duration: "12 s", "3 min 05 s", "1 h 02 min".
[[nodiscard]] QString durationText(double seconds);
/// At most 12 digits, without zeros at the end, in the way an operator writes them: "12", "0.62".
[[nodiscard]] QString plainNumber(double value);
/// Reads what an operator wrote; comma or point, minus or hyphen. @return NaN when it is no number
[[nodiscard]] double readNumber(const QString& text);
/// Reads a time: seconds "83.5", minutes and seconds "1:23.5", with hours "1:02:03.5". @return s; NaN when it is none
[[nodiscard]] double readTime_s(const QString& text);

}  // namespace fyd::widgets
