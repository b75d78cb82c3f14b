#include "app/console/operate/finger_menu.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "app/console/operate/recording_control.h"
#include "core/sim/gesture_card.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

constexpr std::array kSpeeds = {0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int kNameWidth = 20 * widgets::kGrid;

}  // namespace

FingerMenu::FingerMenu(Session& session, Tell tell, QWidget* parent)
    : QToolButton(parent),
      session_(session),
      tell_(std::move(tell)),
      folder_(sessionsFolder()),
      menu_(new QMenu(this)),
      speeds_(new QMenu(tr("Speed"), menu_)),
      what_(new QActionGroup(this)),
      speed_(new QActionGroup(this)),
      demonstration_(menu_->addAction(tr("Demonstration"))),
      recorded_(menu_->addAction(QString())),
      again_(nullptr) {
  build();
  // What the session was started with is played already.
  if (const std::string file = session_.fingerFile(); !file.empty()) {
    if (const auto hand = read(QString::fromStdString(file))) take(*hand);
  }
  show();
}

void FingerMenu::build() {
  setObjectName(QStringLiteral("finger_menu"));
  setPopupMode(QToolButton::InstantPopup);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setFont(widgets::textFont(widgets::TextSize::small));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setMenu(menu_);
  for (QAction* each : {demonstration_, recorded_}) {
    each->setCheckable(true);
    what_->addAction(each);
  }
  connect(demonstration_, &QAction::triggered, this, &FingerMenu::playDemonstration);
  connect(recorded_, &QAction::triggered, this, [this] {
    demonstrates_ = false;
    play();
  });
  connect(menu_->addAction(tr("Gesture card …")), &QAction::triggered, this, &FingerMenu::chooseFile);
  menu_->addSeparator();
  menu_->addMenu(speeds_);
  again_ = menu_->addAction(tr("Again and again"));
  again_->setCheckable(true);
  again_->setChecked(true);
  connect(again_, &QAction::triggered, this, &FingerMenu::play);
  setSpeed(1.0);
}

double FingerMenu::speed() const {
  const QAction* chosen = speed_->checkedAction();
  return chosen != nullptr ? chosen->data().toDouble() : 1.0;
}

/// Fills the menu with the usual speeds, and with this one if it is none of them.
void FingerMenu::setSpeed(double speed) {
  for (QAction* each : speed_->actions()) delete each;
  std::vector<double> all(kSpeeds.begin(), kSpeeds.end());
  if (std::ranges::find(all, speed) == all.end()) all.insert(std::ranges::upper_bound(all, speed), speed);
  for (const double each : all) {
    QAction* action = speeds_->addAction(tr("%1 ×").arg(widgets::plainNumber(each)));
    action->setData(each);
    action->setCheckable(true);
    speed_->addAction(action);
    action->setChecked(each == speed);
    connect(action, &QAction::triggered, this, &FingerMenu::play);
  }
}

/// A card has its own speed and repetition; a recorded hand is played at its own speed, repeatedly.
Result<FingerMenu::Hand> FingerMenu::read(const QString& path) {
  const std::string file = path.toStdString();
  const auto finger = sim::readFingerFile(file);
  if (!finger) return tl::unexpected(finger.error());
  if (const auto card = sim::readGestureFile(file)) {
    return Hand{QString::fromStdString(card->name), sim::FingerPath::fromKnots(card->rows), card->speed, card->loop};
  }
  return Hand{QFileInfo(path).fileName(), *finger};
}

void FingerMenu::take(const Hand& hand) {
  hand_ = hand;
  demonstrates_ = false;
  setSpeed(hand.speed);
  again_->setChecked(hand.again);
}

void FingerMenu::playFile(const QString& path) {
  folder_ = QFileInfo(path).absolutePath();
  reading_.run([this, path](const std::stop_token&) -> Background::Finish {
    return [this, hand = guarded([&] { return read(path); })] {
      if (!hand) {
        tell_(widgets::Severity::warning, widgets::coreText(hand.error().message));
        return;
      }
      take(*hand);
      play();
    };
  });
}

void FingerMenu::playDemonstration() {
  demonstrates_ = true;
  play();
}

void FingerMenu::play() {
  const sim::FingerPath path = demonstrates_ ? sim::FingerPath::demonstration() : hand_->path;
  session_.playSimulatedFinger(path.played(speed(), again_->isChecked()));
  show();
}

void FingerMenu::show() {
  demonstration_->setChecked(demonstrates_);
  recorded_->setChecked(!demonstrates_);
  recorded_->setVisible(hand_.has_value());
  if (hand_) recorded_->setText(QString(hand_->name).replace(QLatin1Char('&'), QLatin1String("&&")));
  const QString name = demonstrates_ ? demonstration_->text() : hand_->name;
  const QString whole = tr("Simulated finger: %1").arg(name);
  setText(fontMetrics()
              .elidedText(tr("Finger: %1").arg(name), Qt::ElideRight, kNameWidth)
              .replace(QLatin1Char('&'), QLatin1String("&&")));
  setAccessibleName(whole);
  setToolTip(tr("%1, %2 ×, %3. A gesture card is made of a touch in Review.")
                 .arg(whole, widgets::plainNumber(speed()), again_->isChecked() ? tr("again and again") : tr("once")));
}

void FingerMenu::chooseFile() {
  auto* dialog = new QFileDialog(this, tr("Gesture card or recorded hand"), folder_,
                                 tr("Gesture cards (*.gesture);;Recorded hands (*.csv);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setModal(false);  // nothing is modal while a device can move
  connect(dialog, &QFileDialog::fileSelected, this, &FingerMenu::playFile);
  dialog->show();
}

}  // namespace fyd::console
