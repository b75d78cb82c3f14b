// The commands of the page "Review".
#include "app/console/review_page.h"

namespace fyd::console {
namespace {

constexpr const char* kMenu = QT_TRANSLATE_NOOP("Commands", "Review");
using Mark = widgets::CurveStack::Mark;

}  // namespace

void ReviewPage::addCommands(PlaceCommands& commands) {
  const auto add = [&](const char* id, const char* text, const char* icon, const char* keys, auto run) {
    commands.add({id, kMenu, text, icon, keys}, [run](bool) { run(); });
  };
  add("review.list", QT_TRANSLATE_NOOP("Commands", "List of sessions"), "log", "Ctrl+O", [this] { showList(); });
  add("review.play", QT_TRANSLATE_NOOP("Commands", "Play or pause"), "pause", "Space",
      [this] { player_.togglePlaying(); });
  add("review.next_sample", QT_TRANSLATE_NOOP("Commands", "Next sample"), "", "Right",
      [this] { player_.stepSamples(1); });
  add("review.previous_sample", QT_TRANSLATE_NOOP("Commands", "Previous sample"), "", "Left",
      [this] { player_.stepSamples(-1); });
  add("review.next_picture", QT_TRANSLATE_NOOP("Commands", "Next picture"), "", "Shift+Right",
      [this] { player_.stepPictures(1); });
  add("review.previous_picture", QT_TRANSLATE_NOOP("Commands", "Previous picture"), "", "Shift+Left",
      [this] { player_.stepPictures(-1); });
  add("review.mark_a", QT_TRANSLATE_NOOP("Commands", "Set A at the cursor"), "", "[", [this] { setMark(Mark::a); });
  add("review.mark_b", QT_TRANSLATE_NOOP("Commands", "Set B at the cursor"), "", "]", [this] { setMark(Mark::b); });
  add("review.clear_marks", QT_TRANSLATE_NOOP("Commands", "Take A and B away"), "", "\\",
      [this] { curves_->stack()->clearMarks(); });
  curve_tools_->addCommands(commands, "review", kMenu, [this] {
    exports_->exportShown(*curves_, curve_tools_->saver().pathFor(QStringLiteral("csv")));
  });
  for (QToolButton* button : curve_tools_->makeButtons(this)) bar_->addWidget(button);
  add("review.note", QT_TRANSLATE_NOOP("Commands", "Write a note at the cursor"), "", "N",
      [this] { note_field_->setFocus(); });
  add("review.bookmark", QT_TRANSLATE_NOOP("Commands", "Bookmark at the cursor"), "", "B",
      [this] { writeNote(session::NoteKind::bookmark, tr("bookmark")); });
  add("review.whole", QT_TRANSLATE_NOOP("Commands", "Show the whole session"), "", "Home", [this] {
    if (recording_) curves_->show(0.0, recording_->info().duration_s);
  });
  add("review.gesture_card", QT_TRANSLATE_NOOP("Commands", "Make a gesture card of the chosen touch"), "save", "G",
      [this] { makeCard(); });
  addExportCommands(commands);
  add("review.recover", QT_TRANSLATE_NOOP("Commands", "Recover a crashed recording"), "", "", [this] {
    if (showsList()) {
      list_->recoverPath();
    } else {
      recovery_->recover(path_);
    }
  });
  add("review.cancel", QT_TRANSLATE_NOOP("Commands", "Cancel what is running"), "cross", kCancelWorkKeys, [this] {
    if (!work_->cancelNewest()) context_.tell(widgets::Severity::information, tr("Nothing is running here."));
  });
}

void ReviewPage::addExportCommands(PlaceCommands& commands) {
  struct Format {
    const char* id;
    const char* text;
    const char* keys;
    const char* ending;
  };
  for (const Format& each :
       {Format{"review.report_html", QT_TRANSLATE_NOOP("Commands", "Report as web page"), "Ctrl+P", "html"},
        Format{"review.report_pdf", QT_TRANSLATE_NOOP("Commands", "Report as PDF"), "Ctrl+Shift+P", "pdf"},
        Format{"review.export_csv", QT_TRANSLATE_NOOP("Commands", "Export as CSV"), "", "csv"},
        Format{"review.export_mat", QT_TRANSLATE_NOOP("Commands", "Export for MATLAB"), "", "mat"},
        Format{"review.export_mcap", QT_TRANSLATE_NOOP("Commands", "Export as MCAP"), "", "mcap"},
        Format{"review.export_mkv", QT_TRANSLATE_NOOP("Commands", "Export the camera's video"), "", "mkv"}}) {
    commands.add({each.id, kMenu, each.text, "save", each.keys},
                 [this, ending = QString::fromLatin1(each.ending)](bool) { exports_->exportAs(ending); });
  }
}

}  // namespace fyd::console
