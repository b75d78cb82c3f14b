// Tools for the curves of both Operate and Review: the panel that chooses them, saving, and the commands for both.
#pragma once

#include <QObject>
#include <string>

#include "app/console/shell/curve_saver.h"
#include "app/console/shell/page.h"
#include "widgets/curves/curve_setup_panel.h"
#include "widgets/curves/spectrum_view.h"

namespace fyd::console {

class CurveTools : public QObject {
  Q_OBJECT
 public:
  /// @param stack must outlive this
  CurveTools(widgets::CurveStack* stack, CurveSaver::Tell tell, QWidget* page);

  /// To be placed beside the curves; hidden until it is asked for.
  [[nodiscard]] widgets::CurveSetupPanel* panel() const { return panel_; }
  /// To be placed below the curves; hidden until it is asked for. Its owner draws it.
  [[nodiscard]] widgets::SpectrumView* spectrum() const { return spectrum_; }
  [[nodiscard]] CurveSaver& saver() { return saver_; }
  /// @param save_table saves the values that are shown as CSV
  /// @param place before the dot of the commands' names: "curves" gives "curves.choose"
  /// @param menu in which they stand
  void addCommands(PlaceCommands& commands, const std::string& place, const char* menu,
                   std::function<void()> save_table);
  /// Which curves are shown and how, for saved layouts.
  [[nodiscard]] QByteArray choice() const;
  /// @return what was left out of it, as text; empty: nothing
  [[nodiscard]] QString choose(const QByteArray& choice);
  /// For a bar above the curves, after addCommands: opens and closes the panel, and the spectrum.
  [[nodiscard]] std::vector<QToolButton*> makeButtons(QWidget* parent) const;

 private:
  /// Sets the checkable commands to the present state.
  void showState();
  void addSaving(PlaceCommands& commands, const std::string& place, const char* menu, std::function<void()> save_table);

  widgets::CurveStack* stack_ = nullptr;
  widgets::CurveSetupPanel* panel_ = nullptr;
  widgets::SpectrumView* spectrum_ = nullptr;
  CurveSaver saver_;
  QAction* link_action_ = nullptr;
  QAction* hold_action_ = nullptr;
  QAction* choose_action_ = nullptr;
  QAction* spectrum_action_ = nullptr;
};

}  // namespace fyd::console
