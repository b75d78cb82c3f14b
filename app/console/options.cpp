#include "app/console/options.h"

#include <QCommandLineParser>
#include <QFileInfo>

#include "widgets/number_text.h"

namespace fyd::console {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Options", text); }

Result<widgets::ThemeChoice> readTheme(const QString& name) {
  if (name == QLatin1String("dark")) return widgets::ThemeChoice::dark;
  if (name == QLatin1String("light")) return widgets::ThemeChoice::light;
  if (name == QLatin1String("system")) return widgets::ThemeChoice::system;
  return fail("--theme {}: expected dark, light or system", name.toStdString());
}

Result<void> checkReadable(const char* option, const QString& path) {
  const QFileInfo file(path);
  if (path.isEmpty() || (file.isFile() && file.isReadable())) return {};
  return fail("{} {}: no such file, or it may not be read", option, path.toStdString());
}

}  // namespace

Result<Options> readOptions(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(tr("FYD Console: the operator's window of the FYD Touchpad."));
  const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")}, tr("Show this help."));
  const QCommandLineOption version(QStringLiteral("version"), tr("Show the version."));
  const QCommandLineOption simulate(
      QStringLiteral("simulate"),
      tr("Simulate the touchpad: always so in the window; a real one is driven by fyd station."));
  const QCommandLineOption finger(QStringLiteral("finger"),
                                  tr("Let the simulated finger follow a recording (t_s,x_mm,y_mm,z_mm)."),
                                  QStringLiteral("CSV"));
  const QCommandLineOption camera(QStringLiteral("camera"),
                                  tr("Device index, video file, image folder or stream URL; "
                                     "default: simulated."),
                                  QStringLiteral("SOURCE"));
  const QCommandLineOption robot(
      QStringLiteral("robot"),
      tr("simulated, none, or link:HOST:PORT or classic:HOST:PORT to listen there; classic is not secured."),
      QStringLiteral("ROBOT"), QStringLiteral("simulated"));
  const QCommandLineOption key(QStringLiteral("key"), tr("Key file of a link: robot."), QStringLiteral("FILE"));
  const QCommandLineOption profile(QStringLiteral("profile"), tr("Profile to load and to save to."),
                                   QStringLiteral("FILE"));
  const QCommandLineOption theme_name(QStringLiteral("theme"), tr("dark, light or system."), QStringLiteral("NAME"),
                                      QStringLiteral("system"));
  const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                      tr("Arm once, save a picture of the window and leave; simulation only."),
                                      QStringLiteral("FILE"));
  const QCommandLineOption after(QStringLiteral("after"), tr("Seconds before the picture is taken; default: 5."),
                                 QStringLiteral("S"), QStringLiteral("5"));
  parser.addOptions({help, version, simulate, finger, camera, robot, key, profile, theme_name, screenshot, after});
  if (!parser.parse(arguments)) return fail("{}", parser.errorText().toStdString());
  Options options;
  if (parser.isSet(help)) {
    options.help = parser.helpText();
    return options;
  }
  if (parser.isSet(version)) {
    options.help = QStringLiteral("fyd-console " FYD_VERSION "\n");
    return options;
  }
  if (!parser.positionalArguments().isEmpty()) {
    return fail("unexpected argument '{}'; --help shows the options",
                parser.positionalArguments().first().toStdString());
  }
  options.finger_csv = parser.value(finger);
  options.camera = parser.value(camera);
  options.robot = parser.value(robot);
  options.key = parser.value(key);
  options.profile = parser.value(profile);
  options.screenshot = parser.value(screenshot);
  options.screenshot_after_s = widgets::readNumber(parser.value(after));
  if (!(options.screenshot_after_s >= 0.0 && options.screenshot_after_s <= 3600.0)) {
    return fail("--after {}: expected a number of seconds from 0 to 3600", parser.value(after).toStdString());
  }
  const auto choice = readTheme(parser.value(theme_name));
  if (!choice) return tl::unexpected(choice.error());
  options.theme = *choice;
  if (const auto ok = checkReadable("--finger", options.finger_csv); !ok) return tl::unexpected(ok.error());
  return options;
}

}  // namespace fyd::console
