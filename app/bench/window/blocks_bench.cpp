// How long the window's thread is silent while the operator changes theme, language, place or dock, or opens a recording: the
// longest gap between two heartbeats, of which half a second holds a session with a real part.
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <functional>

#include "app/bench/window/bench_parts.h"
#include "app/bench/window/bench_session.h"
#include "app/console/window/main_window.h"

namespace fyd::console::bench {
namespace {

constexpr int kTurns = 5;
constexpr int kSettle_ms = 700;  // work that follows an action is over then

class BeatingSession : public BusySession {
 public:
  void windowAlive() override {
    const double now = now_ms();
    longest_ms = std::max(longest_ms, now - last_ms);
    last_ms = now;
  }
  double last_ms = now_ms();
  double longest_ms = 0.0;
};

void runFor(int ms) {
  QElapsedTimer passed;
  passed.start();
  while (passed.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 20);
}

}  // namespace

std::vector<Row> blockRows(const Settings& settings) {
  auto made = std::make_unique<BeatingSession>();
  BeatingSession* session = made.get();
  QTemporaryDir folder;
  MainWindow window(std::move(made), folder.filePath(QStringLiteral("profile.toml")));
  window.resize(1600, 1000);
  window.show();
  window.start();
  runFor(3000);  // the minute of samples that comes at once, and first-time initialisation

  std::vector<Row> rows;
  const auto silenceOf = [&](const std::function<void()>& act) {
    session->longest_ms = 0.0;
    QMetaObject::invokeMethod(&window, act, Qt::QueuedConnection);  // in an event, as an operator's
    runFor(kSettle_ms);
    for (const double last_ms = session->last_ms; session->last_ms == last_ms;) runFor(20);  // ends with a heartbeat
    return session->longest_ms;
  };
  const auto add = [&](const std::string& what, const std::vector<std::function<void()>>& acts) {
    std::vector<double> silences;
    for (int turn = 0; turn < kTurns; ++turn) {
      for (const auto& act : acts) silences.push_back(silenceOf(act));
    }
    Row row{.what = what, .scale = scaleWord(), .aim = "worst < 250"};
    rows.push_back(summarise(row, std::move(silences)));
  };
  const auto triggering = [&](const char* id) {
    return [&window, id] { window.commands().action(QLatin1String(id))->trigger(); };
  };

  add("nothing, baseline", {[] {}});
  add("change of theme, put off while it renders", {triggering("view.theme_light"), triggering("view.theme_dark")});
  add("change of language", {triggering("view.language_it"), triggering("view.language_en")});
  for (const char* place : {"calibrate", "review", "tune", "devices"}) {
    const std::string command = std::string("place.") + place;
    add(std::string("place ") + place + ", and back",
        {[&window, command] { window.commands().action(QString::fromStdString(command))->trigger(); },
         triggering("place.operate")});
  }
  for (const auto& [name, id] : {std::pair{"log", "view.log"}, {"link", "view.link"}, {"manual", "help.manual"}}) {
    add(std::string("dock ") + name + ", open and closed", {triggering(id), triggering(id)});
  }
  if (!settings.recording.empty()) {
    const QString file = QString::fromStdString(settings.recording);
    add("a recording opens", {[&] { window.review(file); }, triggering("place.operate")});
  }
  return rows;
}

}  // namespace fyd::console::bench
