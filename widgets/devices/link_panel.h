// State of the link to the robot: peer, protocol and security, timing, losses, what was refused and why.
#pragma once

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QString>
#include <cstdint>
#include <limits>
#include <vector>

namespace fyd::widgets {

struct LinkRefusalRow {
  QString reason;
  std::uint64_t count = 0;
  friend bool operator==(const LinkRefusalRow&, const LinkRefusalRow&) = default;
};

/// NaN where there is no value, or the protocol cannot tell.
struct LinkView {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  enum class Security { no_link, open, sealed };
  enum class Health { well, waiting, lost };

  QString protocol;   ///< "FYD Link 1, sealed"
  QString condition;  ///< "Running", "Lost: the robot is silent"
  Health health = Health::waiting;
  Security security = Security::no_link;
  bool local_only = false;  ///< only this computer's own programs reach the address
  QString peer;             ///< address of the robot; empty before the first
  QString local;            ///< address this end listens on; empty without a link
  double round_trip_ms = kUnknown;
  double jitter_ms = kUnknown;
  double loss_percent = kUnknown;
  double rate_hz = kUnknown;       ///< the robot's messages in the last second
  double age_ms = kUnknown;        ///< of its last message
  QString predictor;               ///< by which the arm is led; empty: not reported by the robot
  QString arrived;                 ///< "12.3, −4.0, −2.1 mm": target from the newest touch, without prediction
  QString led;                     ///< where the arm is led
  double ahead_ms = kUnknown;      ///< predicted, from the newest picture
  double led_error_mm = kUnknown;  ///< RMS of the last second
  std::uint64_t received = 0;
  std::uint64_t sent = 0;
  std::uint64_t times_lost = 0;
  std::uint64_t refused = 0;
  std::vector<LinkRefusalRow> refusals;  ///< by reason, of those that occurred
};

class LinkPanel : public QFrame {
  Q_OBJECT
 public:
  explicit LinkPanel(QWidget* parent = nullptr);
  void setLink(const LinkView& view);

  /// What stands beside a label, also a refusal's: "Round trip" gives "3.1 ms". Empty when there is no such row.
  [[nodiscard]] QString value(const QString& label) const;
  [[nodiscard]] QString securityWord() const { return security_->text(); }
  /// Name of the icon beside the word: "lock", "lock-open" or none.
  [[nodiscard]] QString securityShape() const { return shape_name_; }

 private:
  struct Row {
    QLabel* label;
    QLabel* value;
  };
  Row addRow(QGridLayout& grid, int line, const QString& label);
  static void set(const Row& row, const QString& text);
  void showSecurity();
  void showRefusals();

  LinkView view_;
  QString shape_name_;
  QLabel* shape_ = nullptr;
  QLabel* security_ = nullptr;
  QLabel* explanation_ = nullptr;
  QGridLayout* grid_ = nullptr;
  std::vector<Row> rows_;
  QLabel* refused_title_ = nullptr;
  QGridLayout* refusals_ = nullptr;
  std::vector<Row> refusal_rows_;
};

}  // namespace fyd::widgets
