#include "app/console/devices/devices_page.h"

#include <QVBoxLayout>
#include <algorithm>

#include "core/device/touchpad/test_motion.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/vertical_scroll.h"
#include "widgets/devices/device_text.h"

namespace fyd::console {
namespace {

using pipeline::SafetyState;
using widgets::kGrid;

constexpr int kRefresh_ms = 200;
constexpr int kKeep_ms = 100;  // the station ends a test 0.5 s after the last call of keepDeviceTest

const QString kTest = QStringLiteral("device test");  // cause of a notice: over when a test begins

QStringList testWords() {
  QStringList out;
  for (std::size_t i = 0; i < device::kPartTests; ++i) {
    out << widgets::deviceWord(phrase(device::kDeviceTestNames[i]));
  }
  return out;
}

}  // namespace

DevicesPage::DevicesPage(const PageContext& context, QWidget* parent)
    : Page(parent), context_(context), found_(new widgets::FoundList(this)), form_(new widgets::ConnectionForm(this)) {
  build();
  connectForm();
  setSearch(DeviceSearch::ofThisComputer());
  timer_.setInterval(kRefresh_ms);
  connect(&timer_, &QTimer::timeout, this, &DevicesPage::refresh);
  hold_timer_.setInterval(kKeep_ms);
  connect(&hold_timer_, &QTimer::timeout, this, &DevicesPage::holdOn);
  connect(&context_.feed, &SessionFeed::telemetry, this,
          [this](std::span<const pipeline::TelemetrySample> samples) { state_ = samples.back().state; });
  connect(&context_.feed, &SessionFeed::silent, this, [this](bool silent) { silent_ = silent; });
  connect(found_, &widgets::FoundList::lookAsked, this, [this] { search_->look(); });
}

void DevicesPage::build() {
  auto* scroll = widgets::makeVerticalScroll(this);
  auto* body = new QWidget(scroll);
  row_ = new QHBoxLayout(body);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(kGrid);
  empty_ =
      new QLabel(tr("The session has no devices: it is closed. Choose them beside this, and press Connect."), body);
  empty_->setProperty("role", "muted");
  empty_->setWordWrap(true);
  row_->addWidget(empty_, 1, Qt::AlignTop);
  scroll->setWidget(body);
  auto* side = widgets::makeVerticalScroll(this);
  auto* column_body = new QWidget(side);
  auto* column = new QVBoxLayout(column_body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid);
  column->addWidget(form_);
  column->addWidget(found_, 1);
  side->setWidget(column_body);
  auto* edge = new QWidget(this);
  edge->setFixedWidth(34 * kGrid);
  auto* edge_layout = new QVBoxLayout(edge);
  edge_layout->setContentsMargins(0, 0, 0, 0);
  edge_layout->setSpacing(kGrid);
  edge_layout->addWidget(side, 1);
  edge_layout->addWidget(form_->foot());  // at the lower edge, whatever is chosen or said above it
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(scroll, 1);
  layout->addWidget(edge);
}

void DevicesPage::connectForm() {
  connect(form_, &widgets::ConnectionForm::connectAsked, this, [this] {
    const widgets::ChosenDevices chosen = form_->devices();
    ConnectionWords wanted = context_.connection.present();
    wanted.touchpad = chosen.touchpad.toStdString();
    wanted.motors = chosen.motors.toStdString();
    wanted.camera = chosen.camera.toStdString();
    context_.connection.change(wanted);
  });
  connect(form_, &widgets::ConnectionForm::cancelAsked, &context_.connection, &ConnectionChange::cancel);
  connect(form_, &widgets::ConnectionForm::robotAsked, this, &DevicesPage::robotAsked);
  connect(found_, &widgets::FoundList::useAsked, this, &DevicesPage::use);
  const auto show_words = [this](const ConnectionWords& words) {
    form_->setDevices({.touchpad = QString::fromStdString(words.touchpad),
                       .motors = QString::fromStdString(words.motors),
                       .camera = QString::fromStdString(words.camera)});
    form_->setRobot(QString::fromStdString(words.robot));
  };
  connect(&context_.connection, &ConnectionChange::arrived, this, show_words);
  connect(&context_.connection, &ConnectionChange::refreshed, this, &DevicesPage::showConnection);
  show_words(context_.connection.present());
  showConnection();
}

void DevicesPage::showConnection() {
  form_->setHindrance(context_.connection.hindrance());
  form_->setWork(context_.connection.work(), context_.connection.canBeCancelled());
  const auto problem = [this](device::Part part) {
    for (const station::ConnectionProblem& each : context_.connection.problems()) {
      if (each.part == part) return widgets::deviceWord(each.message);
    }
    return QString();
  };
  form_->touchpad()->setProblem(problem(device::Part::touchpad));
  form_->motors()->setProblem(problem(device::Part::motor_board));
  form_->camera()->setProblem(problem(device::Part::camera));
}

void DevicesPage::showFound(const std::vector<widgets::FoundRow>& rows) {
  QStringList ports;
  QStringList cameras;
  for (const widgets::FoundRow& row : rows) {
    const bool camera = std::ranges::find(row.uses, widgets::FoundRow::Use::camera) != row.uses.end();
    if (!row.uses.empty()) (camera ? cameras : ports) << row.path;
  }
  found_->setFound(rows);
  form_->offer(ports, cameras);
}

void DevicesPage::use(widgets::FoundRow::Use as, const QString& path) {
  switch (as) {
    case widgets::FoundRow::Use::touchpad: form_->touchpad()->setWord(QStringLiteral("modbus-rtu:") + path); break;
    case widgets::FoundRow::Use::motors: form_->motors()->setWord(QStringLiteral("qbmove:") + path); break;
    case widgets::FoundRow::Use::camera: form_->camera()->setWord(path); break;
  }
}

void DevicesPage::setSearch(std::vector<DeviceSearch::Step> steps) {
  delete search_;
  search_ = new DeviceSearch(std::move(steps), this);
  connect(search_, &DeviceSearch::progressed, found_, &widgets::FoundList::showProgress);
  connect(search_, &DeviceSearch::found, this, &DevicesPage::showFound);
}

void DevicesPage::addCommands(PlaceCommands& commands) {
  commands.add({"devices.look", QT_TRANSLATE_NOOP("Commands", "Devices"), QT_TRANSLATE_NOOP("Commands", "Look again"),
                "search", "F5"},
               [this](bool) { search_->look(); });
}

void DevicesPage::enter() {
  refresh();
  timer_.start();
  if (!looked_) search_->look();
  looked_ = true;
}

void DevicesPage::leave() {
  timer_.stop();
  endTest();
}

void DevicesPage::refresh() {
  const std::vector<device::DeviceReport> reports = context_.session.devices();
  while (cards_.size() < reports.size()) cards_.push_back(addCard());
  shown_ = reports.size();
  empty_->setVisible(reports.empty());
  // The motors have a board of their own, or are the touchpad's.
  widgets::DeviceCard* tested = nullptr;
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    cards_[i]->setVisible(i < reports.size());
    if (i >= reports.size()) continue;
    cards_[i]->setReport(reports[i]);
    if (reports[i].part == device::Part::motor_board ||
        (tested == nullptr && reports[i].part == device::Part::touchpad))
      tested = cards_[i];
  }
  if (tested != tested_) moveTests(tested);
  showTests();
}

void DevicesPage::moveTests(widgets::DeviceCard* card) {
  if (tested_ != nullptr) {
    endTest();
    tested_->setTests({});
  }
  tested_ = card;
  if (tested_ != nullptr) tested_->setTests(testWords());
}

void DevicesPage::endTest() {
  hold_timer_.stop();
  context_.session.stopDeviceTest();
}

widgets::DeviceCard* DevicesPage::addCard() {
  auto* card = new widgets::DeviceCard(this);
  card->setMinimumWidth(34 * kGrid);
  row_->insertWidget(row_->count() - 1, card, 1);
  connect(card, &widgets::DeviceCard::testHeld, this, &DevicesPage::startTest);
  connect(card, &widgets::DeviceCard::testLetGo, this, [this] {
    endTest();
    showTests();
  });
  return card;
}

void DevicesPage::showTests() {
  if (tested_ == nullptr) return;
  const station::DeviceTestStatus status = context_.session.deviceTestStatus();
  const bool free =
      !silent_ && (state_ == SafetyState::connected || state_ == SafetyState::ready || state_ == SafetyState::stopped);
  tested_->allowTests(free, state_ == SafetyState::disconnected ? tr("A test needs motors that answer.")
                                                                : tr("Only while nothing renders: press Esc first."));
  if (!free || status.words.empty() || static_cast<std::size_t>(status.test) >= device::kPartTests) {
    tested_->showTest({});
    return;
  }
  const QString name = testWords().value(static_cast<int>(status.test));
  tested_->showTest(status.running
                        ? tr("%1: %2 %").arg(name).arg(100.0 * std::clamp(status.progress, 0.0, 1.0), 0, 'f', 0)
                        : tr("%1: %2.").arg(name, widgets::deviceWord(status.words)));
}

void DevicesPage::startTest(int test) {
  if (const auto started = context_.session.startDeviceTest(static_cast<device::DeviceTest>(test), 0.0); !started) {
    context_.tell_about(kTest, widgets::Severity::warning,
                        widgets::deviceWord(started.error().message) + QLatin1Char('.'));
    return;
  }
  context_.over(kTest);
  hold_timer_.start();
  showTests();
}

void DevicesPage::holdOn() {
  for (int i = 0; i < testWords().size(); ++i) {
    if (!tested_->testButton(i)->engaged()) continue;
    context_.session.keepDeviceTest();
    return;
  }
  hold_timer_.stop();
}

}  // namespace fyd::console
