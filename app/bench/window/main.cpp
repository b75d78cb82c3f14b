// fyd-window-bench: measures the operator's window, and prints one table as JSON; `fyd bench window` shows it.
// Each part runs in a process of its own, at 100 % and 200 % where the scale matters.
#include <QApplication>
#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <cmath>
#include <ctime>

#include "app/bench/window/timed_application.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console::bench {

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double threadCpu_ms() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

std::string scaleWord() { return QString::number(qRound(100.0 * qApp->devicePixelRatio())).toStdString() + " %"; }

namespace {

struct Part {
  const char* name;
  std::vector<Row> (*run)(const Settings&);
  std::vector<const char*> scales;
};

const std::vector<Part>& parts() {
  static const std::vector<Part> kParts = {{"frame", frameRows, {"1", "2"}}, {"naive", naiveFrameRows, {"1", "2"}},
                                           {"zoom", zoomRows, {"1", "2"}},   {"scene", sceneRows, {"1", "2"}},
                                           {"start", startRows, {"1"}},      {"blocks", blockRows, {"1", "2"}},
                                           {"soak", soakRows, {"1"}}};
  return kParts;
}

QJsonArray cellsOf(const Row& row) {
  const auto text = [](const std::string& words) { return QString::fromStdString(words); };
  const auto figure = [](double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 3) : QString(widgets::kNoValue);
  };
  return {text(row.compared), text(row.what), text(row.scale), figure(row.p50), figure(row.p95),
          figure(row.worst),  text(row.unit), text(row.aim),   text(row.error)};
}

int runPart(const Part& part, const Settings& settings) {
  QJsonArray rows;
  for (const Row& row : part.run(settings)) rows.append(cellsOf(row));
  std::fputs(QJsonDocument(rows).toJson(QJsonDocument::Compact).constData(), stdout);
  return rows.isEmpty() ? 1 : 0;
}

int runAll(const QStringList& passed, const QStringList& only) {
  QJsonArray rows;
  int failed = 0;
  for (const Part& part : parts()) {
    if (!only.isEmpty() && !only.contains(QLatin1String(part.name))) continue;
    for (const char* scale : part.scales) {
      QProcess process;
      QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
      environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QLatin1String(scale));
      process.setProcessEnvironment(environment);
      process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
      process.start(QCoreApplication::applicationFilePath(),
                    QStringList{QStringLiteral("--part"), QLatin1String(part.name)} + passed);
      process.waitForFinished(-1);
      const QJsonArray found = QJsonDocument::fromJson(process.readAllStandardOutput()).array();
      if (process.exitStatus() != QProcess::NormalExit || found.isEmpty()) ++failed;
      for (const auto& row : found) rows.append(row);
    }
  }
  const QJsonObject table{
      {QStringLiteral("title"), QStringLiteral("The operator's window")},
      {QStringLiteral("columns"),
       QJsonArray{"compared", "measured", "scale", "p50", "p95", "worst", "unit", "aim", "error"}},
      {QStringLiteral("rows"), rows},
      {QStringLiteral("notes"),
       QJsonArray{
           QStringLiteral("Drawn by %1 in software, without a graphics processor. A frame is all work of the "
                          "window's thread in a thirtieth of a second, the camera's period: feeding, numerals, "
                          "camera, decimation, drawing, painting. Times are wall clock unless the row says otherwise, "
                          "so whatever else the machine does is in them.")
               .arg(QGuiApplication::platformName())}}};
  std::fputs(QJsonDocument(table).toJson().constData(), stdout);
  if (failed > 0) std::fprintf(stderr, "fyd-window-bench: %d parts gave no figures\n", failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace fyd::console::bench

int main(int argc, char** argv) {
  using namespace fyd::console::bench;
  // Offscreen without a display; software rendering in both cases.
  const bool display = !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
  if (!display && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  TimedApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("fyd-window-bench"));
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Measures the operator's window; prints a table as JSON."));
  parser.addHelpOption();
  QStringList names;
  for (const Part& part : parts()) names << QLatin1String(part.name);
  parser.addOptions({{"part", "One of " + names.join(QStringLiteral(", ")) + "; all when left out.", "NAME"},
                     {"only", "Parts of the table, with commas between; all when left out.", "NAMES"},
                     {"seconds", "Of measuring at full load; default: 10.", "S"},
                     {"recording", "Recording that is opened in the part blocks; none when left out.", "FILE"},
                     {"hours", "Of samples in the soak; default: 0.25.", "H"}});
  parser.process(application);
  Settings settings;
  QStringList passed;
  const auto read = [&](const char* name, double& into, double most) {
    const QString text = parser.value(QLatin1String(name));
    if (text.isEmpty()) return true;
    bool good = false;
    into = text.toDouble(&good);
    passed << QStringLiteral("--") + QLatin1String(name) << text;
    return good && into > 0.0 && into <= most;
  };
  if (!read("seconds", settings.seconds, 3600.0) || !read("hours", settings.hours, 100.0)) {
    std::fputs("fyd-window-bench: expected a number above 0, of seconds up to 3600, of hours up to 100\n", stderr);
    return 2;
  }
  if (const QString recording = parser.value(QStringLiteral("recording")); !recording.isEmpty()) {
    settings.recording = recording.toStdString();
    passed << QStringLiteral("--recording") << recording;
  }
  fyd::widgets::Look::instance().apply(application, fyd::widgets::ThemeChoice::dark);
  const QString wanted = parser.value(QStringLiteral("part"));
  if (wanted.isEmpty())
    return runAll(passed, parser.value(QStringLiteral("only")).split(QLatin1Char(','), Qt::SkipEmptyParts));
  for (const Part& part : parts()) {
    if (wanted == QLatin1String(part.name)) return runPart(part, settings);
  }
  std::fprintf(stderr, "fyd-window-bench: --part %s: expected one of %s\n", qPrintable(wanted),
               qPrintable(names.join(QStringLiteral(", "))));
  return 2;
}
