#include "widgets/basics/theme.h"

#include <QApplication>
#include <QFile>
#include <QStyle>
#include <QStyleFactory>
#include <QWidget>

namespace fyd::widgets {
namespace {

constexpr const char* kThemeWords[] = {"dark", "light", "system"};  // in the enum's order

Theme darkTheme() {
  Theme t;
  t.dark = true;
  t.window = QColor(0x12, 0x15, 0x18);
  t.panel = QColor(0x1a, 0x1e, 0x22);
  t.raised = QColor(0x27, 0x2d, 0x33);
  t.line = QColor(0x38, 0x40, 0x48);
  t.text = QColor(0xe9, 0xed, 0xf0);
  t.muted = QColor(0x9c, 0xa7, 0xb1);
  t.accent = QColor(0xc3, 0xcf, 0xda);
  t.live = QColor(0x9b, 0xd6, 0x5a);
  t.warning = QColor(0xf2, 0xa5, 0x3a);
  t.danger = QColor(0xd3, 0x2f, 0x3a);
  t.on_danger = QColor(0xff, 0xff, 0xff);
  t.force = QColor(0x56, 0xb4, 0xe9);
  t.indentation = QColor(0xe0, 0x92, 0xbe);
  t.stiffness = QColor(0x1f, 0xc4, 0x92);
  t.vibration = QColor(0xf0, 0xe4, 0x42);
  t.acceleration_x = QColor(0x8a, 0xa8, 0xff);
  t.acceleration_y = QColor(0xe6, 0xe6, 0xe6);
  t.acceleration_z = QColor(0xc9, 0x9b, 0x6d);
  return t;
}

Theme lightTheme() {
  Theme t;
  t.dark = false;
  t.window = QColor(0xee, 0xf0, 0xf2);
  t.panel = QColor(0xff, 0xff, 0xff);
  t.raised = QColor(0xe6, 0xe9, 0xec);
  t.line = QColor(0xc9, 0xcf, 0xd5);
  t.text = QColor(0x14, 0x18, 0x1c);
  t.muted = QColor(0x55, 0x60, 0x6a);
  t.accent = QColor(0x3b, 0x4a, 0x58);
  t.live = QColor(0x3d, 0x76, 0x0b);
  t.warning = QColor(0xa8, 0x5f, 0x00);
  t.danger = QColor(0xc6, 0x20, 0x2c);
  t.on_danger = QColor(0xff, 0xff, 0xff);
  t.force = QColor(0x00, 0x72, 0xb2);
  t.indentation = QColor(0xa3, 0x3d, 0x7d);
  t.stiffness = QColor(0x00, 0x7a, 0x58);
  t.vibration = QColor(0x7d, 0x6c, 0x00);
  t.acceleration_x = QColor(0x3f, 0x51, 0xb5);
  t.acceleration_y = QColor(0x40, 0x40, 0x40);
  t.acceleration_z = QColor(0x8d, 0x55, 0x24);
  return t;
}

/// The style sheet names colours as @name; the names are Theme's.
QString fillIn(QString sheet, const Theme& t) {
  const std::pair<const char*, QColor> colours[] = {
      {"@window", t.window},
      {"@panel", t.panel},
      {"@raised", t.raised},
      {"@line", t.line},
      {"@text", t.text},
      {"@muted", t.muted},
      {"@accent", t.accent},
      {"@live", t.live},
      {"@warning", t.warning},
      {"@danger", t.danger},
      {"@on_danger", t.on_danger},
      {"@force", t.force},
      {"@indentation", t.indentation},
      {"@stiffness", t.stiffness},
      {"@vibration", t.vibration},
  };
  for (const auto& [name, colour] : colours) {
    sheet.replace(QLatin1String(name), colour.name());
  }
  return sheet;
}

}  // namespace

QColor Theme::of(Quantity quantity) const {
  switch (quantity) {
    case Quantity::force: return force;
    case Quantity::indentation: return indentation;
    case Quantity::stiffness: return stiffness;
    case Quantity::vibration: return vibration;
    case Quantity::acceleration_x: return acceleration_x;
    case Quantity::acceleration_y: return acceleration_y;
    case Quantity::acceleration_z: return acceleration_z;
    case Quantity::none: break;
  }
  return muted;
}

QPalette Theme::palette() const {
  QPalette p;
  p.setColor(QPalette::Window, window);
  p.setColor(QPalette::WindowText, text);
  p.setColor(QPalette::Base, panel);
  p.setColor(QPalette::AlternateBase, window);
  p.setColor(QPalette::Text, text);
  p.setColor(QPalette::PlaceholderText, muted);
  p.setColor(QPalette::Button, raised);
  p.setColor(QPalette::ButtonText, text);
  p.setColor(QPalette::BrightText, on_danger);
  p.setColor(QPalette::Highlight, accent);
  p.setColor(QPalette::HighlightedText, window);
  p.setColor(QPalette::ToolTipBase, raised);
  p.setColor(QPalette::ToolTipText, text);
  p.setColor(QPalette::Link, accent);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, muted);
  }
  return p;
}

QFont textFont(TextSize size, bool strong) {
  QFont font = QApplication::font();
  const double base = font.pointSizeF() > 0 ? font.pointSizeF() : 10.0;
  switch (size) {
    case TextSize::small: font.setPointSizeF(base * 0.9); break;
    case TextSize::normal: break;
    case TextSize::title: font.setPointSizeF(base * 1.7); break;
    case TextSize::number: font.setPointSizeF(base * 2.4); break;
  }
  font.setWeight(strong ? QFont::DemiBold : QFont::Normal);
  return font;
}

void restyle(QWidget& widget) {
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
  widget.update();
}

Look& Look::instance() {
  static Look look;
  return look;
}

Look::Look() : theme_(darkTheme()) {}

void Look::apply(QApplication& application, ThemeChoice choice) {
  if (!system_asked_) {
    // Qt 6.4 has no colorScheme(): dark or light is read from the desktop's palette before ours replaces it.
    const QPalette desktop = QApplication::palette();
    system_is_dark_ = desktop.color(QPalette::Window).lightness() < desktop.color(QPalette::WindowText).lightness();
    system_asked_ = true;
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  }
  choice_ = choice;
  const bool dark = choice == ThemeChoice::dark || (choice == ThemeChoice::system && system_is_dark_);
  theme_ = dark ? darkTheme() : lightTheme();
  QApplication::setPalette(theme_.palette());
  QFile sheet(QStringLiteral(":/fyd/themes/instrument.qss"));
  if (sheet.open(QIODevice::ReadOnly)) application.setStyleSheet(fillIn(QString::fromUtf8(sheet.readAll()), theme_));
  emit changed();
}

QString themeWord(ThemeChoice choice) { return QLatin1String(kThemeWords[static_cast<std::size_t>(choice)]); }

std::optional<ThemeChoice> themeOf(const QString& word) {
  for (const ThemeChoice choice : {ThemeChoice::dark, ThemeChoice::light, ThemeChoice::system}) {
    if (word == themeWord(choice)) return choice;
  }
  return std::nullopt;
}

}  // namespace fyd::widgets
