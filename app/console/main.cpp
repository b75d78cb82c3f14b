// fyd-console: the operator's window. Exit codes: 0 success, 1 a file or the session could not be opened, 2 wrong usage, 128
// + N ended by signal N, 3 the display was lost, both with the recording closed.
#include <QApplication>
#include <QBuffer>
#include <QFileInfo>
#include <QSocketNotifier>
#include <QStandardPaths>
#include <QTimer>
#include <cstdio>

#include "app/console/shell/key_guard.h"
#include "app/console/shell/language.h"
#include "app/console/shell/options.h"
#include "app/console/window/exit_guard.h"
#include "app/console/window/geometry_dump.h"
#include "app/console/window/main_window.h"
#include "app/console/window/places.h"
#include "app/console/window/start.h"
#include "core/base/end_signals.h"
#include "core/device/camera/capture_camera.h"
#include "core/station/profile/replace_file.h"

namespace {

using fyd::console::Options;

int complain(const fyd::Message& message, int code) {
  std::fprintf(stderr, "fyd-console: %s\n", message.text().c_str());
  return code;
}

/// The operator's own profile, where "Save profile" writes when no other was named.
QString ownProfile() {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + QStringLiteral("/profile.toml");
}

/// The name's extension gives the format.
fyd::Result<void> savePicture(const QPixmap& picture, const QString& path) {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  if (!picture.save(&bytes, QFileInfo(path).suffix().toUtf8().constData()))
    return fyd::fail("{}: no picture of this format can be made", path.toStdString());
  return fyd::station::replaceFile(path.toStdString(), bytes.data().toStdString());
}

/// Saves a screenshot of the window and quits. Arms only a simulated touchpad, so that no real motor moves.
void takePictureAfter(fyd::console::MainWindow& window, const Options& options, bool simulated) {
  if (simulated) window.armOnce();
  QTimer::singleShot(static_cast<int>(options.screenshot_after_s * 1000.0), &window,
                     [&window, path = options.screenshot] {
                       const auto saved = savePicture(window.grab(), path);
                       window.close();
                       QApplication::exit(saved ? 0 : complain(saved.error().message, 1));
                     });
}

/// Once the window has settled: shown, its panels placed, the first states and readiness heard.
void printGeometryAndLeave(fyd::console::MainWindow& window) {
  constexpr int kSettled_ms = 1000;
  QTimer::singleShot(kSettled_ms, &window, [&window] {
    const QByteArray json = fyd::console::dumpGeometry(window);
    const bool written = std::fwrite(json.constData(), 1, static_cast<std::size_t>(json.size()), stdout) ==
                             static_cast<std::size_t>(json.size()) &&
                         std::fflush(stdout) == 0;
    window.close();
    QApplication::exit(written ? 0 : 1);
  });
}

}  // namespace

int main(int argc, char** argv) {
  fyd::makeFailedWritesErrors();
  // Help and mistakes need no display, so they are dealt with before the application asks for one.
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  const auto options = fyd::console::readOptions(arguments, fyd::console::placeNames());
  if (!options) return complain(options.error().message, 2);
  if (!options->help.isEmpty()) {
    std::fputs(qPrintable(options->help), stdout);
    return 0;
  }
  QApplication::setApplicationName(QStringLiteral("fyd-console"));
  QApplication::setApplicationVersion(QStringLiteral(FYD_VERSION));
  const QString profile_path = options->profile.isEmpty() ? ownProfile() : options->profile;
  // Screenshots show the standard window, whatever was changed in it before.
  const fyd::console::WindowMemory memory(!options->standardWindow() ? fyd::console::memoryFile(profile_path)
                                                                     : QString());
  const auto start = fyd::console::readStart(*options, profile_path, memory);
  if (!start) return complain(start.error().message, 1);
  if (const auto there = fyd::console::checkReview(*options); !there) return complain(there.error().message, 1);
  fyd::watchForEnd();
  fyd::device::prepareCaptures();  // the session may be opened later, beside the threads of the window
  auto opened = fyd::console::openStart(*start);
  if (!opened) return complain(opened.error().message, 1);

  if (options->scale > 0.0) qputenv("QT_SCALE_FACTOR", QByteArray::number(options->scale));
  fyd::console::Application application(argc, argv);
  fyd::console::speak(application, fyd::console::chooseLanguage({options->language, memory.language()}));
  fyd::widgets::Look::instance().apply(
      application, options->theme.value_or(memory.theme().value_or(fyd::widgets::ThemeChoice::system)));
  fyd::console::MainWindow window(std::move(opened->session), profile_path, options->catalogue, memory);
  if (!options->page.isEmpty()) window.frame()->go(options->page);
  if (!options->trials.conditions.isEmpty()) (void)window.trials()->plan(options->trials);  // checked by readOptions
  if (!options->review.isEmpty()) window.review(options->review);
  if (options->size.isValid()) window.resize(options->size);
  window.show();
  window.openPanels(options->open);
  window.start();
  if (start->first) window.showFirstSteps();
  if (!start->damaged_profile.empty()) {
    complain(start->damaged_profile, 0);
    window.tellDamagedProfile(start->damaged_profile);
  } else if (start->devices_remembered) {
    window.expectDevices(opened->missing);
  }
  if (options->dump_geometry) printGeometryAndLeave(window);
  if (!options->screenshot.isEmpty()) {
    const auto sources = fyd::station::withProfileSources(start->station);
    takePictureAfter(window, *options, sources.touchpad == "simulated" && sources.motors.empty());
  }
  QSocketNotifier asked_to_end(fyd::endSignalDescriptor(), QSocketNotifier::Read);
  QObject::connect(&asked_to_end, &QSocketNotifier::activated, &window, [&] {
    asked_to_end.setEnabled(false);
    window.close();  // closes the recording too
    QApplication::quit();
  });
  const fyd::console::ExitGuard guard([&window] { window.endWithoutDisplay(); });
  const int code = QApplication::exec();
  return fyd::endSignal() == 0 ? code : fyd::exitCodeOf(fyd::endSignal());
}
