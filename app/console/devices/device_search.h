// Searches for connected devices, as `fyd devices` does, on its own thread: opening a port can take seconds, and the
// window stays responsive meanwhile.
#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "core/device/device_list.h"
#include "widgets/devices/found_list.h"

namespace fyd::console {

class DeviceSearch : public QObject {
  Q_OBJECT
 public:
  /// One kind of device and how it is listed.
  struct Step {
    QString kind;   ///< "Serial port"
    QString doing;  ///< "Looking at serial ports …"
    std::function<std::vector<device::FoundDevice>()> list;
    std::vector<widgets::FoundRow::Use> uses = {};  ///< what each of them can be to the session
  };
  /// Serial ports and capture devices of this computer.
  [[nodiscard]] static std::vector<Step> ofThisComputer();

  explicit DeviceSearch(std::vector<Step> steps, QObject* parent = nullptr);
  ~DeviceSearch() override;

  /// Nothing happens while a search is under way.
  void look();
  [[nodiscard]] bool looking() const { return thread_ != nullptr; }

 signals:
  void progressed(const QString& what, double part);
  void found(const std::vector<fyd::widgets::FoundRow>& rows);

 private:
  std::shared_ptr<const std::vector<Step>> steps_;
  QThread* thread_ = nullptr;
};

}  // namespace fyd::console
