#include "widgets/core_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <vector>

namespace fyd::widgets {
namespace {

// A test looks for each of them in the core's sources, so that none outlives its sentence there.
constexpr const char* kSentences[] = {
    // States and their reasons (core/pipeline/safety.cpp).
    QT_TRANSLATE_NOOP("Core", "Disconnected"),
    QT_TRANSLATE_NOOP("Core", "Connected"),
    QT_TRANSLATE_NOOP("Core", "Ready"),
    QT_TRANSLATE_NOOP("Core", "Active"),
    QT_TRANSLATE_NOOP("Core", "Held"),
    QT_TRANSLATE_NOOP("Core", "Stopped"),
    QT_TRANSLATE_NOOP("Core", "nothing missing"),
    QT_TRANSLATE_NOOP("Core", "the haptic loop stood still for more than 20 ms"),
    QT_TRANSLATE_NOOP("Core", "more than 5 % of the haptic cycles of one second were missed"),
    QT_TRANSLATE_NOOP("Core", "the motor board is silent"),
    QT_TRANSLATE_NOOP("Core", "the distance sensors are silent"),
    QT_TRANSLATE_NOOP("Core", "too few distance sensors read within their span"),
    QT_TRANSLATE_NOOP("Core", "the load cell is silent"),
    QT_TRANSLATE_NOOP("Core", "the load cell's value is outside its span"),
    QT_TRANSLATE_NOOP("Core", "the camera sends no pictures"),
    QT_TRANSLATE_NOOP("Core", "the camera sees nothing: picture black, saturated or empty"),
    QT_TRANSLATE_NOOP("Core", "no robot has connected"),
    QT_TRANSLATE_NOOP("Core", "the robot is silent"),
    QT_TRANSLATE_NOOP("Core", "the robot has said goodbye"),
    QT_TRANSLATE_NOOP("Core", "the robot's stiffness is not a number"),
    QT_TRANSLATE_NOOP("Core", "no stiffness target"),
    QT_TRANSLATE_NOOP("Core", "the window did not answer for half a second"),
    QT_TRANSLATE_NOOP("Core", "Close other programs on this machine."),
    QT_TRANSLATE_NOOP("Core", "Check the touchpad's power and its serial cable."),
    QT_TRANSLATE_NOOP("Core", "Check the touchpad's power and cables."),
    QT_TRANSLATE_NOOP("Core", "Look for dirt or an object under the cloth; calibrate."),
    QT_TRANSLATE_NOOP("Core", "Check the load cell's bridge and its cable."),
    QT_TRANSLATE_NOOP("Core", "Take the load off the cover; check the bridge's wiring."),
    QT_TRANSLATE_NOOP("Core", "Check the camera's cable or choose another source."),
    QT_TRANSLATE_NOOP("Core", "Check light and lens cap."),
    QT_TRANSLATE_NOOP("Core", "Start the robot's program, or set the target by hand."),
    QT_TRANSLATE_NOOP("Core", "Check the network and the robot's program."),
    QT_TRANSLATE_NOOP("Core", "Start the robot's program again."),
    QT_TRANSLATE_NOOP("Core", "Check the robot's force sensor and probe again."),
    QT_TRANSLATE_NOOP("Core", "Choose the robot's stiffness or set one by hand."),
    QT_TRANSLATE_NOOP("Core", "Wait until it answers; close other programs on this machine."),
    // Notices (core/station/notice.cpp).
    QT_TRANSLATE_NOOP("Core", "%1: %2. %3 Then re-arm."),
    QT_TRANSLATE_NOOP("Core", "%1 by the operator. Motors are off. Arm to start again."),
    QT_TRANSLATE_NOOP("Core", "%1: rendering."),
    QT_TRANSLATE_NOOP("Core", "%1: everything needed is there. Arm to start."),
    QT_TRANSLATE_NOOP("Core", "%1: sensors are live, motors are off."),
    QT_TRANSLATE_NOOP("Core", "%1: the touchpad does not answer."),
    QT_TRANSLATE_NOOP("Core", "Not armed: %1. %2"),
    QT_TRANSLATE_NOOP("Core", "Tare done; the largest offset moved by %1 mm."),
    QT_TRANSLATE_NOOP("Core", "Tare failed: %1. Keep the cloth untouched and try again."),
    QT_TRANSLATE_NOOP("Core", "%1 is now %2."),
    QT_TRANSLATE_NOOP("Core", "%1 = %2 was refused."),
    QT_TRANSLATE_NOOP("Core", "The robot's operator asks: %1."),
    QT_TRANSLATE_NOOP("Core", "The target is out of reach; rendering the nearest, %1 N/mm."),
    QT_TRANSLATE_NOOP("Core", "The clock went back by %1 s; that step moved nothing."),
    QT_TRANSLATE_NOOP("Core", "vibration down"),
    QT_TRANSLATE_NOOP("Core", "vibration up"),
    QT_TRANSLATE_NOOP("Core", "use DFT321"),
    QT_TRANSLATE_NOOP("Core", "use SoC"),
    QT_TRANSLATE_NOOP("Core", "send info and pause"),
    QT_TRANSLATE_NOOP("Core", "resume"),
    QT_TRANSLATE_NOOP("Core", "images on"),
    QT_TRANSLATE_NOOP("Core", "images off"),
    QT_TRANSLATE_NOOP("Core", "disconnect"),
    QT_TRANSLATE_NOOP("Core", "motor reference on"),
    QT_TRANSLATE_NOOP("Core", "motor reference off"),
    // Readiness (core/station/readiness.cpp).
    QT_TRANSLATE_NOOP("Core", "Motors answer"),
    QT_TRANSLATE_NOOP("Core", "Distance sensors measure"),
    QT_TRANSLATE_NOOP("Core", "Load cell measures"),
    QT_TRANSLATE_NOOP("Core", "Camera sees"),
    QT_TRANSLATE_NOOP("Core", "Robot connected"),
    QT_TRANSLATE_NOOP("Core", "Stiffness target known"),
    QT_TRANSLATE_NOOP("Core", "%1. %2"),
    // What a sensor or an estimate says of itself (core/sensing).
    QT_TRANSLATE_NOOP("Core", "found"),
    QT_TRANSLATE_NOOP("Core", "no finger"),
    QT_TRANSLATE_NOOP("Core", "too small"),
    QT_TRANSLATE_NOOP("Core", "at edge"),
    QT_TRANSLATE_NOOP("Core", "several"),
    QT_TRANSLATE_NOOP("Core", "flat picture"),
    QT_TRANSLATE_NOOP("Core", "black picture"),
    QT_TRANSLATE_NOOP("Core", "saturated"),
    QT_TRANSLATE_NOOP("Core", "blurred"),
    QT_TRANSLATE_NOOP("Core", "no picture"),
    QT_TRANSLATE_NOOP("Core", "measured"),
    QT_TRANSLATE_NOOP("Core", "untouched"),
    QT_TRANSLATE_NOOP("Core", "measured without the invalid sensors"),
    QT_TRANSLATE_NOOP("Core", "sensors contradict each other"),
    QT_TRANSLATE_NOOP("Core", "too uncertain"),
    QT_TRANSLATE_NOOP("Core", "too few valid sensors"),
    QT_TRANSLATE_NOOP("Core", "distance readings missing or too old"),
    QT_TRANSLATE_NOOP("Core", "no recent picture"),
    QT_TRANSLATE_NOOP("Core", "observed"),
    QT_TRANSLATE_NOOP("Core", "indentation unavailable"),
    QT_TRANSLATE_NOOP("Core", "force unavailable"),
    QT_TRANSLATE_NOOP("Core", "indentation too small"),
    QT_TRANSLATE_NOOP("Core", "force too small"),
    QT_TRANSLATE_NOOP("Core", "idle"),
    QT_TRANSLATE_NOOP("Core", "running"),
    QT_TRANSLATE_NOOP("Core", "done"),
    QT_TRANSLATE_NOOP("Core", "the cloth was touched"),
    QT_TRANSLATE_NOOP("Core", "a sensor is outside its span"),
    QT_TRANSLATE_NOOP("Core", "readings too unsteady"),
    QT_TRANSLATE_NOOP("Core", "too few readings in time"),
    QT_TRANSLATE_NOOP("Core", "unknown"),
    // Devices (core/device, core/station, app/console/session.cpp).
    QT_TRANSLATE_NOOP("Core", "Touchpad"),
    QT_TRANSLATE_NOOP("Core", "Camera"),
    QT_TRANSLATE_NOOP("Core", "Robot"),
    QT_TRANSLATE_NOOP("Core", "Motor board"),
    QT_TRANSLATE_NOOP("Core", "Motors"),
    QT_TRANSLATE_NOOP("Core", "simulated"),
    QT_TRANSLATE_NOOP("Core", "recording"),
    QT_TRANSLATE_NOOP("Core", "motors"),
    QT_TRANSLATE_NOOP("Core", "on"),
    QT_TRANSLATE_NOOP("Core", "off"),
    QT_TRANSLATE_NOOP("Core", "switched off"),
    QT_TRANSLATE_NOOP("Core", "IR sensor %1"),
    QT_TRANSLATE_NOOP("Core", "load cell"),
    QT_TRANSLATE_NOOP("Core", "current %1"),
    QT_TRANSLATE_NOOP("Core", "encoder %1"),
    QT_TRANSLATE_NOOP("Core", "position duty %1"),
    QT_TRANSLATE_NOOP("Core", "temperature %1"),
    QT_TRANSLATE_NOOP("Core", "clock"),
    QT_TRANSLATE_NOOP("Core", "width"),
    QT_TRANSLATE_NOOP("Core", "height"),
    QT_TRANSLATE_NOOP("Core", "pictures"),
    QT_TRANSLATE_NOOP("Core", "finger"),
    QT_TRANSLATE_NOOP("Core", "counts"),
    QT_TRANSLATE_NOOP("Core", "brightness"),
    QT_TRANSLATE_NOOP("Core", "contrast"),
    QT_TRANSLATE_NOOP("Core", "exposure"),
    QT_TRANSLATE_NOOP("Core", "motor %1"),
    QT_TRANSLATE_NOOP("Core", "vibration"),
    QT_TRANSLATE_NOOP("Core", "left as it is"),
    QT_TRANSLATE_NOOP("Core", "this camera has none, or refuses the value"),
    QT_TRANSLATE_NOOP("Core", "this source has none"),
    QT_TRANSLATE_NOOP("Core", "set to %1 %"),
    QT_TRANSLATE_NOOP("Core", "asked for %1 %, the camera took %2 %"),
    QT_TRANSLATE_NOOP("Core", "silent"),
    QT_TRANSLATE_NOOP("Core", "has said goodbye"),
    QT_TRANSLATE_NOOP("Core", "nothing received yet"),
    QT_TRANSLATE_NOOP("Core", "silent; is it plugged in and switched on?"),
    QT_TRANSLATE_NOOP("Core", "waiting for a robot on %1"),
    QT_TRANSLATE_NOOP("Core", "finished"),
    QT_TRANSLATE_NOOP("Core", "ended: the button was released"),
    QT_TRANSLATE_NOOP("Core", "ended: the session was stopped or armed"),
    QT_TRANSLATE_NOOP("Core", "ended: the session's state changed"),
    QT_TRANSLATE_NOOP("Core", "the motors do not answer"),
    QT_TRANSLATE_NOOP("Core", "ended: the haptic loop stood still"),
    QT_TRANSLATE_NOOP("Core", "ended: a motor was not where it was sent; check its encoder and that it can turn"),
    QT_TRANSLATE_NOOP("Core", "the motors are not free: stop the session first"),
    QT_TRANSLATE_NOOP("Core", "a motor stands beyond control.motor_limit_deg: check the encoder's zero"),
    QT_TRANSLATE_NOOP("Core", "device test '%1': %2"),
    QT_TRANSLATE_NOOP("Core", "device test: the session is closed"),
    QT_TRANSLATE_NOOP("Core", "the session is closed"),
    QT_TRANSLATE_NOOP("Core", "%1: the session is closed"),
    QT_TRANSLATE_NOOP("Core", "%1 does not answer: %2"),
    QT_TRANSLATE_NOOP("Core", "nothing listens there; is the touchpad on and the port right?"),
    QT_TRANSLATE_NOOP("Core", "the touchpad closed the connection"),
    QT_TRANSLATE_NOOP("Core", "an answer with a wrong checksum; is the speed right and the line terminated?"),
    QT_TRANSLATE_NOOP("Core", "an answer that does not fit the question"),
    QT_TRANSLATE_NOOP("Core", "an answer of another unit"),
    QT_TRANSLATE_NOOP("Core", "%1: the device behind the port is gone; is the cable plugged in?"),
    QT_TRANSLATE_NOOP("Core", "%1: is no serial port"),
    QT_TRANSLATE_NOOP("Core", "%1: not open"),
    QT_TRANSLATE_NOOP("Core", "%1: cannot be opened: %2"),
    QT_TRANSLATE_NOOP("Core", "holds no picture"),
    QT_TRANSLATE_NOOP("Core", "gives no picture any more"),
    QT_TRANSLATE_NOOP("Core", "camera: none given"),
    QT_TRANSLATE_NOOP("Core", "the picture is frozen: the camera sends one and the same"),
    // Refusals on the link (core/protocol).
    QT_TRANSLATE_NOOP("Core", "wrong size"),
    QT_TRANSLATE_NOOP("Core", "wrong start or end mark"),
    QT_TRANSLATE_NOOP("Core", "wrong sign"),
    QT_TRANSLATE_NOOP("Core", "not a digit"),
    QT_TRANSLATE_NOOP("Core", "wrong separator"),
    QT_TRANSLATE_NOOP("Core", "unknown command"),
    QT_TRANSLATE_NOOP("Core", "wrong button"),
    QT_TRANSLATE_NOOP("Core", "number out of range"),
    // Entries and files (core/base, core/station, core/session).
    QT_TRANSLATE_NOOP("Core", "%1 = %2: expected %3"),
    QT_TRANSLATE_NOOP("Core", "%1: expected %2"),
    QT_TRANSLATE_NOOP("Core", "%1: expected true or false"),
    QT_TRANSLATE_NOOP("Core", "unknown parameter '%1'"),
    QT_TRANSLATE_NOOP("Core", "%1 cannot change while the station runs"),
    QT_TRANSLATE_NOOP("Core", "%1: too many changes at once"),
    QT_TRANSLATE_NOOP("Core", "%1: cannot be opened for reading"),
    QT_TRANSLATE_NOOP("Core", "%1: cannot be written: %2"),
    QT_TRANSLATE_NOOP("Core", "%1: writing failed: %2"),
    QT_TRANSLATE_NOOP("Core", "%1: cannot be replaced: %2"),
    QT_TRANSLATE_NOOP("Core", "%1: cannot be read: %2"),
    QT_TRANSLATE_NOOP("Core", "%1: there is no such file"),
    QT_TRANSLATE_NOOP("Core", "%1: exists already"),
    QT_TRANSLATE_NOOP("Core", "%1: the folder cannot be used: %2"),
    QT_TRANSLATE_NOOP("Core", "%1: the disk does not answer; nothing is recorded"),
    QT_TRANSLATE_NOOP("Core", "%1: the disk does not answer; the file is closed when it does"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 is still being recorded; stop it first"),
    QT_TRANSLATE_NOOP("Core", "%1: the recorder is not running"),
    QT_TRANSLATE_NOOP("Core", "nothing is being recorded"),
    QT_TRANSLATE_NOOP("Core", "the recorder is not running"),
    QT_TRANSLATE_NOOP("Core", "the disk has less than %1 MB left: recording stopped"),
    QT_TRANSLATE_NOOP("Core", "%1: the disk has %2 MB left, fewer than the %3 MB a recording leaves free"),
    QT_TRANSLATE_NOOP("Core", "%1; %2 is whole up to here. Make room or choose another disk"),
    QT_TRANSLATE_NOOP("Core", "%1: is being recorded at this moment"),
    QT_TRANSLATE_NOOP("Core", "the recording holds no step"),
    QT_TRANSLATE_NOOP("Core", "the recording holds no picture"),
    QT_TRANSLATE_NOOP("Core", "%1: a report ends in .html or .pdf"),
    QT_TRANSLATE_NOOP("Core", "%1: the recording holds no picture"),
    QT_TRANSLATE_NOOP("Core", "robot '%1': expected simulated, none, link:HOST:PORT or classic:HOST:PORT"),
    QT_TRANSLATE_NOOP("Core", "robot '%1': FYD Link needs a key file"),
    QT_TRANSLATE_NOOP("Core", "robot '%1': takes no key file"),
    QT_TRANSLATE_NOOP("Core", "key file %1: %2"),
    QT_TRANSLATE_NOOP("Core", "no catalogue was chosen"),
    // Calibration (core/calibration).
    QT_TRANSLATE_NOOP("Core", "thesis polynomial, scaled and shifted"),
    QT_TRANSLATE_NOOP("Core", "inverse, a/(v + b) + c"),
    QT_TRANSLATE_NOOP("Core", "polynomial of degree %1"),
    QT_TRANSLATE_NOOP("Core", "take the hand away and start again"),
    QT_TRANSLATE_NOOP("Core", "look at the distance sensors' curves and at the load cell's cable"),
    QT_TRANSLATE_NOOP("Core", "let the motors and the cloth come to rest, and start again"),
    QT_TRANSLATE_NOOP("Core", "check the touchpad's connection"),
    QT_TRANSLATE_NOOP("Core", "the picture has one grey value only: check the camera and the light"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 N of at most %2 N over %3 weights"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 mm of at most %2 mm"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 deg of at most %2 deg"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 N of at most %2 N; stiffness rises from %3 to %4 N/mm"),
    QT_TRANSLATE_NOOP("Core", "%1: held-out error %2 mm of at most %3 mm, falls at every code from %4 to %5"),
    QT_TRANSLATE_NOOP("Core", "distances to the untouched cloth %1 mm, spread %2 mm; force %3 N"),
    QT_TRANSLATE_NOOP("Core", "at rest %1 g, spread %2 g"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 mm; expected at most %2 mm: %3"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 N; expected at most %2 N: %3"),
    QT_TRANSLATE_NOOP("Core", "held-out error %1 deg; expected at most %2: sweep slower, and wait at each angle"),
    QT_TRANSLATE_NOOP("Core", "average more readings at each distance, target square to the sensor"),
    QT_TRANSLATE_NOOP("Core", "measure the outliers again, or leave them out"),
    QT_TRANSLATE_NOOP("Core", "check the weights, and that nothing rubs on the cell"),
    QT_TRANSLATE_NOOP("Core", "the outliers are kept in the fit; measure them again"),
    QT_TRANSLATE_NOOP("Core", "lay the target flat and set the camera square to it"),
    QT_TRANSLATE_NOOP("Core", "press slower, and hold each depth"),
    QT_TRANSLATE_NOOP("Core", "measure the outliers again"),
    QT_TRANSLATE_NOOP("Core",
                      "%1 different distances in %2 points; expected at least %3: add points between %4 and %5 mm (the "
                      "same distance again tells only the noise)"),
    QT_TRANSLATE_NOOP("Core",
                      "the distances span only %1 mm, %2 to %3; expected at least %4: add points between %5 and %6 mm"),
    QT_TRANSLATE_NOOP("Core", "no point between %1 and %2 mm, %3 % of the span: add points between %4 and %5 mm"),
    QT_TRANSLATE_NOOP("Core", "%1 different weights in %2 points; expected at least %3: %4"),
    QT_TRANSLATE_NOOP("Core", "the weights span only %1 N; expected at least %2: %3"),
    QT_TRANSLATE_NOOP("Core", "add weights between %1 and %2 N"),
    QT_TRANSLATE_NOOP("Core",
                      "%1 different points; expected at least %2: add points, best at the corners of the cloth"),
    QT_TRANSLATE_NOOP("Core", "calibrated %1 days ago: repeat it"),
    QT_TRANSLATE_NOOP("Core", "calibrated %1 days ago: repeat it soon"),
    QT_TRANSLATE_NOOP("Core", "calibrated %1 days in the future: the computer's clock was or is wrong"),
    // A part or a file, and what is wrong with it.
    QT_TRANSLATE_NOOP("Core", "%1: %2"),
};

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
    for (const char* each : kSentences) {
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

bool speaksEnglish() {
  const QString probe = QString::fromUtf8(kSentences[0]);
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

/// @param depth how often a value may itself be a sentence with values
QString inWords(const QString& english, int depth) {
  const QString whole = translated(english);
  if (whole != english || depth == 0) return whole;
  for (const Pattern& pattern : patterns()) {
    const QRegularExpressionMatch match = pattern.form.match(english);
    if (!match.hasMatch()) continue;
    return filledIn(translated(pattern.english), [&](int i) { return inWords(match.captured(i), depth - 1); });
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

QStringList coreSentences() {
  QStringList out;
  for (const char* each : kSentences) out << QString::fromUtf8(each);
  return out;
}

}  // namespace fyd::widgets
