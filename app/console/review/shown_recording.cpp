#include "app/console/review/shown_recording.h"

namespace fyd::console {

Result<std::unique_ptr<recording::Recording>> ShownRecording::open() const {
  auto opened = recording::Recording::open(path.toStdString());
  if (opened && (*opened)->info().header.id != id) {
    return fail("{}: another recording has this name now; open it again", path.toStdString());
  }
  return opened;
}

}  // namespace fyd::console
