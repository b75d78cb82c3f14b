#include "app/console/shell/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <clocale>

namespace fyd::console {
namespace {

constexpr Language kLanguages[] = {{"en", "English"}, {"it", "Italiano"}, {"fr", "Français"}};

/// The English text alone is the key, without the class as context: one sentence has one translation, and the core's
/// messages need no class of the window. Where the same English word needs two translations, tr() gets a second
/// argument that distinguishes them.
class ByText : public QTranslator {
 public:
  using QTranslator::QTranslator;
  QString translate(const char* /*context*/, const char* text, const char* which, int count) const override {
    return QTranslator::translate("FYD", text, which, count);
  }
};

QString& current() {
  static QString code = QStringLiteral("en");
  return code;
}

}  // namespace

const QString& spoken() { return current(); }

std::span<const Language> languages() { return kLanguages; }

bool isLanguage(const QString& code) {
  return std::ranges::any_of(kLanguages, [&](const Language& each) { return code == QLatin1String(each.code); });
}

QString chooseLanguage(const QStringList& wanted) {
  for (const QString& each : wanted) {
    if (isLanguage(each)) return each;
  }
  for (const QString& each : QLocale::system().uiLanguages()) {
    QString code = each.section(QLatin1Char('-'), 0, 0);
    if (isLanguage(code)) return code;
  }
  return QStringLiteral("en");
}

void speak(QCoreApplication& application, const QString& code) {
  current() = code;
  for (QTranslator* former : application.findChildren<QTranslator*>(Qt::FindDirectChildrenOnly)) delete former;
  QLocale::setDefault(QLocale(code));
  // Qt also sets the system's locale in the C library; files are written with a decimal point in every language.
  std::setlocale(LC_NUMERIC, "C");
  auto* qt = new QTranslator(&application);
  if (qt->load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(qt);
  }
  auto* own = new ByText(&application);
  if (own->load(QStringLiteral(":/fyd/translations/fyd_%1.qm").arg(code))) QCoreApplication::installTranslator(own);
}

}  // namespace fyd::console
