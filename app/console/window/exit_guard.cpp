#include "app/console/window/exit_guard.h"

#include <QString>
#include <QtGlobal>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace fyd::console {
namespace {

std::function<void()> end_of_session;  // empty: no guard
QtMessageHandler former_handler = nullptr;

void endNow() {
  const auto end = std::exchange(end_of_session, {});
  if (!end) return;
  end();
  std::fputs("fyd-console: the display is gone; motors off, any recording closed\n", stderr);
  std::fflush(nullptr);
  std::_Exit(kDisplayLost);
}

void hear(QtMsgType type, const QMessageLogContext& context, const QString& words) {
  if (former_handler != nullptr) {
    former_handler(type, context, words);
  } else {
    std::fprintf(stderr, "%s\n", qPrintable(qFormatLogMessage(type, context, words)));
  }
  // "The X11 connection broke …", "The Wayland connection broke …": the last words before exit() and _exit().
  if (words.contains(QLatin1String("connection broke"))) endNow();
}

}  // namespace

ExitGuard::ExitGuard(std::function<void()> end) {
  static const bool registered = std::atexit(endNow) == 0;  // for who calls exit() without a word, such as libX11
  static_cast<void>(registered);
  end_of_session = std::move(end);
  former_handler = qInstallMessageHandler(hear);
}

ExitGuard::~ExitGuard() {
  qInstallMessageHandler(former_handler);
  end_of_session = {};
}

}  // namespace fyd::console
