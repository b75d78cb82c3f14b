#include "app/console/window/window_memory.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace fyd::console {
namespace {

constexpr qsizetype kMostBytes = qsizetype{64} * 1024;  // Qt's saved state has some hundred bytes

/// A name may hold any character; a key of the file may not.
QString groupOf(const QString& name) { return QStringLiteral("layouts/") + QString::fromLatin1(name.toUtf8().toHex()); }

/// A part's words and where they are kept.
struct KeptWord {
  const char* key;
  std::string ConnectionWords::*word;
};
constexpr KeptWord kDevices[] = {{"devices/touchpad", &ConnectionWords::touchpad},
                                 {"devices/motors", &ConnectionWords::motors},
                                 {"devices/camera", &ConnectionWords::camera},
                                 {"devices/robot", &ConnectionWords::robot},
                                 {"devices/key_file", &ConnectionWords::key_file}};

}  // namespace

QString memoryFile(const QString& profile_path) {
  const QFileInfo file(QFileInfo(profile_path).absolutePath() + QStringLiteral("/window.ini"));
  if (file.exists() && !file.isFile()) return {};  // a pipe or a device is neither read nor written
  return file.filePath();
}

std::optional<ConnectionWords> WindowMemory::devices() const {
  ConnectionWords words;
  for (const auto& [key, word] : kDevices) words.*word = text(QLatin1String(key)).toStdString();
  if (words.touchpad.empty() || words.robot.empty()) return std::nullopt;
  return words;
}

void WindowMemory::setDevices(const ConnectionWords& words) {
  for (const auto& [key, word] : kDevices) put(QLatin1String(key), QString::fromStdString(words.*word));
}

QStringList WindowMemory::layoutNames() const {
  if (file_.isEmpty()) return {};
  QSettings kept(file_, QSettings::IniFormat);
  kept.beginGroup(QStringLiteral("layouts"));
  QStringList names;
  for (const QString& group : kept.childGroups()) {
    const QString name = QString::fromUtf8(QByteArray::fromHex(group.toLatin1()));
    const bool good = !name.trimmed().isEmpty() && name.size() <= kLongestName;
    if (good && groupOf(name).endsWith(group)) names << name;
  }
  std::ranges::sort(names, [](const QString& a, const QString& b) { return a.localeAwareCompare(b) < 0; });
  return names;
}

std::optional<Layout> WindowMemory::namedLayout(const QString& name) const {
  if (!layoutNames().contains(name)) return std::nullopt;
  return layoutAt(groupOf(name));
}

bool WindowMemory::keepLayout(const QString& name, const Layout& layout) { return putLayout(groupOf(name), layout); }

bool WindowMemory::forgetLayout(const QString& name) {
  if (file_.isEmpty()) return false;
  QSettings kept(file_, QSettings::IniFormat);
  kept.remove(groupOf(name));
  kept.sync();
  return kept.status() == QSettings::NoError;
}

QString WindowMemory::text(const QString& key) const {
  return file_.isEmpty() ? QString() : QSettings(file_, QSettings::IniFormat).value(key).toString();
}

QByteArray WindowMemory::bytes(const QString& key) const {
  if (file_.isEmpty()) return {};
  const QByteArray read = QSettings(file_, QSettings::IniFormat).value(key).toByteArray();
  return read.size() <= kMostBytes ? read : QByteArray();
}

Layout WindowMemory::layoutAt(const QString& group) const {
  return {.window = bytes(group + QStringLiteral("/window")),
          .operate = bytes(group + QStringLiteral("/operate")),
          .curves = bytes(group + QStringLiteral("/curves")),
          .review_curves = bytes(group + QStringLiteral("/review_curves"))};
}

bool WindowMemory::put(const QString& key, const QVariant& value) {
  if (file_.isEmpty()) return false;
  QSettings kept(file_, QSettings::IniFormat);
  kept.setValue(key, value);
  kept.sync();
  return kept.status() == QSettings::NoError;
}

bool WindowMemory::putLayout(const QString& group, const Layout& layout) {
  return put(group + QStringLiteral("/window"), layout.window) &&
         put(group + QStringLiteral("/operate"), layout.operate) &&
         put(group + QStringLiteral("/curves"), layout.curves) &&
         put(group + QStringLiteral("/review_curves"), layout.review_curves);
}

}  // namespace fyd::console
