// The window's language: which one, and the translations of it. Chosen once, before the window is made.
#pragma once

#include <QString>
#include <span>

class QCoreApplication;

namespace fyd::console {

struct Language {
  const char* code;  ///< "it", of --language
  const char* name;  ///< in the language itself
};

[[nodiscard]] std::span<const Language> languages();
[[nodiscard]] bool isLanguage(const QString& code);

/// @param wanted in the order of preference: of the command line, then of the last time; empty or unknown ones are
/// ignored. @return the first known one, else the system's, else English
[[nodiscard]] QString chooseLanguage(const QStringList& wanted);

/// The code of the language in use; "en" before `speak`.
[[nodiscard]] const QString& spoken();

/// Sets the language of texts, Qt's own included, and the decimal sign of numbers, replacing the former language. Files
/// keep the decimal point.
/// @param code as `chooseLanguage` returns it
void speak(QCoreApplication& application, const QString& code);

}  // namespace fyd::console
