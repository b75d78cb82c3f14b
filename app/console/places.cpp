// The list of the window's places. A new one is a line here.
#include <QCoreApplication>

#include "app/console/calibrate_page.h"
#include "app/console/devices_page.h"
#include "app/console/operate_page.h"
#include "app/console/page.h"
#include "app/console/review_page.h"
#include "app/console/tune_page.h"

namespace fyd::console {
namespace {

template <class T>
Page* make(const PageContext& context, QWidget* parent) {
  return new T(context, parent);
}

}  // namespace

const std::vector<PlaceInfo>& places() {
  static const std::vector<PlaceInfo> kPlaces = {
      {"operate", QT_TRANSLATE_NOOP("Commands", "Operate"), "place-operate", "Ctrl+1", make<OperatePage>},
      {"calibrate", QT_TRANSLATE_NOOP("Commands", "Calibrate"), "place-calibrate", "Ctrl+2", make<CalibratePage>},
      {"review", QT_TRANSLATE_NOOP("Commands", "Review"), "place-review", "Ctrl+3", make<ReviewPage>},
      {"devices", QT_TRANSLATE_NOOP("Commands", "Devices"), "place-devices", "Ctrl+5", make<DevicesPage>},
      {"tune", QT_TRANSLATE_NOOP("Commands", "Tune"), "place-tune", "Ctrl+6", make<TunePage>},
  };
  return kPlaces;
}

}  // namespace fyd::console
