#include "widgets/devices/robot_form.h"

#include <QFileDialog>
#include <QGridLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wheel_guard.h"
#include "widgets/devices/device_text.h"

namespace fyd::widgets {
namespace {

enum Kind { simulated, none, classic, link, scene };

const QString kPredictedPrefix = QStringLiteral("simulated:");

// In the order of Kind; those that end in a colon go on with the address, or the scene's file.
const QStringList& words() {
  static const QStringList kWords = {QStringLiteral("simulated"), QStringLiteral("none"), QStringLiteral("classic:"),
                                     QStringLiteral("link:"), QStringLiteral("scene:")};
  return kWords;
}

}  // namespace

RobotForm::RobotForm(QWidget* parent)
    : QFrame(parent),
      kind_(new QComboBox(this)),
      predictor_label_(new QLabel(tr("Predictor"), this)),
      predictor_(new QComboBox(this)),
      address_label_(new QLabel(tr("Listen on"), this)),
      address_(new QLineEdit(this)),
      key_label_(new QLabel(tr("Key file"), this)),
      key_(new QLineEdit(this)),
      browse_(new QToolButton(this)),
      scene_label_(new QLabel(tr("Scene file"), this)),
      scene_(new QLineEdit(this)),
      browse_scene_(new QToolButton(this)),
      hint_(new QLabel(this)),
      reconnect_(new QPushButton(tr("Reconnect"), this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Robot"));
  auto* title = new QLabel(tr("Change the robot"), this);
  title->setFont(textFont(TextSize::normal, true));
  kind_->setObjectName(QStringLiteral("robot_kind"));
  kind_->setAccessibleName(tr("Robot"));
  kind_->addItem(tr("Simulated"));
  kind_->addItem(tr("None"));
  kind_->addItem(tr("Classic (not secured)"));
  kind_->addItem(tr("FYD Link with a key"));
  kind_->addItem(tr("Scene"));
  kind_->setMinimumContentsLength(16);
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (QComboBox* each : {kind_, predictor_}) guardFromWheel(each);
  predictor_->setObjectName(QStringLiteral("robot_predictor"));
  predictor_->setAccessibleName(predictor_label_->text());
  predictor_->setToolTip(tr("How the robot's end says where the finger is now; \"thesis\" follows late and smoothly."));
  address_->setObjectName(QStringLiteral("robot_address"));
  address_->setPlaceholderText(QStringLiteral("127.0.0.1:3490"));
  address_->setAccessibleName(tr("Address and port to listen on"));
  address_->setToolTip(
      tr("This computer's own address, HOST:PORT. The robot calls there; 0.0.0.0 hears every network."));
  key_->setObjectName(QStringLiteral("robot_key"));
  key_->setAccessibleName(key_label_->text());
  key_->setToolTip(tr("The robot must have the same key; \"fyd link keygen\" makes one."));
  browse_->setText(tr("…"));
  browse_->setAccessibleName(tr("Choose the key file"));
  scene_->setObjectName(QStringLiteral("robot_scene"));
  scene_->setAccessibleName(scene_label_->text());
  scene_->setToolTip(tr("What stands in the robot's place and is touched; \"fyd scene keys\" shows what it may say."));
  browse_scene_->setText(tr("…"));
  browse_scene_->setAccessibleName(tr("Choose the scene file"));
  hint_->setFont(textFont(TextSize::small));
  hint_->setProperty("role", "muted");
  hint_->setWordWrap(true);
  reconnect_->setObjectName(QStringLiteral("robot_reconnect"));
  reconnect_->setAutoDefault(false);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid / 2);
  grid->setColumnStretch(1, 1);
  grid->addWidget(title, 0, 0, 1, 3);
  grid->addWidget(kind_, 1, 0, 1, 3);
  grid->addWidget(address_label_, 2, 0);
  grid->addWidget(address_, 2, 1, 1, 2);
  grid->addWidget(key_label_, 3, 0);
  grid->addWidget(key_, 3, 1);
  grid->addWidget(browse_, 3, 2);
  grid->addWidget(predictor_label_, 4, 0);
  grid->addWidget(predictor_, 4, 1, 1, 2);
  grid->addWidget(scene_label_, 5, 0);
  grid->addWidget(scene_, 5, 1);
  grid->addWidget(browse_scene_, 5, 2);
  grid->addWidget(hint_, 6, 0, 1, 3);
  grid->addWidget(reconnect_, 7, 0, 1, 3);

  connect(kind_, &QComboBox::currentIndexChanged, this, &RobotForm::refresh);
  connect(address_, &QLineEdit::textChanged, this, &RobotForm::refresh);
  connect(key_, &QLineEdit::textChanged, this, &RobotForm::refresh);
  connect(scene_, &QLineEdit::textChanged, this, &RobotForm::refresh);
  connect(browse_, &QToolButton::clicked, this, [this] { chooseFile(tr("Key file of FYD Link"), {}, key_); });
  connect(browse_scene_, &QToolButton::clicked, this,
          [this] { chooseFile(tr("Scene file"), tr("Scenes (*.toml);;All files (*)"), scene_); });
  connect(reconnect_, &QPushButton::clicked, this, [this] {
    if (!work_.isEmpty()) return emit cancelAsked();
    emit reconnectAsked(robot(), keyFile());
  });
  refresh();
}

void RobotForm::setPredictors(const QStringList& names) {
  predictor_->clear();
  predictor_->addItems(names);
  refresh();
}

void RobotForm::setRobot(const QString& robot, const QString& key_file) {
  if (robot.startsWith(kPredictedPrefix)) {
    kind_->setCurrentIndex(simulated);
    predictor_->setCurrentText(robot.mid(kPredictedPrefix.size()));
  }
  for (int i = 0; i < words().size(); ++i) {
    const QString& word = words()[i];
    const bool with_address = word.endsWith(QLatin1Char(':'));
    if (with_address ? !robot.startsWith(word) : robot != word) continue;
    kind_->setCurrentIndex(i);
    if (i == simulated) predictor_->setCurrentIndex(0);
    if (with_address) (i == scene ? scene_ : address_)->setText(robot.mid(word.size()));
  }
  if (!key_file.isEmpty()) key_->setText(key_file);
}

void RobotForm::setHindrance(const QString& why) {
  if (why == hindrance_) return;
  hindrance_ = why;
  refresh();
}

void RobotForm::setWork(const QString& words, bool can_be_cancelled) {
  work_ = words;
  can_be_cancelled_ = can_be_cancelled;
  refresh();
}

QString RobotForm::robot() const {
  const QString& word = words()[std::max(0, kind_->currentIndex())];
  if (kind_->currentIndex() == simulated && predictor_->currentIndex() > 0) {
    return kPredictedPrefix + predictor_->currentText();
  }
  if (kind_->currentIndex() == scene) return word + asEntered(scene_->text());
  return word.endsWith(QLatin1Char(':')) ? word + asEntered(address_->text()) : word;
}

QString RobotForm::keyFile() const { return kind_->currentIndex() == link ? asEntered(key_->text()) : QString(); }

void RobotForm::refresh() {
  const int kind = kind_->currentIndex();
  const bool by_network = kind == classic || kind == link;
  const bool by_key = kind == link;
  const bool predicted = kind == simulated && predictor_->count() > 0;
  predictor_label_->setVisible(predicted);
  predictor_->setVisible(predicted);
  for (QWidget* each : {static_cast<QWidget*>(address_label_), static_cast<QWidget*>(address_)}) {
    each->setVisible(by_network);
  }
  for (QWidget* each :
       {static_cast<QWidget*>(key_label_), static_cast<QWidget*>(key_), static_cast<QWidget*>(browse_)}) {
    each->setVisible(by_key);
  }
  for (QWidget* each :
       {static_cast<QWidget*>(scene_label_), static_cast<QWidget*>(scene_), static_cast<QWidget*>(browse_scene_)}) {
    each->setVisible(kind == scene);
  }
  const bool address_missing = by_network && asEntered(address_->text()).isEmpty();
  const bool key_missing = by_key && keyFile().isEmpty();
  const bool scene_missing = kind == scene && asEntered(scene_->text()).isEmpty();
  for (QWidget* each :
       {static_cast<QWidget*>(kind_), static_cast<QWidget*>(scene_), static_cast<QWidget*>(browse_scene_)}) {
    each->setEnabled(work_.isEmpty());
  }
  reconnect_->setText(work_.isEmpty() ? tr("Reconnect") : tr("Cancel"));
  if (!work_.isEmpty()) {
    hint_->setText(work_);
    reconnect_->setEnabled(can_be_cancelled_);
    return;
  }
  if (!hindrance_.isEmpty()) {
    hint_->setText(hindrance_);
  } else if (address_missing) {
    hint_->setText(tr("Enter the address and port to listen on, such as 127.0.0.1:3490."));
  } else if (key_missing) {
    hint_->setText(tr("Choose the key file that the robot has as well."));
  } else if (scene_missing) {
    hint_->setText(tr("Choose the scene file."));
  } else {
    hint_->setText(tr("The session starts anew; parameters and tare stay. Motors stay off until you arm."));
  }
  reconnect_->setEnabled(hindrance_.isEmpty() && !address_missing && !key_missing && !scene_missing);
}

void RobotForm::chooseFile(const QString& title, const QString& filter, QLineEdit* into) {
  auto* dialog = new QFileDialog(this, title, asEntered(into->text()), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setModal(false);  // nothing is modal while a device can move
  connect(dialog, &QFileDialog::fileSelected, into, &QLineEdit::setText);
  dialog->show();
}

}  // namespace fyd::widgets
