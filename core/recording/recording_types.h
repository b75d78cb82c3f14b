// What a recording holds, as plain values: written by RecordingWriter, read by Recording.
// Stability: stable since 0.1
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/base/time.h"
#include "core/pipeline/arithmetic.h"
#include "core/pipeline/outputs.h"
#include "core/sensing/finger_types.h"

namespace fyd::recording {

/// Pictures to go back for a whole one, at most: the recorder writes one so often, the reader looks so far.
inline constexpr std::uint64_t kFarthestWhole = 1'000;

/// Rows that `recover` could not read of the original.
struct MissingRows {
  std::string table;        ///< its path; "/header": the header's texts, of which any may be wrong
  std::uint64_t first = 0;  ///< row of /telemetry; of notes, link and pictures: row of the table itself
  /// Of /telemetry, notes, link and pictures: rows that are gone just before `first`. Of other tables: steps from
  /// `first` on that are there, but without what the table held for them.
  std::uint64_t count = 0;
  std::string why;
  bool operator==(const MissingRows&) const = default;
};

/// What a late computer did to a session: everything was simulated and the clock waited, or it was a fault.
inline constexpr const char* kLatenessWaits = "waits";
inline constexpr const char* kLatenessFault = "fault";

/// What is known when a recording starts.
struct RecordingHeader {
  std::string id;           ///< random and so globally unique: 32 hexadecimal digits
  std::string started_utc;  ///< ISO 8601 with milliseconds, of the recording's start
  Instant started{};        ///< the same moment on the station's clock: time 0 of the recording
  std::string operator_name;
  std::string subject;  ///< code, never a name
  std::string notes;
  std::vector<std::string> tags;
  std::string touchpad;  ///< as in the station's options
  std::string camera;
  std::string robot;
  std::string profile;                       ///< TOML, the whole station's, as it was at the first row
  std::string surface;                       ///< TOML of the stored surface; empty: none
  std::shared_ptr<const std::string> scene;  ///< virtual, in the robot's place, as CBOR; null: none
  std::string step_state;                    ///< Pipeline::saveState before the first row
  std::string version;                       ///< of the program that records
  std::string lateness;                      ///< of the computer: kLatenessWaits, kLatenessFault; empty: not recorded
  std::vector<MissingRows> missing;          ///< of a recovered recording only
  /// As in RecordingInfo::missing_columns: what the one had not that this one was copied from, and so was never recorded.
  std::vector<std::string> lacking;
  int arithmetic = pipeline::kArithmetic;  ///< of the step that was recorded
};

/// One picture: its region of interest without loss, as the detector saw it; of some also the whole, compressed.
struct EncodedPicture {
  Instant taken{};
  std::uint64_t number = 0;          ///< the camera's
  std::vector<std::uint8_t> whole;   ///< JPEG; empty: an earlier picture shows what lies around the region
  std::vector<std::uint8_t> region;  ///< PNG, without loss; empty when the region lies outside the picture
  cv::Rect region_px;                ///< of interest, in the whole picture
  sensing::FingerDetection finger;
};

/// A line of the recording's own log: an operator's note, a bookmark, a trial's marker, a condition of the recorder.
enum class NoteKind : std::uint8_t { note = 0, bookmark = 1, trial_start = 2, trial_end = 3, alarm = 4 };
struct Note {
  Instant when{};
  NoteKind kind = NoteKind::note;
  std::string text;
};

/// The robot's link and the loop once a second: figures that are no input of the step.
struct LinkRow {
  Instant when{};
  double round_trip_ms = pipeline::kNone;
  double jitter_ms = pipeline::kNone;
  double loss_percent = pipeline::kNone;
  std::uint64_t states_received = 0;
  std::uint64_t touches_sent = 0;
  std::uint64_t refused = 0;

  static constexpr auto fields() {
    using L = LinkRow;
    return std::tuple(Field("when_ns", "ns", "when it was asked", &L::when),
                      Field("round_trip_ms", "ms", "to the robot and back", &L::round_trip_ms),
                      Field("jitter_ms", "ms", "how much the way here varies", &L::jitter_ms),
                      Field("loss_percent", "%", "messages of the robot's that did not come", &L::loss_percent),
                      Field("states_received", "1", "messages that came, since the start", &L::states_received),
                      Field("touches_sent", "1", "messages sent, since the start", &L::touches_sent),
                      Field("refused", "1", "messages that came and were not taken, since the start", &L::refused));
  }
};

struct EventRow {
  Instant when{};
  pipeline::Event event;

  static constexpr auto fields() {
    return std::tuple_cat(std::tuple(Field("when_ns", "ns", "of the step", &EventRow::when)),
                          part<pipeline::Event>(&EventRow::event));
  }
};

}  // namespace fyd::recording
