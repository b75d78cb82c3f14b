#include "widgets/basics/core_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace fyd::widgets {
namespace {

std::string translated(std::string_view english) {
  return QCoreApplication::translate("Core", std::string(english).c_str()).toStdString();
}

std::string inWords(const Message& message);

std::string shownHere(const Value& value, std::string_view spec) {
  if (const auto* message = std::get_if<Message>(&value.is)) return inWords(*message);
  std::string text = shown(value, spec);
  if (!std::holds_alternative<double>(value.is)) return text;
  const std::string point = QString(QLocale().decimalPoint()).toStdString();
  if (const auto at = text.find('.'); at != std::string::npos) text.replace(at, 1, point);
  return text;
}

std::string inWords(const Message& message) {
  if (message.empty()) return {};
  const std::string form = translated(message.format);
  const bool has_words = form != message.format || !message.values.empty();
  return has_words ? filledIn(form, message, shownHere).value_or(message.text()) : message.text();
}

}  // namespace

QString coreText(const Message& message) { return QString::fromStdString(inWords(message)); }

QString coreText(std::string_view phrase) {
  return phrase.empty() ? QString() : QString::fromStdString(translated(phrase));
}

}  // namespace fyd::widgets
