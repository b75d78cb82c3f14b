// What the window remembers from one start to the next: devices, place and size, panels, page, theme, language, named
// layouts. The devices stand in for those that the user's own profile names; options of the command line go before both.
// A file that is damaged, foreign or not writable is harmless: every value read is checked, and the default replaces a
// missing one.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <optional>

#include "app/console/shell/session.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

/// Beside the profile.
[[nodiscard]] QString memoryFile(const QString& profile_path);

/// Positions of all panels of the window, as opaque Qt state, and which curves are shown.
struct Layout {
  QByteArray window;         ///< QMainWindow::saveState
  QByteArray operate;        ///< of the panels around the curves
  QByteArray curves;         ///< the place "Operate"'s, as CurveTools::choice gives them
  QByteArray review_curves;  ///< the place "Review"'s
  bool operator==(const Layout&) const = default;
};

class WindowMemory {
 public:
  /// @param file empty: nothing is remembered, as for screenshots of the standard window
  explicit WindowMemory(QString file) : file_(std::move(file)) {}

  [[nodiscard]] QString language() const { return text(QStringLiteral("language")); }
  [[nodiscard]] std::optional<widgets::ThemeChoice> theme() const {
    return widgets::themeOf(text(QStringLiteral("theme")));
  }
  [[nodiscard]] QString page() const { return text(QStringLiteral("page")); }
  [[nodiscard]] QByteArray geometry() const { return bytes(QStringLiteral("geometry")); }
  [[nodiscard]] Layout layout() const { return layoutAt(QStringLiteral("layout")); }
  /// Last connected in the window; none: never.
  [[nodiscard]] std::optional<ConnectionWords> devices() const;
  /// Whether the first steps are done with: dismissed, or gone to the end.
  [[nodiscard]] bool firstStepsOver() const { return text(QStringLiteral("first_steps")) == QStringLiteral("over"); }
  void setDevices(const ConnectionWords& words);
  void setFirstStepsOver() { put(QStringLiteral("first_steps"), QStringLiteral("over")); }
  /// @return false when it could not be written
  [[nodiscard]] bool setLanguage(const QString& code) { return put(QStringLiteral("language"), code); }
  void setTheme(widgets::ThemeChoice choice) { put(QStringLiteral("theme"), widgets::themeWord(choice)); }
  void setPage(const QString& page) { put(QStringLiteral("page"), page); }
  void setGeometry(const QByteArray& geometry) { put(QStringLiteral("geometry"), geometry); }
  void setLayout(const Layout& layout) { putLayout(QStringLiteral("layout"), layout); }

  /// Named layouts, in the order of their names.
  [[nodiscard]] QStringList layoutNames() const;
  [[nodiscard]] std::optional<Layout> namedLayout(const QString& name) const;
  /// Replaces a layout of this name. @return false when it could not be written
  [[nodiscard]] bool keepLayout(const QString& name, const Layout& layout);
  /// @return false when the file could not be written
  [[nodiscard]] bool forgetLayout(const QString& name);

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
