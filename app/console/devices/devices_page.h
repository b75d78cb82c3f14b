// The place "Devices": what is plugged in and what is connected, whether it answers, what it measures, and small tests of
// the motors.
#pragma once

#include <QHBoxLayout>
#include <QTimer>
#include <vector>

#include "app/console/devices/device_search.h"
#include "app/console/shell/page.h"
#include "widgets/devices/connection_form.h"
#include "widgets/devices/device_card.h"
#include "widgets/devices/found_list.h"

namespace fyd::console {

class DevicesPage : public Page {
  Q_OBJECT
 public:
  explicit DevicesPage(const PageContext& context, QWidget* parent = nullptr);
  void addCommands(PlaceCommands& commands) override;
  void enter() override;
  void leave() override;

  /// In the order of the session's devices.
  [[nodiscard]] widgets::DeviceCard* card(std::size_t index) const { return cards_[index]; }
  [[nodiscard]] std::size_t cardCount() const { return shown_; }
  [[nodiscard]] widgets::FoundList* found() const { return found_; }
  [[nodiscard]] widgets::ConnectionForm* form() const { return form_; }
  /// Takes another way to search; for tests.
  void setSearch(std::vector<DeviceSearch::Step> steps);
  /// Reads the devices now, without waiting for the timer.
  void refresh();

 signals:
  void robotAsked();  ///< the panel in which the robot is chosen is wanted

 private:
  void build();
  void connectForm();
  void showConnection();
  void showFound(const std::vector<widgets::FoundRow>& rows);
  void use(widgets::FoundRow::Use as, const QString& path);
  widgets::DeviceCard* addCard();
  /// The motors are those of another card now, or of none: a test under way ends.
  void moveTests(widgets::DeviceCard* card);
  void endTest();
  void showTests();
  void startTest(int test);
  void holdOn();

  PageContext context_;
  QTimer timer_;       ///< while the page is shown
  QTimer hold_timer_;  ///< while a test's button is held
  std::vector<widgets::DeviceCard*> cards_;
  std::size_t shown_ = 0;
  widgets::DeviceCard* tested_ = nullptr;  ///< the card whose motors the tests move
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  bool silent_ = false;
  QHBoxLayout* row_ = nullptr;
  QLabel* empty_ = nullptr;
  widgets::FoundList* found_ = nullptr;
  widgets::ConnectionForm* form_ = nullptr;
  DeviceSearch* search_ = nullptr;
  bool looked_ = false;
};

}  // namespace fyd::console
