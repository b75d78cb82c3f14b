// The station's recording: what the operator asks of the recorder, and the words and texts it puts into the file.
#include "core/station/station_impl.h"

namespace fyd::station {

Result<void> Station::startRecording(const session::RecordingRequest& request) {
  return fail("{}: this build does not record", request.path);
}

Result<void> Station::stopRecording() { return fail("nothing is being recorded"); }

void Station::note(session::NoteKind /*kind*/, const std::string& /*text*/) {}

session::RecorderStatus Station::recorderStatus() const { return {}; }

}  // namespace fyd::station
