#include "widgets/status/recording_view.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "core/recording/writer/recorder_types.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::widgets {
namespace {

using Field = EntryProblem::Field;

constexpr int kLongestName = 80;
constexpr int kLongestTag = 32;
constexpr int kMostTags = 16;
constexpr int kLongestNotes = 2000;

bool hasControlCharacter(const QString& text) {
  return std::any_of(text.begin(), text.end(), [](QChar c) { return c.category() == QChar::Other_Control; });
}

QString fileProblem(const QString& file) {
  if (file.isEmpty()) return tr("File: where is the recording to go?");
  const QFileInfo info(file);
  if (info.isRelative()) return tr("File %1: expected a whole path, from / on.").arg(file);
  if (info.suffix() != QLatin1String("h5") || info.completeBaseName().isEmpty()) {
    return tr("File %1: expected a name that ends in .h5.").arg(info.fileName());
  }
  if (info.exists()) return tr("File %1: it is there already; a recording is never written over.").arg(info.fileName());
  return {};
}

}  // namespace

EntryProblem checkEntries(const RecordingEntries& entries) {
  const QString who = entries.operator_name.trimmed();
  if (who.isEmpty()) return {Field::operator_name, tr("Operator: who operates? A name or initials.")};
  if (who.size() > kLongestName || hasControlCharacter(who)) {
    return {Field::operator_name, tr("Operator: expected one line of at most %1 characters.").arg(kLongestName)};
  }
  if (!recording::isSubjectCode(entries.subject.toStdString())) {
    return {Field::subject,
            tr("Subject: expected a code of letters, digits, - and _ such as S07, at most %1 characters; never a name.")
                .arg(recording::kLongestSubject)};
  }
  if (entries.tags.size() > kMostTags) {
    return {Field::tags, tr("Tags: %1 are too many; at most %2.").arg(entries.tags.size()).arg(kMostTags)};
  }
  for (const QString& tag : entries.tags) {
    if (tag.size() > kLongestTag || hasControlCharacter(tag)) {
      return {Field::tags, tr("Tag \"%1\": expected at most %2 characters.").arg(tag.left(20)).arg(kLongestTag)};
    }
  }
  if (entries.notes.size() > kLongestNotes) {
    return {Field::notes,
            tr("Notes: %1 characters are too many; at most %2.").arg(entries.notes.size()).arg(kLongestNotes)};
  }
  const QString file = fileProblem(entries.file);
  return {file.isEmpty() ? Field::none : Field::file, file};
}

QStringList readTags(const QString& text) {
  QStringList out;
  for (const QString& each : text.split(QLatin1Char(','))) {
    const QString tag = each.simplified();
    if (!tag.isEmpty() && !out.contains(tag)) out << tag;
  }
  return out;
}

QString clockText(double seconds) {
  const auto whole = static_cast<qint64>(seconds > 0.0 ? std::min(seconds, 1e9) : 0.0);
  return QStringLiteral("%1:%2:%3")
      .arg(whole / 3600, 2, 10, QLatin1Char('0'))
      .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
      .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString bytesText(std::uint64_t bytes) {
  const auto amount = static_cast<double>(bytes);
  if (amount < 1e6) return tr("%1 kB").arg(numberText(amount / 1e3, 0));
  if (amount < 1e9) return tr("%1 MB").arg(numberText(amount / 1e6, 1));
  return tr("%1 GB").arg(numberText(amount / 1e9, 2));
}

QString timeLeftText(double minutes) {
  if (!std::isfinite(minutes)) return {};
  if (minutes < 1.0) return tr("under 1 min left");
  if (minutes < 120.0) return tr("%1 min left").arg(numberText(std::floor(minutes), 0));
  if (minutes < 100.0 * 60.0) return tr("%1 h left").arg(numberText(std::floor(minutes / 60.0), 0));
  return tr("days left");
}

}  // namespace fyd::widgets
