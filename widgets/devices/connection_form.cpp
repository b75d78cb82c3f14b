#include "widgets/devices/connection_form.h"

#include <QApplication>
#include <QFileInfo>
#include <QLineEdit>
#include <QVBoxLayout>

#include "widgets/basics/core_text.h"
#include "widgets/basics/theme.h"
#include "widgets/devices/device_text.h"

namespace fyd::widgets {
namespace {

using Entry = SourceKind::Entry;

const QString kSimulated = QStringLiteral("simulated");

std::function<bool(const QString&)> is(const QString& word) {
  return [word](const QString& text) { return text == word; };
}

std::function<bool(const QString&)> beginsWith(const QString& prefix) {
  return [prefix](const QString& text) { return text.startsWith(prefix); };
}

SourceKind recordingKind() {
  const QString prefix = QStringLiteral("recording:");
  return {.label = ConnectionForm::tr("Recording, played back"),
          .prefix = prefix,
          .entry = Entry::file,
          .example = QStringLiteral("session.h5"),
          .missing = ConnectionForm::tr("Choose the recording."),
          .file_filter = ConnectionForm::tr("Recordings (*.h5);;All files (*)"),
          .fits = beginsWith(prefix)};
}

std::vector<SourceKind> touchpadKinds() {
  const QString tcp = QStringLiteral("modbus-tcp:");
  const QString rtu = QStringLiteral("modbus-rtu:");
  return {{.label = ConnectionForm::tr("Simulated"), .prefix = kSimulated, .fits = is(kSimulated)},
          {.label = ConnectionForm::tr("Network (Modbus TCP)"),
           .prefix = tcp,
           .entry = Entry::text,
           .example = QStringLiteral("192.168.0.7:502"),
           .missing = ConnectionForm::tr("Enter the touchpad's address and port, such as 192.168.0.7:502."),
           .fits = beginsWith(tcp)},
          {.label = ConnectionForm::tr("Serial line (Modbus RTU)"),
           .prefix = rtu,
           .entry = Entry::found,
           .example = QStringLiteral("/dev/ttyUSB0:115200"),
           .missing = ConnectionForm::tr("Choose the serial port; behind a colon its speed, 115 200 Bd without."),
           .fits = beginsWith(rtu)},
          recordingKind()};
}

std::vector<SourceKind> motorKinds() {
  const QString board = QStringLiteral("qbmove:");
  return {{.label = ConnectionForm::tr("The touchpad's own"), .prefix = {}, .fits = is({})},
          {.label = ConnectionForm::tr("Motor board (qbmove)"),
           .prefix = board,
           .entry = Entry::found,
           .example = QStringLiteral("/dev/ttyUSB1"),
           .missing = ConnectionForm::tr("Choose the motor board's serial port."),
           .fits = beginsWith(board)}};
}

std::vector<SourceKind> cameraKinds() {
  const auto of_this_computer = [](const QString& text) {
    bool number = false;
    (void)text.toUInt(&number);
    return number || text.startsWith(QLatin1String("/dev/")) || text.startsWith(QLatin1String("id="));
  };
  return {
      {.label = ConnectionForm::tr("The touchpad's own"), .prefix = {}, .fits = is({})},
      {.label = ConnectionForm::tr("Camera of this computer"),
       .prefix = {},
       .entry = Entry::found,
       .example = QStringLiteral("/dev/video0"),
       .missing = ConnectionForm::tr("Choose the camera."),
       .fits = of_this_computer},
      {.label = ConnectionForm::tr("Stream (address)"),
       .prefix = {},
       .entry = Entry::text,
       .example = QStringLiteral("http://192.168.0.7:8090/"),
       .missing = ConnectionForm::tr("Enter the stream's address, such as http://192.168.0.7:8090/."),
       .fits = [](const QString& text) { return text.contains(QLatin1String("://")); }},
      recordingKind(),
      {.label = ConnectionForm::tr("Folder of pictures"),
       .prefix = {},
       .entry = Entry::folder,
       .example = QStringLiteral("pictures/"),
       .missing = ConnectionForm::tr("Choose the folder."),
       .fits = [](const QString& text) { return text.endsWith(QLatin1Char('/')) || QFileInfo(text).isDir(); }},
      {.label = ConnectionForm::tr("Video file"),
       .prefix = {},
       .entry = Entry::file,
       .example = QStringLiteral("press.avi"),
       .missing = ConnectionForm::tr("Choose the video file."),
       .fits = [](const QString& text) { return !text.isEmpty(); }},
  };
}

}  // namespace

ConnectionForm::ConnectionForm(QWidget* parent)
    : QFrame(parent),
      touchpad_(new PartChoice(tr("Touchpad"), QStringLiteral("touchpad"), touchpadKinds(), this)),
      motors_(new PartChoice(tr("Motors"), QStringLiteral("motors"), motorKinds(), this)),
      camera_(new PartChoice(tr("Camera"), QStringLiteral("camera"), cameraKinds(), this)),
      foot_(new QFrame(this)),
      robot_(new QPushButton(tr("Robot…"), foot_)),
      hint_(new QLabel(foot_)),
      connect_(new QPushButton(tr("Connect"), foot_)) {
  for (QFrame* each : {static_cast<QFrame*>(this), foot_}) each->setProperty("surface", "panel");
  setAccessibleName(tr("Connect devices"));
  auto* title = new QLabel(tr("Connect"), this);
  title->setFont(textFont(TextSize::normal, true));
  robot_->setObjectName(QStringLiteral("connect_robot"));
  robot_->setAutoDefault(false);
  robot_->setToolTip(tr("The robot is chosen in the link's panel."));
  hint_->setFont(textFont(TextSize::small));
  hint_->setProperty("role", "muted");
  hint_->setWordWrap(true);
  connect_->setObjectName(QStringLiteral("connect"));
  connect_->setAutoDefault(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  layout->setSpacing(kGrid);
  for (QWidget* each : {static_cast<QWidget*>(title), static_cast<QWidget*>(touchpad_), static_cast<QWidget*>(motors_),
                        static_cast<QWidget*>(camera_)}) {
    layout->addWidget(each);
  }
  auto* lines = new QVBoxLayout(foot_);
  lines->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  lines->setSpacing(kGrid);
  for (QWidget* each : {static_cast<QWidget*>(hint_), static_cast<QWidget*>(robot_), static_cast<QWidget*>(connect_)}) {
    lines->addWidget(each);
  }
  connect(touchpad_, &PartChoice::changed, this, &ConnectionForm::touchpadChanged);
  connect(motors_, &PartChoice::changed, this, &ConnectionForm::refresh);
  connect(camera_, &PartChoice::changed, this, &ConnectionForm::refresh);
  connect(connect_, &QPushButton::clicked, this, [this] {
    if (!work_.isEmpty()) return emit cancelAsked();
    emit connectAsked();
  });
  connect(robot_, &QPushButton::clicked, this, &ConnectionForm::robotAsked);
  for (const PartChoice* each : {touchpad_, motors_, camera_}) {
    connect(each->entry()->lineEdit(), &QLineEdit::returnPressed, connect_, &QPushButton::click);
  }
  refresh();
}

void ConnectionForm::setDevices(const ChosenDevices& devices) {
  touchpad_->setWord(devices.touchpad);
  motors_->setWord(devices.motors);
  camera_->setWord(devices.camera);
}

ChosenDevices ConnectionForm::devices() const {
  return {.touchpad = touchpad_->word(), .motors = motors_->word(), .camera = camera_->word()};
}

void ConnectionForm::setRobot(const QString& robot) {
  robot_->setText(tr("Robot: %1 …").arg(coreText(robot.toStdString())));  // "simulated" and "none" have translations
}

void ConnectionForm::offer(const QStringList& serial_ports, const QStringList& cameras) {
  touchpad_->offer(serial_ports);
  motors_->offer(serial_ports);
  camera_->offer(cameras);
}

void ConnectionForm::setHindrance(const QString& why) {
  hindrance_ = why;
  refresh();
}

void ConnectionForm::setWork(const QString& words, bool can_be_cancelled) {
  work_ = words;
  can_be_cancelled_ = can_be_cancelled;
  refresh();
}

void ConnectionForm::askForOwn() {
  if (touchpad_->word() == kSimulated) touchpad_->kind()->setCurrentIndex(1);
  touchpad_->takeFocus();
}

/// A touchpad that has no pictures of its own needs a camera, and a simulated one brings its own.
void ConnectionForm::touchpadChanged() {
  const bool brings_pictures = touchpad_->word() == kSimulated || touchpad_->word().startsWith(QLatin1String("rec"));
  if (!brings_pictures && camera_->word().isEmpty() && camera_->kind()->currentIndex() == 0) {
    camera_->kind()->setCurrentIndex(1);
  } else if (brings_pictures && !camera_->missing().isEmpty()) {
    camera_->kind()->setCurrentIndex(0);
  }
  refresh();
}

QString ConnectionForm::missing() const {
  for (const PartChoice* each : {touchpad_, motors_, camera_}) {
    if (QString what = each->missing(); !what.isEmpty()) return what;
  }
  return {};
}

void ConnectionForm::refresh() {
  for (PartChoice* each : {touchpad_, motors_, camera_}) each->setEnabled(work_.isEmpty());
  connect_->setText(work_.isEmpty() ? tr("Connect") : tr("Cancel"));
  if (!work_.isEmpty()) {
    hint_->setText(work_);
    allowConnect(can_be_cancelled_);
    return;
  }
  const QString what = missing();
  hint_->setText(!hindrance_.isEmpty() ? hindrance_
                 : !what.isEmpty()     ? what
                                   : tr("The devices are asked first. Then the session starts anew; motors stay off "
                                        "until you arm. The choice is remembered."));
  allowConnect(hindrance_.isEmpty() && what.isEmpty());
}

/// The focus of a button that is disabled goes somewhere, and comes back unless it was moved on meanwhile.
void ConnectionForm::allowConnect(bool on) {
  const bool loses_focus = !on && connect_->hasFocus();
  connect_->setEnabled(on);
  if (loses_focus) fallen_to_ = QApplication::focusWidget();
  if (!on) return;
  if (fallen_to_ && fallen_to_ == QApplication::focusWidget()) connect_->setFocus(Qt::OtherFocusReason);
  fallen_to_.clear();
}

}  // namespace fyd::widgets
