// "Ready? 7/7": what must hold before arming, each line with what to do when it does not.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>
#include <QVBoxLayout>
#include <vector>

namespace fyd::widgets {

struct ReadinessRow {
  QString what;
  bool ok = false;
  QString remedy;  ///< empty when ok
  friend bool operator==(const ReadinessRow&, const ReadinessRow&) = default;
};

class ReadinessList : public QFrame {
  Q_OBJECT
 public:
  explicit ReadinessList(QWidget* parent = nullptr);
  void setRows(const std::vector<ReadinessRow>& rows);
  [[nodiscard]] QString title() const { return title_->text(); }

 private:
  void rebuild();
  std::vector<ReadinessRow> rows_;
  QLabel* title_;
  QWidget* body_ = nullptr;
  QVBoxLayout* layout_;
};

}  // namespace fyd::widgets
