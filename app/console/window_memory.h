// What the window remembers from one start to the next: place and size, panels, page, theme, language, named layouts.
// A file that is damaged, foreign or not writable costs only the memory: every value read is checked, and a missing one
// is the standard.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>

#include "widgets/theme.h"

namespace fyd::console {

/// As options and the file write it: "dark", "light", "system".
[[nodiscard]] QString themeWord(widgets::ThemeChoice choice);
[[nodiscard]] std::optional<widgets::ThemeChoice> themeOf(const QString& word);

/// Beside the profile.
[[nodiscard]] QString memoryFile(const QString& profile_path);

/// Where all of the window's panels are, as opaque words of Qt, and which curves are shown.
struct Layout {
  QByteArray window;         ///< QMainWindow::saveState
  QByteArray operate;        ///< of the panels around the curves
  QByteArray curves;         ///< the place "Operate"'s, as CurveTools::choice gives them
  QByteArray review_curves;  ///< the place "Review"'s
  bool operator==(const Layout&) const = default;
};

class WindowMemory {
 public:
  /// @param file empty: nothing is remembered, as for pictures of the standard window
  explicit WindowMemory(QString file) : file_(std::move(file)) {}

  [[nodiscard]] QString language() const { return text(QStringLiteral("language")); }
  [[nodiscard]] std::optional<widgets::ThemeChoice> theme() const { return themeOf(text(QStringLiteral("theme"))); }
  [[nodiscard]] QString page() const { return text(QStringLiteral("page")); }
  [[nodiscard]] QByteArray geometry() const { return bytes(QStringLiteral("geometry")); }
  [[nodiscard]] Layout layout() const { return layoutAt(QStringLiteral("layout")); }
  void setLanguage(const QString& code) { put(QStringLiteral("language"), code); }
  void setTheme(widgets::ThemeChoice choice) { put(QStringLiteral("theme"), themeWord(choice)); }
  void setPage(const QString& page) { put(QStringLiteral("page"), page); }
  void setGeometry(const QByteArray& geometry) { put(QStringLiteral("geometry"), geometry); }
  void setLayout(const Layout& layout) { putLayout(QStringLiteral("layout"), layout); }

  /// Named layouts, in the order of their names.
  [[nodiscard]] QStringList layoutNames() const;
  [[nodiscard]] std::optional<Layout> namedLayout(const QString& name) const;
  /// Over a former one of this name. @return false when it could not be written
  [[nodiscard]] bool keepLayout(const QString& name, const Layout& layout);
  void forgetLayout(const QString& name);

  static constexpr qsizetype kLongestName = 40;

 private:
  [[nodiscard]] QString text(const QString& key) const;
  [[nodiscard]] QByteArray bytes(const QString& key) const;
  [[nodiscard]] Layout layoutAt(const QString& group) const;
  bool put(const QString& key, const QVariant& value);
  bool putLayout(const QString& group, const Layout& layout);

  QString file_;
};

}  // namespace fyd::console
