#include "app/console/review/review_comparison.h"

#include <QFileInfo>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/console/review/recording_files.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

using widgets::numberText;

double startOf(const std::vector<exports::Touch>& touches, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < touches.size()
             ? touches[static_cast<std::size_t>(index)].start_s
             : 0.0;
}

}  // namespace

ReviewComparison::ReviewComparison(widgets::ProgressBars* bars, QWidget* parent)
    : QWidget(parent),
      path_(new QLineEdit(this)),
      choose_(new QPushButton(tr("Choose a file…"), this)),
      our_touch_(new QComboBox(this)),
      their_touch_(new QComboBox(this)),
      words_(new QLabel(this)),
      search_(bars) {
  build();
  connect(path_, &QLineEdit::returnPressed, this, [this] { compare(path_->text()); });
  connect(choose_, &QPushButton::clicked, this, [this] {
    askForRecording(this, tr("Recording to compare with"), QFileInfo(path_->text()).absolutePath(),
                    [this](const QString& path) { compare(path); });
  });
  for (QComboBox* box : {our_touch_, their_touch_}) {
    connect(box, &QComboBox::currentIndexChanged, this,
            [this] { alignAt(our_touch_->currentIndex() - 1, their_touch_->currentIndex() - 1); });
  }
}

void ReviewComparison::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(widgets::kGrid);
  path_->setObjectName(QStringLiteral("compare_path"));
  path_->setPlaceholderText(tr("Path of a second recording, then Enter"));
  path_->setAccessibleName(tr("Path of a second recording"));
  our_touch_->setAccessibleName(tr("Align this session at"));
  their_touch_->setAccessibleName(tr("Align the other session at"));
  words_->setWordWrap(true);
  layout->addWidget(path_);
  layout->addWidget(choose_);
  layout->addWidget(new QLabel(tr("This session's"), this));
  layout->addWidget(our_touch_);
  layout->addWidget(new QLabel(tr("lies on the other's"), this));
  layout->addWidget(their_touch_);
  layout->addWidget(words_);
  layout->addStretch(1);
}

void ReviewComparison::clear() {
  search_.drop();
  emit otherChanged(nullptr, 0.0);
  other_.reset();
  touches_.clear();
  other_touches_.clear();
  our_touch_->clear();
  their_touch_->clear();
  words_->setText(
      tr("Choose a second recording: its curves are drawn faint behind these. In the list of sessions, two can be "
         "chosen at once."));
}

void ReviewComparison::setTouches(const std::vector<exports::Touch>& touches) {
  touches_ = touches;
  fillChoices();
}

void ReviewComparison::compare(const QString& path) {
  path_->setText(path);
  auto opened = recording::Recording::open(path.trimmed().toStdString());
  if (!opened) {
    words_->setText(widgets::coreText(opened.error().message));
    return;
  }
  other_touches_.clear();
  for (QComboBox* box : {our_touch_, their_touch_}) {
    const QSignalBlocker quiet(box);
    box->setCurrentIndex(box->count() > 0 ? 0 : -1);  // another one is drawn from the start
  }
  fillChoices();
  emit otherChanged(opened->get(), 0.0);
  other_ = std::move(*opened);
  words_->setText(tr("Looking for its touches …"));
  search_.look(path.trimmed(), [this](const auto& found) {
    words_->setText(found                 ? tr("Drawn faint. Choose a touch of each to lay one on the other.")
                    : search_.cancelled() ? tr("Drawn faint. The search for its touches was cancelled.")
                                          : widgets::coreText(found.error().message));
    if (found) other_touches_ = *found;
    fillChoices();
  });
}

void ReviewComparison::fillChoices() {
  const bool aligned = our_touch_->currentIndex() > 0 || their_touch_->currentIndex() > 0;
  const auto fill = [](QComboBox* box, const std::vector<exports::Touch>& touches) {
    const QSignalBlocker quiet(box);
    const int chosen = box->currentIndex();
    box->clear();
    box->addItem(tr("from the start"));
    for (std::size_t i = 0; i < touches.size(); ++i) {
      box->addItem(tr("touch %1 at %2 s").arg(i + 1).arg(numberText(touches[i].start_s, 2)));
    }
    if (chosen > 0 && chosen < box->count()) box->setCurrentIndex(chosen);
  };
  fill(our_touch_, touches_);
  fill(their_touch_, other_touches_);
  if (aligned) alignAt(our_touch_->currentIndex() - 1, their_touch_->currentIndex() - 1);
}

void ReviewComparison::alignAt(int ours, int theirs) {
  if (!other_) return;
  const double later_by_s = startOf(touches_, ours) - startOf(other_touches_, theirs);
  emit otherChanged(other_.get(), later_by_s);
  words_->setText(tr("The other session is drawn %1 s later than recorded.").arg(numberText(later_by_s, 3)));
}

}  // namespace fyd::console
