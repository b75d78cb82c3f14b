// The place "Calibrate" on a scripted session, with its hands: what the tests type, click and hold there.
#pragma once

#include "app/console/calibrate/calibrate_page.h"
#include "core/base/units.h"
#include "core/station/profile/calibrated_values.h"
#include "tests/widgets/scripted_session.h"

namespace fyd::tests {

using pipeline::SafetyState;

inline constexpr double kSlope_g = 900.0;  // of the cell that the test plays
inline constexpr double kOffset_g = -10.0;

inline device::DeviceReport touchpad(double bridge_mV_per_V, double ir_counts = 1500.0) {
  device::DeviceReport out{
      .part = device::Part::touchpad, .kind = verbatim("Modbus TCP"), .description = verbatim("10.0.0.7:502")};
  out.ok = true;
  out.age_ms = 4.0;
  for (std::size_t i = 1; i <= 3; ++i) {
    out.values.push_back({.name = say("IR sensor {}", i), .number = ir_counts, .unit = "counts"});
  }
  out.values.push_back({.name = say("load cell"), .number = bridge_mV_per_V, .unit = "mV/V"});
  return out;
}

inline double bridgeOf(double grams) { return (grams - kOffset_g) / kSlope_g; }

struct Calibrating : Fixture {
  /// @param on as in touchpad_name.h
  explicit Calibrating(const char* part, std::string_view on = station::kSimulatedTouchpad) {
    session->profile.calibrated_on = on;
    session->reports = {touchpad(bridgeOf(0.0))};
    QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
    page = qobject_cast<console::CalibratePage*>(window->frame()->page(QStringLiteral("calibrate")));
    page->choose(QLatin1String(part));
    page->fitPanel()->who()->setText(QStringLiteral("A. Tester"));
    state(SafetyState::stopped);
  }
  void state(SafetyState now) {
    session->say(now);
    window->feed().pump();
  }
  void type(int entry, const QString& text) {
    QLineEdit* field = page->entries()->field(static_cast<std::size_t>(entry));
    field->selectAll();
    QTest::keyClick(field, Qt::Key_Delete);
    QTest::keyClicks(field, text);
  }
  void click(QWidget* button) { QTest::mouseClick(button, Qt::LeftButton); }
  void readings(int count) {
    for (int i = 0; i < count; ++i) page->poll();
  }
  /// A point with what is played and typed now.
  void take(const QString& text, int count = 10) {
    type(0, text);
    click(page->takeButton());
    readings(count);
  }
  [[nodiscard]] std::string profilePath() const {
    return folder.filePath(QStringLiteral("profile.toml")).toStdString();
  }
  /// What the next session on this touchpad loads.
  [[nodiscard]] Result<station::Profile> saved() const {
    auto loaded = station::loadProfileFor(profilePath(), session->profile.calibrated_on);
    if (!loaded) return tl::unexpected(loaded.error());
    return loaded->profile;
  }
  [[nodiscard]] QString partText(const char* name) const {
    for (int i = 0; i < page->parts()->count(); ++i) {
      if (page->parts()->item(i)->text().contains(QLatin1String(name))) return page->parts()->item(i)->text();
    }
    return {};
  }
  console::CalibratePage* page;
};

}  // namespace fyd::tests
