#include "widgets/parameter_names.h"

#include <QCoreApplication>

namespace fyd::widgets {
namespace {

// Those that may change while the session runs: what the translators are to see.
[[maybe_unused]] constexpr const char* kNames[] = {
    QT_TRANSLATE_NOOP("ParameterNames", "Motion scale"),
    QT_TRANSLATE_NOOP("ParameterNames", "Motion depth scale"),
    QT_TRANSLATE_NOOP("ParameterNames", "Motion speed limit"),
    QT_TRANSLATE_NOOP("ParameterNames", "Hand target"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger mode"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger threshold"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger minimum area"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger minimum contrast"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger centre x"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger centre y"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger scale x"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger scale y"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger rotation"),
    QT_TRANSLATE_NOOP("ParameterNames", "Finger mirror"),
    QT_TRANSLATE_NOOP("ParameterNames", "Indentation mode"),
    QT_TRANSLATE_NOOP("ParameterNames", "Ir offset"),
    QT_TRANSLATE_NOOP("ParameterNames", "Ir noise"),
    QT_TRANSLATE_NOOP("ParameterNames", "Indentation holding"),
    QT_TRANSLATE_NOOP("ParameterNames", "Indentation moving"),
    QT_TRANSLATE_NOOP("ParameterNames", "Indentation sigma limit"),
    QT_TRANSLATE_NOOP("ParameterNames", "Force zero"),
    QT_TRANSLATE_NOOP("ParameterNames", "Stiffness mode"),
    QT_TRANSLATE_NOOP("ParameterNames", "Stiffness minimum indentation"),
    QT_TRANSLATE_NOOP("ParameterNames", "Stiffness minimum force"),
    QT_TRANSLATE_NOOP("ParameterNames", "Stiffness pace"),
    QT_TRANSLATE_NOOP("ParameterNames", "Force noise"),
    QT_TRANSLATE_NOOP("ParameterNames", "Force tare sigma"),
    QT_TRANSLATE_NOOP("ParameterNames", "Stiffness relative sigma limit"),
    QT_TRANSLATE_NOOP("ParameterNames", "Kp"),
    QT_TRANSLATE_NOOP("ParameterNames", "Ki"),
    QT_TRANSLATE_NOOP("ParameterNames", "Kd"),
    QT_TRANSLATE_NOOP("ParameterNames", "Derivative filter"),
    QT_TRANSLATE_NOOP("ParameterNames", "Dead band"),
    QT_TRANSLATE_NOOP("ParameterNames", "Measurement lag"),
    QT_TRANSLATE_NOOP("ParameterNames", "Measurement delay"),
    QT_TRANSLATE_NOOP("ParameterNames", "Noise correlation"),
    QT_TRANSLATE_NOOP("ParameterNames", "Rate limit"),
    QT_TRANSLATE_NOOP("ParameterNames", "Thesis kp"),
    QT_TRANSLATE_NOOP("ParameterNames", "Thesis ki"),
    QT_TRANSLATE_NOOP("ParameterNames", "Thesis kd"),
    QT_TRANSLATE_NOOP("ParameterNames", "Method"),
    QT_TRANSLATE_NOOP("ParameterNames", "Filter"),
    QT_TRANSLATE_NOOP("ParameterNames", "Corner"),
    QT_TRANSLATE_NOOP("ParameterNames", "Frame"),
    QT_TRANSLATE_NOOP("ParameterNames", "Hop"),
    QT_TRANSLATE_NOOP("ParameterNames", "K vib"),
    QT_TRANSLATE_NOOP("ParameterNames", "Dead zone"),
    QT_TRANSLATE_NOOP("ParameterNames", "Maximum"),
    QT_TRANSLATE_NOOP("ParameterNames", "Full scale"),
    QT_TRANSLATE_NOOP("ParameterNames", "Pwm"),
    QT_TRANSLATE_NOOP("ParameterNames", "Input delay"),
    QT_TRANSLATE_NOOP("ParameterNames", "Maximum gap"),
    QT_TRANSLATE_NOOP("ParameterNames", "Crossfade"),
};

}  // namespace

QString parameterName(const QString& english) {
  return QCoreApplication::translate("ParameterNames", english.toUtf8().constData());
}

}  // namespace fyd::widgets
