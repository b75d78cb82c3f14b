// Random hands on the window: clicks, drags, wheels, keys and holds of chance at one place, in a whole simulated session, as
// fast as the window takes them. Built with a sanitizer this finds what no script thinks of. Besides not crashing, three
// things hold throughout: STOP and Arm do not move while the window keeps its size, Esc stops, and no action silences
// the window's thread for longer than the report says. What a hand could break outside the window is kept from it: a
// home of its own, and file dialogs are only cancelled or answered with the recording.
//
//   attack_random_hands PLACE [SECONDS] [SEED] [RECORDING]      full length: 600 seconds for each place
#include <QAbstractButton>
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "app/console/shell/key_guard.h"
#include "app/console/window/main_window.h"
#include "app/console/window/places.h"
#include "tests/own_home.h"
#include "widgets/basics/theme.h"

namespace {

using namespace fyd;

/// Opens what a click asks to open outside the window: nowhere.
class Nowhere : public QObject {
  // NOLINTNEXTLINE(clang-diagnostic-undefined-internal): moc defines it, and tidy.py leaves moc out
  Q_OBJECT
 public slots:
  void open(const QUrl& /*url*/) {}
};

constexpr const char* kSchemes[] = {"file", "http", "https"};

class Hands : public QObject {
 public:
  Hands(QString place, unsigned seed, QString recording)
      : place_(std::move(place)), recording_(std::move(recording)), random_(seed) {
    connect(&pulse_, &QTimer::timeout, this, &Hands::act);
  }

  /// Windows are opened one after the other, as hands close them, until the time is over.
  bool run(int seconds) {
    QElapsedTimer watch;
    watch.start();
    while (holds_ && watch.elapsed() < qint64{1000} * seconds) {
      ++windows_;
      auto window = open();
      if (window == nullptr) return false;
      QTimer::singleShot(std::max(0, seconds * 1000 - static_cast<int>(watch.elapsed())), window.get(),
                         [this] { over_ = true; });
      beat_.invalidate();
      pulse_.start(kPause_ms);
      QApplication::exec();
      pulse_.stop();
      window_ = nullptr;
    }
    std::printf("%s: %ld actions in %ld windows, Active %ld times; longest silence %lld ms, after %s\n",
                qPrintable(place_), actions_, windows_, active_, static_cast<long long>(silence_ms_),
                qPrintable(silenced_by_));
    return holds_;
  }

 private:
  static constexpr int kPause_ms = 5;
  static constexpr int kHold_ms = 1200;  // longer than Arm needs
  static constexpr int kHomeAfter = 400;
  static constexpr int kPatience_ms = 60'000;

  std::unique_ptr<console::MainWindow> open() {
    station::StationOptions options;
    auto session = console::openSession(options);
    if (!session) {
      std::printf("BROKEN: no session: %s\n", session.error().message.text().c_str());
      return nullptr;
    }
    auto window =
        std::make_unique<console::MainWindow>(std::move(*session), QDir::homePath() + QStringLiteral("/profile.toml"));
    window_ = window.get();
    window->resize(1280, 720);
    window->show();
    window->start();
    window->frame()->go(place_);
    if (!recording_.isEmpty() && place_ == QLatin1String("review")) window->review(recording_);
    connect(window->stateBar()->armButton(), &QObject::destroyed, this, [this] { holding_ = nullptr; });
    rests_.clear();
    return window;
  }

  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  template <class T>
  const T& oneOf(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(upTo(static_cast<int>(list.size()) - 1))];
  }

  void act() {
    if (window_ == nullptr) return;
    if (over_ && QApplication::activeModalWidget() == nullptr && QApplication::activePopupWidget() == nullptr)
      return finish();
    ++actions_;
    listen();
    if (QWidget* popup = QApplication::activePopupWidget()) {
      over_ ? static_cast<void>(popup->close()) : inPopup(*popup);
    } else if (QWidget* modal = QApplication::activeModalWidget()) {
      over_ ? static_cast<void>(modal->close()) : inDialog(*modal);
    } else {
      inWindow();
    }
    if (window_->stateBar()->stateWord() == QLatin1String("Active")) {
      active_ += was_active_ ? 0 : 1;
      was_active_ = true;
    } else {
      was_active_ = false;
    }
    checkRests();
  }

  /// How long the window's thread did nothing but what the last action began.
  void listen() {
    if (!beat_.isValid()) return beat_.start();
    const qint64 silence = beat_.restart() - kPause_ms;
    if (silence <= silence_ms_) return;
    silence_ms_ = silence;
    silenced_by_ = last_;
  }

  /// After the last action: Esc stops, whatever was done before.
  void finish() {
    pulse_.stop();
    if (holding_ != nullptr) QTest::mouseRelease(holding_, Qt::LeftButton);
    for (int i = 0; i < 3; ++i) QTest::keyClick(window_, Qt::Key_Escape);
    QElapsedTimer watch;
    watch.start();
    while (window_->stateBar()->stateWord() == QLatin1String("Active") && watch.elapsed() < kPatience_ms)
      QTest::qWait(20);
    expect(window_->stateBar()->stateWord() != QLatin1String("Active"), QStringLiteral("Esc did not stop"));
    QApplication::exit();
  }

  /// What asks is answered later by the same hands: its event loop must not wait for this action's end.
  template <class Action>
  void later(Action action) {
    QTimer::singleShot(0, this, std::move(action));
  }

  void inPopup(QWidget& popup) {
    if (upTo(9) == 0) return static_cast<void>(popup.close());
    if (upTo(4) == 0) return keyTo(popup);
    last_ = describe(popup, QStringLiteral("click"));
    const QPointer<QWidget> there(&popup);
    const QPoint place(upTo(std::max(0, popup.width() - 1)), upTo(std::max(0, popup.height() - 1)));
    later([there, place] {
      if (there != nullptr && there->isVisible()) {
        QWidget* child = there->childAt(place);
        QWidget* target = child != nullptr ? child : there.data();
        QTest::mouseClick(target, Qt::LeftButton, {}, child != nullptr ? child->mapFrom(there.data(), place) : place);
      }
    });
  }

  void inDialog(QWidget& modal) {
    if (auto* files = qobject_cast<QFileDialog*>(&modal)) {
      if (!recording_.isEmpty() && files->acceptMode() == QFileDialog::AcceptOpen && upTo(1) == 0) {
        if (auto* name = files->findChild<QLineEdit*>()) name->setText(recording_);
        const QPointer<QFileDialog> there(files);
        later([there] {
          if (there != nullptr) QMetaObject::invokeMethod(there.data(), "accept");
        });
      } else {
        files->reject();
      }
      return;
    }
    if (upTo(19) == 0) return static_cast<void>(modal.close());
    touch(modal);
  }

  void inWindow() {
    if (actions_ % kHomeAfter == 0) window_->frame()->go(place_);
    const int kind = upTo(199);
    if (kind == 0) {
      window_->resize(900 + upTo(1100), 600 + upTo(600));
    } else if (kind == 1 && holding_ == nullptr) {
      holdArm();
    } else if (kind < 40) {
      touch(*window_);
    } else if (QWidget* page = window_->frame()->page(window_->frame()->place())) {
      touch(*page);
    }
  }

  void holdArm() {
    holding_ = window_->stateBar()->armButton();
    QTest::mousePress(holding_, Qt::LeftButton);
    QTimer::singleShot(kHold_ms, this, [this] {
      if (holding_ != nullptr) QTest::mouseRelease(holding_, Qt::LeftButton);
      holding_ = nullptr;
    });
  }

  /// One action on something that can be seen in there.
  void touch(QWidget& area) {
    std::vector<QWidget*> seen;
    for (QWidget* each : area.findChildren<QWidget*>()) {
      if (each->isVisible() && each->window() == area.window() && !each->visibleRegion().isEmpty())
        seen.push_back(each);
    }
    if (seen.empty()) seen.push_back(&area);
    QWidget* target = oneOf(seen);
    const QRect shown = target->visibleRegion().boundingRect();
    const QPoint place(shown.left() + upTo(std::max(0, shown.width() - 1)),
                       shown.top() + upTo(std::max(0, shown.height() - 1)));
    const QPoint end(shown.left() + upTo(std::max(0, shown.width() - 1)),
                     shown.top() + upTo(std::max(0, shown.height() - 1)));
    const QPointer<QWidget> there(target);
    const int kind = upTo(99);
    last_ = describe(*target, QStringLiteral("mouse %1 at %2,%3").arg(kind).arg(place.x()).arg(place.y()));
    if (kind < 55) {
      later([there, place] {
        if (there != nullptr) QTest::mouseClick(there, Qt::LeftButton, {}, place);
      });
    } else if (kind < 60) {
      later([there, place] {
        if (there != nullptr) QTest::mouseDClick(there, Qt::LeftButton, {}, place);
      });
    } else if (kind < 63) {
      later([there, place] {
        if (there != nullptr) QTest::mouseClick(there, Qt::RightButton, {}, place);
      });
    } else if (kind < 72) {
      later([there, place, end] {
        if (there != nullptr) QTest::mousePress(there, Qt::LeftButton, {}, place);
        if (there != nullptr) QTest::mouseMove(there, end);
        if (there != nullptr) QTest::mouseRelease(there, Qt::LeftButton, {}, end);
      });
    } else if (kind < 77) {
      const int turn = 120 * (upTo(10) - 5);
      const auto with = upTo(2) == 0 ? Qt::ControlModifier : Qt::NoModifier;
      QWheelEvent wheel(place, target->mapToGlobal(place), QPoint(), QPoint(0, turn), Qt::NoButton, with,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(target, &wheel);
    } else {
      QWidget* focus = QApplication::focusWidget();
      keyTo(focus != nullptr ? *focus : *window_);
    }
  }

  static QString describe(const QWidget& target, const QString& what) {
    const auto* button = qobject_cast<const QAbstractButton*>(&target);
    return what + QStringLiteral(" on ") + QLatin1String(target.metaObject()->className()) + QLatin1Char(' ') +
           target.objectName() + QLatin1Char(' ') + target.accessibleName() + QLatin1Char(' ') +
           (button != nullptr ? button->text() : QString());
  }

  void keyTo(QWidget& target) {
    static const std::vector<Qt::Key> kKeys{
        Qt::Key_Tab,          Qt::Key_Backtab,   Qt::Key_Return, Qt::Key_Space, Qt::Key_Escape,
        Qt::Key_Left,         Qt::Key_Right,     Qt::Key_Up,     Qt::Key_Down,  Qt::Key_Home,
        Qt::Key_End,          Qt::Key_PageUp,    Qt::Key_Delete, Qt::Key_0,     Qt::Key_9,
        Qt::Key_Minus,        Qt::Key_Period,    Qt::Key_E,      Qt::Key_Comma, Qt::Key_BracketLeft,
        Qt::Key_BracketRight, Qt::Key_Backspace, Qt::Key_F1};
    const std::vector<Qt::KeyboardModifiers> with{Qt::NoModifier,    Qt::NoModifier,
                                                  Qt::NoModifier,    Qt::ControlModifier,
                                                  Qt::ShiftModifier, Qt::ControlModifier | Qt::ShiftModifier};
    const int kind = upTo(9);
    Qt::Key key = oneOf(kKeys);
    if (kind >= 5) key = static_cast<Qt::Key>(Qt::Key_A + upTo(25));
    const auto modifiers = oneOf(with);
    if (key == Qt::Key_Q && modifiers == Qt::ControlModifier && upTo(9) != 0) return;  // the end of a window: rarely
    const QPointer<QWidget> there(&target);
    last_ = describe(target, QStringLiteral("key ") + QKeySequence(QKeyCombination(modifiers, key)).toString());
    later([there, key, modifiers] {
      if (there != nullptr) QTest::keyClick(there, key, modifiers);
    });
  }

  void checkRests() {
    if (!window_->isVisible()) return;
    const auto rest = [this](const QWidget* button) {
      return QRect(button->mapTo(static_cast<const QWidget*>(window_), QPoint(0, 0)), button->size());
    };
    const std::pair<QRect, QRect> now{rest(window_->stateBar()->stopButton()), rest(window_->stateBar()->armButton())};
    // A size's first look may be one before its layout: what counts is that it stands still once it has stood.
    auto& seen = rests_[{window_->width(), window_->height()}];
    ++seen.looks;
    if (seen.looks <= kSettled || seen.where.first.isNull()) {
      seen.where = now;
    } else if (seen.where != now) {
      const QRect is = now.first;
      const QRect was = seen.where.first;
      expect(false, QStringLiteral("STOP or Arm moved: STOP from %1,%2 %3x%4 to %5,%6 %7x%8, arm width %9 to %10")
                        .arg(was.x())
                        .arg(was.y())
                        .arg(was.width())
                        .arg(was.height())
                        .arg(is.x())
                        .arg(is.y())
                        .arg(is.width())
                        .arg(is.height())
                        .arg(seen.where.second.width())
                        .arg(now.second.width()));
    }
  }

  void expect(bool holds, const QString& what) {
    if (holds) return;
    holds_ = false;
    std::printf("BROKEN at %s, action %ld: %s\n", qPrintable(place_), actions_, qPrintable(what));
    QApplication::exit();
  }

  struct Rest {
    std::pair<QRect, QRect> where;
    long looks = 0;
  };
  static constexpr long kSettled = 60;

  QString place_;
  QString recording_;
  std::mt19937 random_;
  QTimer pulse_;
  console::MainWindow* window_ = nullptr;
  QWidget* holding_ = nullptr;
  std::map<std::pair<int, int>, Rest> rests_;
  bool was_active_ = false;
  QElapsedTimer beat_;  ///< since the last action
  bool over_ = false;
  bool holds_ = true;
  long actions_ = 0;
  long windows_ = 0;
  long active_ = 0;
  qint64 silence_ms_ = 0;
  QString silenced_by_;
  QString last_;  ///< action
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || !console::placeNames().contains(QLatin1String(argv[1]))) {
    std::fprintf(stderr, "attack_random_hands: PLACE is one of %s\n",
                 qPrintable(console::placeNames().join(QStringLiteral(", "))));
    return 2;
  }
  const int seconds = argc > 2 ? std::atoi(argv[2]) : 10;
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)) : 1;
  const fyd::OwnHome home;
  QString recording;
  if (argc > 4) {
    recording = QString::fromStdString(home.file("session.h5"));
    if (!QFile::copy(QString::fromLocal8Bit(argv[4]), recording)) {
      std::fprintf(stderr, "attack_random_hands: %s cannot be copied\n", argv[4]);
      return 2;
    }
  }
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  console::Application application(argc, argv);
  QLocale::setDefault(QLocale(QStringLiteral("en")));
  widgets::Look::instance().apply(application, widgets::ThemeChoice::dark);
  Nowhere nowhere;
  for (const char* scheme : kSchemes) QDesktopServices::setUrlHandler(QLatin1String(scheme), &nowhere, "open");
  const bool held = Hands(QLatin1String(argv[1]), seed, recording).run(seconds);
  for (const char* scheme : kSchemes) QDesktopServices::unsetUrlHandler(QLatin1String(scheme));
  return held ? 0 : 1;
}

#include "random_hands.moc"
