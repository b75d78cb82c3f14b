#include "app/console/calibrate/calibrate_fit_panel.h"

#include <QGridLayout>
#include <QLocale>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/core_text.h"
#include "widgets/basics/heading_table.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/vertical_scroll.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::console {
namespace {

using widgets::kGrid;
using widgets::TextSize;

constexpr int kLongestWho = 80, kLongestConditions = 400;  // characters that fit in a report

/// Every number of a parameter's text with five digits: the file keeps all of them.
QString shortened(const QString& text) {
  static const QRegularExpression kNumber(QStringLiteral("-?\\d+\\.\\d+(e[-+]?\\d+)?"));
  QString out;
  qsizetype from = 0;
  for (auto all = kNumber.globalMatch(text); all.hasNext();) {
    const QRegularExpressionMatch match = all.next();
    out += text.mid(from, match.capturedStart() - from);
    out += QString::number(match.captured().toDouble(), 'g', 5).replace(QLatin1Char('.'), QLocale().decimalPoint());
    from = match.capturedEnd();
  }
  out += text.mid(from);
  return out.replace(QLatin1Char('-'), QChar(0x2212));
}

/// A coefficient's name in words; a number at its end stays as it is.
QString coefficientName(const std::string& name) {
  const QString text = QString::fromStdString(name);
  static const QRegularExpression kNumbered(QStringLiteral("^(.*) (\\d+)$"));
  const QRegularExpressionMatch match = kNumbered.match(text);
  if (!match.hasMatch()) return widgets::coreText(name);
  return widgets::coreText(match.captured(1).toStdString()) + QLatin1Char(' ') + match.captured(2);
}

/// NaN where there is no such limit.
double valueOf(std::string_view id, station::Profile& profile) {
  const auto bound = bindParameters(profile);
  const Parameter* parameter = findParameter(bound, id);
  return parameter != nullptr ? parameter->value() : calibration::kUnknown;
}

QLabel* label(QWidget* parent, TextSize size, bool muted) {
  auto* out = new QLabel(parent);
  out->setFont(widgets::textFont(size));
  if (muted) out->setProperty("role", "muted");
  out->setWordWrap(true);
  out->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return out;
}

}  // namespace

CalibrationFitPanel::CalibrationFitPanel(QWidget* parent)
    : QFrame(parent),
      plot_(new widgets::FitPlot(this)),
      legend_(label(this, TextSize::small, true)),
      verdict_(label(this, TextSize::normal, false)),
      figures_(label(this, TextSize::small, true)),
      changes_(buildTable(QStringLiteral("calibration_changes"), tr("Values in force and new values"),
                          {tr("Value"), tr("In force"), tr("New")})),
      coefficients_(buildTable(QStringLiteral("calibration_coefficients"),
                               tr("What was fitted, with its standard uncertainty"),
                               {tr("Coefficient"), tr("Fitted"), tr("Uncertainty")})),
      who_(new QLineEdit(this)),
      offered_(new QPushButton(this)),
      conditions_(new QLineEdit(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Fit"));
  verdict_->setObjectName(QStringLiteral("calibration_verdict"));
  verdict_->setFont(widgets::textFont(TextSize::normal, true));
  coefficients_->setToolTip(tr("The standard uncertainty is one standard deviation, from the scatter of the points."));
  who_->setObjectName(QStringLiteral("calibration_who"));
  who_->setAccessibleName(tr("Who measured"));
  who_->setMaxLength(kLongestWho);
  who_->setPlaceholderText(tr("your name: the record keeps it"));
  offered_->setObjectName(QStringLiteral("calibration_offered_name"));
  offered_->setAutoDefault(false);
  offered_->setToolTip(tr("The last calibration was made by this person."));
  offered_->hide();
  connect(offered_, &QPushButton::clicked, this, [this] { who_->setText(last_name_); });
  connect(who_, &QLineEdit::textChanged, this, &CalibrationFitPanel::refreshOffer);
  conditions_->setMaxLength(kLongestConditions);
  conditions_->setObjectName(QStringLiteral("calibration_conditions"));
  conditions_->setAccessibleName(tr("Conditions: light, temperature, target"));
  conditions_->setPlaceholderText(tr("light, temperature, target"));
  auto* name = new QHBoxLayout;
  name->setSpacing(kGrid);
  name->addWidget(who_, 1);
  name->addWidget(offered_);
  auto* record = new QGridLayout;
  record->setSpacing(kGrid);
  record->addWidget(new QLabel(tr("Who"), this), 0, 0);
  record->addLayout(name, 0, 1);
  record->addWidget(new QLabel(tr("Conditions"), this), 1, 0);
  record->addWidget(conditions_, 1, 1);
  // In a low window the texts scroll, and the plot keeps a readable height.
  auto* said = new QWidget(this);
  auto* lines = new QVBoxLayout(said);
  lines->setContentsMargins(0, 0, kGrid, 0);
  lines->setSpacing(kGrid);
  lines->addWidget(plot_, 1);
  for (QLabel* each : {legend_, verdict_, figures_}) lines->addWidget(each);
  lines->addWidget(changes_);
  lines->addWidget(coefficients_);
  QScrollArea* scroll = widgets::makeVerticalScroll(this);
  scroll->setWidget(said);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(scroll, 1);
  layout->addLayout(record);
}

QTableWidget* CalibrationFitPanel::buildTable(const QString& name, const QString& words, const QStringList& headings) {
  auto* out = new widgets::HeadingTable(0, static_cast<int>(headings.size()), this);
  out->setObjectName(name);
  out->setAccessibleName(words);
  out->setHorizontalHeaderLabels(headings);
  out->verticalHeader()->hide();
  out->setEditTriggers(QAbstractItemView::NoEditTriggers);
  out->setFocusPolicy(Qt::NoFocus);
  out->setFont(widgets::textFont(TextSize::small));
  out->setFixedHeight(15 * kGrid);
  return out;
}

void CalibrationFitPanel::offerName(const QString& name) {
  last_name_ = name.left(kLongestWho);
  refreshOffer();
}

void CalibrationFitPanel::refreshOffer() {
  constexpr int kLongestShown = 24;  // characters
  offered_->setText(last_name_.size() > kLongestShown ? last_name_.left(kLongestShown - 1) + QChar(0x2026)
                                                      : last_name_);
  offered_->setAccessibleName(tr("Take the name %1").arg(last_name_));
  offered_->setVisible(!last_name_.isEmpty() && who_->text().trimmed().isEmpty());
}

void CalibrationFitPanel::askWho() {
  who_->setFocus();
  who_->selectAll();
}

AcceptedWords CalibrationFitPanel::words() const {
  return {.who = who_->text().trimmed().toStdString(),
          .conditions = conditions_->text().trimmed().toStdString(),
          .picture = plot_->grab().toImage()};
}

void CalibrationFitPanel::setChanges(const calibration::CalibrationResult& result, station::Profile& profile) {
  const auto bound = bindParameters(profile);
  changes_->setRowCount(static_cast<int>(result.changes.size()));
  int row = 0;
  for (const calibration::ParameterChange& change : result.changes) {
    const Parameter* parameter = findParameter(bound, change.id);
    const QString before = parameter != nullptr ? QString::fromStdString(formatParameter(*parameter)) : QString();
    // The module's name is the same on every line, so it is left out to save width.
    const QString id = QString::fromStdString(change.id);
    const QString unit = parameter != nullptr ? widgets::unitText(*parameter) : QString();
    const QString name = id.section(QLatin1Char('.'), 1) + (unit.isEmpty() ? unit : QStringLiteral(", ") + unit);
    const QString help = parameter != nullptr ? widgets::coreText(parameter->info.help) : QString();
    const QString after = QString::fromStdString(change.value);
    int column = 0;
    for (const auto& [text, tip] : {std::pair{name, help.isEmpty() ? id : help + QLatin1Char('\n') + id},
                                    std::pair{shortened(before), before}, std::pair{shortened(after), after}}) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(tip);
      changes_->setItem(row, column++, item);
    }
    ++row;
  }
  changes_->setVisible(row > 0);
}

void CalibrationFitPanel::setCoefficients(const std::vector<calibration::Coefficient>& coefficients) {
  coefficients_->setRowCount(static_cast<int>(coefficients.size()));
  int row = 0;
  for (const calibration::Coefficient& each : coefficients) {
    // None is known of a mean, and points without scatter tell none.
    const bool known = each.standard_error > 1e-9 * std::abs(each.value);
    const int decimals = widgets::decimalsOfUncertainty(each.standard_error);
    const QString unit = each.unit == "1" ? QString() : QString::fromStdString(each.unit);
    const QString name = coefficientName(each.name) + (unit.isEmpty() ? unit : QStringLiteral(", ") + unit);
    const QString value = known ? widgets::numberText(each.value, decimals)
                                : shortened(QString::fromStdString(fmt::format("{}", each.value)));
    const QString error =
        known ? QStringLiteral("± ") + widgets::quantityText(each.standard_error, decimals, unit) : widgets::kNoValue;
    int column = 0;
    for (const QString& text : {name, value, error}) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(column == 2 && !known ? tr("None: a mean, or points without scatter.") : text);
      coefficients_->setItem(row, column++, item);
    }
    ++row;
  }
  coefficients_->setVisible(row > 0);
}

void CalibrationFitPanel::setFit(const CalibrationFit& fit, std::size_t points, std::string_view error_limit,
                                 station::Profile profile) {
  const calibration::CalibrationResult& result = fit.result;
  plot_->setFit(fit.plot);
  legend_->setText(points > 0 ? fit.legend : QString());
  setChanges(points > 0 ? result : calibration::CalibrationResult{}, profile);
  setCoefficients(points > 0 ? result.coefficients : std::vector<calibration::Coefficient>{});
  QStringList figures;
  if (points == 0) {
    verdict_->setText(tr("No points yet. The values in force stay until you accept new ones."));
  } else {
    const QString reason = widgets::coreText(result.verdict.reason);
    verdict_->setText(result.verdict.accepted  ? tr("Good: %1.").arg(reason)
                      : !fit.missing.isEmpty() ? tr("Not yet: %1.").arg(reason)
                                               : tr("Refused: %1.").arg(reason));
    const auto error = [&](double value) { return widgets::coreText(calibration::errorWithUnit(value, result.unit)); };
    if (std::isfinite(result.held_out_rmse)) {
      const double allowed = valueOf(error_limit, profile);
      figures << (std::isfinite(allowed)
                      ? tr("Held-out error %1 of at most %2")
                            .arg(error(result.held_out_rmse),
                                 widgets::plainNumber(allowed) + QLatin1Char(' ') + QString::fromStdString(result.unit))
                      : tr("Held-out error %1").arg(error(result.held_out_rmse)));
    }
    if (std::isfinite(result.rmse)) figures << tr("error of the fit %1").arg(error(result.rmse));
    if (std::isfinite(result.max_residual)) figures << tr("largest residual %1").arg(error(result.max_residual));
    if (!result.curve.empty()) figures << tr("curve: %1").arg(widgets::coreText(result.curve));
    if (!result.outliers.empty()) {
      QStringList rows;
      for (const std::size_t row : result.outliers) rows << QString::number(row + 1);
      figures << tr("the others contradict point %1").arg(rows.join(QStringLiteral(", ")));
    }
    if (result.valid_to > result.valid_from) {
      figures << tr("valid from %1 to %2")
                     .arg(widgets::numberText(result.valid_from, 1),
                          widgets::quantityText(result.valid_to, 1, QString::fromStdString(result.valid_unit)));
    }
    figures << fit.figures;
    for (const Message& note : result.notes) figures << widgets::coreText(note);
  }
  figures_->setText(figures.join(QStringLiteral(" · ")));
}

}  // namespace fyd::console
