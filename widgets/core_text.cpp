#include "widgets/core_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <vector>

#include "widgets/core_sentences.h"

namespace fyd::widgets {
namespace {

QString translated(const QString& english) { return QCoreApplication::translate("Core", english.toUtf8().constData()); }

/// A sentence with values, as what to look for.
struct Pattern {
  QString english;
  QRegularExpression form;
  qsizetype fixed = 0;  ///< characters that are no value
};

/// Those with the most fixed text first: "%1. %2" fits many sentences, and should be the last to be tried.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> kPatterns = [] {
    std::vector<Pattern> out;
    static const QRegularExpression kValue(QStringLiteral("%[1-9]"));
    for (const char* each : coreSentenceTable()) {
      const QString english = QString::fromUtf8(each);
      if (!english.contains(kValue)) continue;
      QString form = QRegularExpression::escape(english);
      const qsizetype values = english.count(kValue);
      form.replace(QRegularExpression(QStringLiteral("\\\\%\\\\?[1-9]|%[1-9]")), QStringLiteral("(.+?)"));
      out.push_back({english,
                     QRegularExpression(QRegularExpression::anchoredPattern(form),
                                        QRegularExpression::DotMatchesEverythingOption),
                     english.size() - 2 * values});
    }
    std::ranges::stable_sort(out, std::ranges::greater{}, &Pattern::fixed);
    return out;
  }();
  return kPatterns;
}

constexpr qsizetype kWordy = 6;  // characters: less is punctuation, and translates nothing by itself

bool speaksEnglish() {
  const QString probe = QString::fromUtf8(coreSentenceTable()[0]);
  return translated(probe) == probe;
}

/// In one pass: a value may hold a %1 of its own.
template <class Value>
QString filledIn(const QString& form, const Value& value) {
  QString out;
  for (qsizetype i = 0; i < form.size(); ++i) {
    const int number = form[i] == QLatin1Char('%') && i + 1 < form.size() ? form[i + 1].digitValue() : -1;
    if (number >= 1) {
      out += value(number);
      ++i;
    } else {
      out += form[i];
    }
  }
  return out;
}

/// With the decimal sign of the language.
QString numberInWords(const QString& value) {
  static const QRegularExpression kNumber(QStringLiteral("[-+]?\\d+\\.\\d+"));
  return kNumber.match(value).hasMatch() && kNumber.match(value).capturedLength() == value.size()
             ? QString(value).replace(QLatin1Char('.'), QLocale().decimalPoint())
             : value;
}

/// @param depth how often a value may itself be a sentence with values
QString inWords(const QString& english, int depth) {
  const QString whole = numberInWords(translated(english));
  if (whole != english || depth == 0) return whole;
  for (const Pattern& pattern : patterns()) {
    const QRegularExpressionMatch match = pattern.form.match(english);
    if (!match.hasMatch()) continue;
    bool any = pattern.fixed >= kWordy;
    const QString out = filledIn(translated(pattern.english), [&](int i) {
      const QString value = inWords(match.captured(i), depth - 1);
      any = any || value != match.captured(i);
      return value;
    });
    if (any) return out;
  }
  return english;
}

}  // namespace

QString coreText(const QString& english) {
  constexpr int kDepth = 3;
  return english.isEmpty() || speaksEnglish() ? english : inWords(english, kDepth);
}

QString coreText(std::string_view english) {
  return coreText(QString::fromUtf8(english.data(), static_cast<qsizetype>(english.size())));
}

}  // namespace fyd::widgets
