// A recording as the window shows it and as an operator asks for it: figures, entries, what is wrong with an entry.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <limits>

namespace fyd::widgets {

struct RecordingView {
  enum class State { idle, recording, failed };
  State state = State::idle;
  QString file;
  QString problem;  ///< failed: what happened, what is safe, what to do
  double seconds = 0.0;
  std::uint64_t bytes = 0;
  double minutes_left = std::numeric_limits<double>::quiet_NaN();  ///< until the disk is full; NaN: not known yet
  std::uint64_t lost = 0;                                          ///< samples that are not in the file
};

struct RecordingEntries {
  QString operator_name;
  QString subject;
  QString notes;
  QStringList tags;
  QString file;
};

/// Which entry is invalid, and what is expected.
struct EntryProblem {
  enum class Field { none, operator_name, subject, tags, notes, file };
  Field field = Field::none;
  QString words;
};

/// The first invalid entry. Accesses the disk only to find a file that exists already.
[[nodiscard]] EntryProblem checkEntries(const RecordingEntries& entries);

/// "pilot, left hand" to its tags, without empty ones and repetitions.
[[nodiscard]] QStringList readTags(const QString& text);

/// "00:12:31"; more than 99 hours go on counting.
[[nodiscard]] QString clockText(double seconds);
/// "640 kB", "24.1 MB", "1.25 GB"
[[nodiscard]] QString bytesText(std::uint64_t bytes);
/// "41 min left", "6 h left", "under 1 min left"; empty while it is not known
[[nodiscard]] QString timeLeftText(double minutes);

}  // namespace fyd::widgets
