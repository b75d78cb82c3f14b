#include "widgets/tuning/tuning_text.h"

#include <QStringList>
#include <cmath>

#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

struct Room {
  const char* id;
  const char* title;
};
constexpr std::array kRooms = {
    Room{"pipeline", QT_TRANSLATE_NOOP("Tuning", "Target and robot motion")},
    Room{"sensing", QT_TRANSLATE_NOOP("Tuning", "Finger, indentation and force")},
    Room{"control", QT_TRANSLATE_NOOP("Tuning", "Stiffness control")},
    Room{"texture", QT_TRANSLATE_NOOP("Tuning", "Texture and vibration")},
};

}  // namespace

QString tunedName(const Parameter& parameter) { return coreText(parameter.info.name); }

QString moduleTitle(std::string_view id) {
  const std::string_view room = id.substr(0, id.find('.'));
  for (const Room& each : kRooms) {
    if (room == each.id) return tr(each.title);
  }
  return textOf(room);
}

QString unitText(const Parameter& parameter) {
  return parameter.info.unit == "1" ? QString() : textOf(parameter.info.unit);
}

QString valueText(const Parameter& parameter, double value) {
  if (parameter.kind == ParameterKind::boolean) return value != 0.0 ? tr("on") : tr("off");
  if (parameter.kind != ParameterKind::choice) return plainNumber(value);
  // Its words are names: the same in the profile, on the command line, in a recording and in every language.
  const auto index = static_cast<std::size_t>(value);
  return index < parameter.choices.size() ? textOf(parameter.choices[index]) : kNoValue;
}

QString tunedFacts(const TuningModel& model, const TunedParameter& p) {
  const auto text = [&](double value) { return valueText(p.info, value); };
  QStringList facts = {tr("was %1").arg(text(p.was)), tr("is %1").arg(text(model.felt(p))),
                       tr("saved %1").arg(text(p.saved)), tr("default %1").arg(text(p.standard))};
  const bool number = p.info.kind == ParameterKind::real || p.info.kind == ParameterKind::integer;
  if (number) facts << tr("%1 to %2").arg(plainNumber(p.info.info.minimum), plainNumber(p.info.info.maximum));
  return facts.join(QStringLiteral(" · "));
}

QString deliveryWords(const TunedParameter& p) {
  switch (p.delivery) {
    case Delivery::confirmed: return {};
    case Delivery::pending: return tr("sent, not yet confirmed");
    case Delivery::silent:
      return tr("not confirmed: the station did not answer. It last used %1.").arg(valueText(p.info, p.held));
    case Delivery::refused: return tr("refused: %1").arg(p.reason);
    case Delivery::other: return tr("the station uses %1 of its own accord").arg(valueText(p.info, p.held));
  }
  return {};
}

bool tunedMatches(const Parameter& parameter, const QString& text) {
  const QString help = coreText(parameter.info.help);
  const QString where = textOf(parameter.id) + QLatin1Char(' ') + tunedName(parameter) + QLatin1Char(' ') +
                        moduleTitle(parameter.id) + QLatin1Char(' ') + help;
  const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::ranges::all_of(words, [&](const QString& word) { return where.contains(word, Qt::CaseInsensitive); });
}

}  // namespace fyd::widgets
