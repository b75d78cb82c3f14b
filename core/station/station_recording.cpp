// The station's recording: what the operator asks of the recorder, and the words and texts it puts into the file.
#include "core/base/profile_text.h"
#include "core/station/station_impl.h"

namespace fyd::station {

session::StationSource Station::Impl::recorderSource() {
  return {.profile =
              [this](const pipeline::Parameters& step) {
                Profile recorded = profile;
                recorded.step = step;
                return formatProfile(bindParameters(recorded));
              },
          .link = [this]() -> std::optional<session::LinkRow> {
            if (!link) return std::nullopt;
            const LinkStatus status = link->status();
            return session::LinkRow{.when = Clock::now(),
                                    .round_trip_ms = status.figures.round_trip_ms,
                                    .jitter_ms = status.figures.jitter_ms,
                                    .loss_percent = status.figures.loss_percent,
                                    .states_received = status.states_received,
                                    .touches_sent = status.touches_sent,
                                    .refused = status.refused};
          }};
}

Result<void> Station::startRecording(const session::RecordingRequest& request) {
  return impl_->recorder.begin(request);
}

Result<void> Station::stopRecording() { return impl_->recorder.end(); }

Result<void> Station::note(session::NoteKind kind, const std::string& text) { return impl_->recorder.note(kind, text); }

session::RecorderStatus Station::recorderStatus() const { return impl_->recorder.status(); }

}  // namespace fyd::station
