// What is written of a recording in review: in which format, all of it or from A to B; and where the written files are.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QUrl>
#include <functional>

#include "app/console/review/review_exports.h"

namespace fyd::console {

class ExportPanel : public QWidget {
  Q_OBJECT
 public:
  /// @return whether the folder was opened
  using OpenFolder = std::function<bool(const QUrl&)>;
  /// @param exports must outlive this
  explicit ExportPanel(ReviewExports* exports, QWidget* parent = nullptr);

  /// The marks of the review, s; not finite: not set.
  void setMarks(double a_s, double b_s);
  /// Forgets what was written.
  void clear();
  void write();
  /// For tests, in place of the desktop's.
  void setOpenFolder(OpenFolder open) { open_ = std::move(open); }

  [[nodiscard]] QComboBox* format() const { return format_; }
  [[nodiscard]] QRadioButton* wholeButton() const { return whole_; }
  [[nodiscard]] QRadioButton* stretchButton() const { return stretch_; }
  [[nodiscard]] QPushButton* writeButton() const { return write_; }
  [[nodiscard]] QPushButton* folderButton() const { return folder_; }
  [[nodiscard]] QPushButton* copyButton() const { return copy_; }
  [[nodiscard]] QListWidget* written() const { return written_; }
  [[nodiscard]] QString words() const { return words_->text(); }

 private:
  void build();
  void showChoice();
  void showFolder();
  /// The path that is chosen in the list, or the newest; empty: none.
  [[nodiscard]] QString chosenPath() const;

  ReviewExports* exports_ = nullptr;
  OpenFolder open_;
  double from_s_ = 0.0;
  double to_s_ = 0.0;
  bool marked_ = false;
  QComboBox* format_ = nullptr;
  QRadioButton* whole_ = nullptr;
  QRadioButton* stretch_ = nullptr;
  QPushButton* write_ = nullptr;
  QListWidget* written_ = nullptr;
  QPushButton* folder_ = nullptr;
  QPushButton* copy_ = nullptr;
  QLabel* words_ = nullptr;
};

}  // namespace fyd::console
