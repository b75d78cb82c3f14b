// The places of the window, as the navigation bar lists them.
#pragma once

#include <QStringList>
#include <vector>

#include "app/console/shell/page.h"

namespace fyd::console {

/// One entry of the navigation bar.
struct PlaceInfo {
  const char* id;    ///< "devices", of --page; its command is "place.devices"
  const char* word;  ///< name below the icon
  const char* icon;
  const char* keys;
  Page* (*make)(const PageContext& context, QWidget* parent);
};

/// In the order of the navigation bar.
[[nodiscard]] const std::vector<PlaceInfo>& places();

/// Their ids: what --page may name.
[[nodiscard]] QStringList placeNames();

}  // namespace fyd::console
