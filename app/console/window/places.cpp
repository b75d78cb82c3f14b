#include "app/console/window/places.h"

#include <QCoreApplication>

#include "app/console/calibrate/calibrate_page.h"
#include "app/console/devices/devices_page.h"
#include "app/console/operate/operate_page.h"
#include "app/console/review/review_page.h"
#include "app/console/tune/tune_page.h"

namespace fyd::console {
namespace {

template <class T>
Page* make(const PageContext& context, QWidget* parent) {
  return new T(context, parent);
}

}  // namespace

// To add a place, add a line here.
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

QStringList placeNames() {
  QStringList names;
  for (const PlaceInfo& place : places()) names << QLatin1String(place.id);
  return names;
}

}  // namespace fyd::console
