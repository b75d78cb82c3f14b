// "Ready? 7/7": what must hold before arming. An unmet line says why, how to resolve it, and offers the
// window's command for it, where there is one.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>
#include <QVBoxLayout>
#include <vector>

#include "core/pipeline/safety.h"

namespace fyd::widgets {

struct ReadinessRow {
  QString what;
  bool ok = false;
  QString why = {};     ///< empty when ok
  QString remedy = {};  ///< what to do, in words; empty when ok
  pipeline::Fault fault = pipeline::Fault::none;
  QString command = {};  ///< id of the window's command that helps; empty: none does
  QString action = {};   ///< its words, for the button
  friend bool operator==(const ReadinessRow&, const ReadinessRow&) = default;
};

class ReadinessList : public QFrame {
  Q_OBJECT
 public:
  explicit ReadinessList(QWidget* parent = nullptr);
  void setRows(const std::vector<ReadinessRow>& rows);
  [[nodiscard]] QString title() const { return title_->text(); }

 signals:
  /// The operator pressed a line's button.
  void commandAsked(const QString& id);

 private:
  void addTrouble(class QGridLayout& grid, const ReadinessRow& row, int& line);
  void rebuild();
  /// The lines that were shown before go; the focus that one of their buttons had stays here.
  void retire(QWidget& former);
  /// New buttons stand last in the window's order; here they come where the list is.
  void placeInTabOrder();
  std::vector<ReadinessRow> rows_;
  QLabel* title_ = nullptr;
  QWidget* body_ = nullptr;
  QVBoxLayout* layout_ = nullptr;
};

}  // namespace fyd::widgets
