// Values set on the devices beside the values read back from them: confirmed, different, or not readable.
#pragma once

#include <QTableWidget>
#include <QWidget>
#include <vector>

namespace fyd::widgets {

struct ReadbackLine {
  enum class State { confirmed, differs, unknown };
  QString what;
  QString asked;  ///< with unit; "—": nothing
  QString said;   ///< with unit; "—": the device does not say
  State state = State::unknown;
  friend bool operator==(const ReadbackLine&, const ReadbackLine&) = default;
};

class TuningReadback : public QWidget {
  Q_OBJECT
 public:
  explicit TuningReadback(QWidget* parent = nullptr);
  void setLines(const std::vector<ReadbackLine>& lines);
  [[nodiscard]] QTableWidget* table() const { return table_; }

 private:
  QTableWidget* table_ = nullptr;
  std::vector<ReadbackLine> lines_;
};

}  // namespace fyd::widgets
