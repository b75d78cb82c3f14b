// A start with the devices of last time, when they are not there: the window opens all the same and says what was looked
// for, why it was not found and what can be done.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

#include "app/console/shell/page.h"
#include "widgets/status/guide_strip.h"

namespace fyd::console {

class MissingDevices : public QObject {
  Q_OBJECT
 public:
  /// @param choose shows where other devices are chosen
  MissingDevices(const PageContext& context, std::function<void()> choose, QObject* parent = nullptr);
  [[nodiscard]] widgets::GuideStrip* strip() const { return strip_; }
  /// Looks whether the devices come, and says so when they do not.
  /// @param why the session could not be opened; empty: it is open
  void expect(const Message& why);

  static constexpr int kPatience_ms = 2000;  ///< a device that is there has answered by then

 private:
  void refresh();
  void end();
  [[nodiscard]] QString reason() const;

  PageContext context_;
  std::function<void()> choose_;
  widgets::GuideStrip* strip_ = nullptr;
  QTimer patience_;
  Message why_;
  bool expecting_ = false;
};

}  // namespace fyd::console
