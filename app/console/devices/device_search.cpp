#include "app/console/devices/device_search.h"

#include <QCoreApplication>
#include <QPointer>

#include "widgets/devices/device_text.h"

namespace fyd::console {

std::vector<DeviceSearch::Step> DeviceSearch::ofThisComputer() {
  using enum widgets::FoundRow::Use;
  return {{tr("Serial port"),
           tr("Looking at serial ports …"),
           [] { return device::findSerialPorts(); },
           {touchpad, motors}},
          {tr("Camera"), tr("Looking at cameras …"), [] { return device::findCaptureDevices(); }, {camera}}};
}

DeviceSearch::DeviceSearch(std::vector<Step> steps, QObject* parent)
    : QObject(parent), steps_(std::make_shared<const std::vector<Step>>(std::move(steps))) {}

DeviceSearch::~DeviceSearch() {
  // A driver may block a search for seconds. The search ends by itself and does not access the window's objects, so the
  // destructor waits no longer than this.
  constexpr unsigned long kPatience_ms = 2000;
  if (thread_ != nullptr) thread_->wait(kPatience_ms);
}

void DeviceSearch::look() {
  if (looking()) return;
  auto rows = std::make_shared<std::vector<widgets::FoundRow>>();
  // Its steps are shared, so that a search that outlives this object still has them.
  thread_ = QThread::create([steps = steps_, rows, self = QPointer<DeviceSearch>(this)] {
    for (std::size_t i = 0; i < steps->size(); ++i) {
      const Step& step = (*steps)[i];
      const double part = static_cast<double>(i) / static_cast<double>(steps->size());
      QMetaObject::invokeMethod(
          qApp,
          [self, doing = step.doing, part] {
            if (self) emit self->progressed(doing, part);
          },
          Qt::QueuedConnection);
      for (const device::FoundDevice& each : step.list()) {
        rows->push_back({.kind = step.kind,
                         .name = QString::fromStdString(each.name),
                         .path = QString::fromStdString(each.path),
                         .problem = widgets::deviceWord(each.problem),
                         .uses = step.uses});
      }
    }
  });
  connect(thread_, &QThread::finished, thread_, &QObject::deleteLater);
  connect(thread_, &QThread::finished, this, [this, rows] {
    thread_ = nullptr;
    emit found(*rows);
  });
  if (!steps_->empty()) emit progressed(steps_->front().doing, 0.0);
  thread_->start();
}

}  // namespace fyd::console
