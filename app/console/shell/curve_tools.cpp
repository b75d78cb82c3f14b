#include "app/console/shell/curve_tools.h"

#include "widgets/curves/curve_choice.h"

namespace fyd::console {

CurveTools::CurveTools(widgets::CurveStack* stack, CurveSaver::Tell tell, QWidget* page)
    : QObject(page),
      stack_(stack),
      panel_(new widgets::CurveSetupPanel(stack, page)),
      spectrum_(new widgets::SpectrumView(page)),
      saver_(std::move(tell), this) {
  panel_->hide();
  spectrum_->hide();
}

void CurveTools::addCommands(PlaceCommands& commands, const std::string& place, const char* menu,
                             std::function<void()> save_table) {
  const auto add = [&](const char* name, const char* text, const char* icon, const char* keys, bool checkable,
                       std::function<void(bool)> run) {
    const std::string id = place + "." + name;
    return commands.add({id.c_str(), menu, text, icon, keys, checkable}, std::move(run));
  };
  QAction* choose = choose_action_ =
      add("choose", QT_TRANSLATE_NOOP("Commands", "Choose curves"), "curves", "C", true, [](bool) {});
  connect(panel_, &widgets::CurveSetupPanel::closeAsked, choose, [choose] { choose->setChecked(false); });
  connect(choose, &QAction::toggled, panel_, &QWidget::setVisible);
  link_action_ =
      add("link_time", QT_TRANSLATE_NOOP("Commands", "One time for all curves"), "", "T", true, [this](bool linked) {
        stack_->setLinked(linked);
        panel_->refresh();
      });
  hold_action_ =
      add("hold_ranges", QT_TRANSLATE_NOOP("Commands", "Hold the vertical ranges"), "", "R", true, [this](bool held) {
        stack_->holdRanges(held);
        panel_->refresh();
      });
  // A layout, a field or a start may change them too.
  connect(stack_, &widgets::CurveStack::moved, this, &CurveTools::showState);
  showState();
  spectrum_action_ = add("spectrum", QT_TRANSLATE_NOOP("Commands", "Spectrum of the vibration"), "spectrum", "S", true,
                         [this](bool shown) {
                           spectrum_->setVisible(shown);
                           emit spectrum_->changed();
                         });
  addSaving(commands, place, menu, std::move(save_table));
}

void CurveTools::showState() {
  link_action_->setChecked(stack_->linked());
  hold_action_->setChecked(stack_->rangesHeld());
  if (panel_->isVisible()) panel_->refresh();
}

QByteArray CurveTools::choice() const { return widgets::choiceOf(*stack_); }

QString CurveTools::choose(const QByteArray& choice) {
  QString left_out = widgets::takeChoice(*stack_, choice);
  panel_->refresh();
  return left_out;
}

std::vector<QToolButton*> CurveTools::makeButtons(QWidget* parent) const {
  std::vector<QToolButton*> out;
  for (QAction* action : {spectrum_action_, choose_action_}) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setIconSize({2 * widgets::kGrid, 2 * widgets::kGrid});
    button->setAccessibleName(action->text());
    button->setToolTip(tr("%1 (%2)").arg(action->text(), action->shortcut().toString(QKeySequence::NativeText)));
    out.push_back(button);
  }
  return out;
}

void CurveTools::addSaving(PlaceCommands& commands, const std::string& place, const char* menu,
                           std::function<void()> save_table) {
  using Kind = widgets::PictureKind;
  const auto add = [&](const char* name, const char* text, const char* keys, std::function<void()> run) {
    const std::string id = place + "." + name;
    commands.add({id.c_str(), menu, text, "save", keys}, [run = std::move(run)](bool) { run(); });
  };
  const auto picture = [this](Kind kind) { return [this, kind] { saver_.savePicture(*stack_, kind); }; };
  add("save_png", QT_TRANSLATE_NOOP("Commands", "Save the curves as PNG"), "Ctrl+G", picture(Kind::png));
  add("save_svg", QT_TRANSLATE_NOOP("Commands", "Save the curves as SVG"), "", picture(Kind::svg));
  add("save_pdf", QT_TRANSLATE_NOOP("Commands", "Save the curves as PDF"), "", picture(Kind::pdf));
  add("save_csv", QT_TRANSLATE_NOOP("Commands", "Save the values shown as CSV"), "Ctrl+Shift+G", std::move(save_table));
}

}  // namespace fyd::console
