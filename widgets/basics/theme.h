// The look of the application: every colour, distance and font size is defined here.
//
// One quantity has one colour everywhere; the set is colour-blind-safe (after Okabe and Ito), lightened on dark and
// darkened on light backgrounds. Red means stop and limits only, amber stale or near a limit only, grey no data.
#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>
#include <QString>
#include <optional>

class QApplication;
class QWidget;

namespace fyd::widgets {

enum class ThemeChoice { dark, light, system };
/// As options and the file write it: "dark", "light", "system".
[[nodiscard]] QString themeWord(ThemeChoice choice);
[[nodiscard]] std::optional<ThemeChoice> themeOf(const QString& word);

/// What a curve, a readout or a slider stands for.
enum class Quantity { force, indentation, stiffness, vibration, acceleration_x, acceleration_y, acceleration_z, none };

struct Theme {
  bool dark = true;
  QColor window;   ///< background
  QColor panel;    ///< panels on the background
  QColor raised;   ///< buttons, fields
  QColor line;     ///< borders, grid
  QColor text;     ///< words and numbers
  QColor muted;    ///< labels, units, no data
  QColor accent;   ///< focus, progress
  QColor live;     ///< rendering, normal state
  QColor warning;  ///< stale, near a limit
  QColor danger;   ///< stop, limits
  QColor on_danger;
  QColor force, indentation, stiffness, vibration, acceleration_x, acceleration_y, acceleration_z;

  [[nodiscard]] QColor of(Quantity quantity) const;
  [[nodiscard]] QPalette palette() const;
};

inline constexpr int kGrid = 8;  ///< px; every distance is a multiple or half of it

/// Sizes of the one font, as multiples of the application's.
enum class TextSize { small, normal, title, number };
[[nodiscard]] QFont textFont(TextSize size, bool strong = false);

/// Applies a theme to the application and notifies widgets that paint themselves. Lives on the window's thread.
class Look : public QObject {
  Q_OBJECT
 public:
  static Look& instance();
  [[nodiscard]] const Theme& theme() const { return theme_; }
  [[nodiscard]] ThemeChoice choice() const { return choice_; }
  void apply(QApplication& application, ThemeChoice choice);

 signals:
  void changed();

 private:
  Look();
  Theme theme_;
  ThemeChoice choice_ = ThemeChoice::dark;
  bool system_is_dark_ = false;
  bool system_asked_ = false;
};

/// To be called after a property that the style sheet uses has changed.
void restyle(QWidget& widget);

[[nodiscard]] inline const Theme& theme() { return Look::instance().theme(); }

}  // namespace fyd::widgets
