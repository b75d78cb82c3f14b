// What an operator does with the curves: cursors, choice, saving, the spectrum; a spike is seen at every zoom; hours
// pass and nothing grows.
#include <QCheckBox>
#include <QScrollArea>
#include <QSignalSpy>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <qcustomplot.h>

#include "app/console/review/review_source.h"
#include "tests/files_of_at_most.h"
#include "tests/widgets/look_check.h"
#include "tests/widgets/scripted_session.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/colour_scale.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/plot_labels.h"
#include "widgets/basics/time_field.h"
#include "widgets/curves/curve_catalogue.h"
#include "widgets/curves/curve_picture.h"
#include "widgets/curves/session_overview.h"

namespace fyd::tests {
namespace {

using widgets::CurveStack;

/// Force rises by 1 N a second; the texture signal is a sine of 125 Hz and 0.5 g.
std::vector<pipeline::TelemetrySample> rise(int count, double from_s = 0.0) {
  std::vector<pipeline::TelemetrySample> out(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double t_s = from_s + 0.001 * static_cast<double>(i);
    out[i].now = instantAt(1.0 + t_s);
    out[i].force_N = t_s;
    out[i].indentation_mm = 2.0;
    out[i].texture_signal_g = 0.5 * std::sin(2.0 * std::numbers::pi * 125.0 * t_s);
  }
  return out;
}

struct CurveFixture : Fixture {
  CurveFixture() {
    curves = window->operate()->curves();
    tools = window->operate()->curveTools();
    tools->saver().setFolder(folder.filePath(QStringLiteral("pictures")));
    curves->append(rise(4000));
    curves->redraw();
    QApplication::processEvents();  // until then no strip knows its width
  }
  void key(Qt::Key key, Qt::KeyboardModifiers with = {}) {
    window->setFocus();
    QTest::keyClick(window.get(), key, with);
  }
  [[nodiscard]] QString told() const {
    const int count = window->notices()->count();
    return count == 0 ? QString() : window->notices()->text(count - 1);
  }
  [[nodiscard]] std::size_t indexOf(const char* id) const { return curves->stack()->indexOf(QLatin1String(id)); }
  [[nodiscard]] QString saved(const char* ending) const {
    const QStringList found =
        QDir(tools->saver().folder()).entryList({QStringLiteral("*.") + QLatin1String(ending)}, QDir::Files);
    return found.isEmpty() ? QString() : tools->saver().folder() + QLatin1Char('/') + found.first();
  }
  widgets::CurveView* curves;
  console::CurveTools* tools;
};

void scrollTo(QWidget& widget) {
  for (QWidget* above = widget.parentWidget(); above != nullptr; above = above->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(&widget);
  }
  QApplication::processEvents();
}

/// A pixel of the curve's colour within two of where the spike must be.
bool spikeOnScreen(widgets::CurveStrip& strip, double share, double value) {
  QCustomPlot& plot = *strip.plot();
  const QImage image = plot.grab().toImage();
  const QRect rect = plot.axisRect()->rect();
  const int x = rect.left() + static_cast<int>(share * rect.width());
  const int y = static_cast<int>(plot.yAxis->coordToPixel(value));
  const QRgb colour = widgets::theme().of(widgets::Quantity::force).rgb();
  for (int column = std::max(rect.left(), x - 2); column <= std::min(rect.right(), x + 2); ++column) {
    for (int line = y - 2; line <= y + 2; ++line) {
      if (image.valid(column, line) && image.pixel(column, line) == colour) return true;
    }
  }
  return false;
}

}  // namespace

class CurveToolsTest : public QObject {
  Q_OBJECT
 private slots:
  void marksTellTheirDifferencesAtOnce() {
    CurveFixture f;
    f.key(Qt::Key_BracketLeft);  // at the newest, 3.999 s
    f.curves->redraw();
    QCOMPARE(f.curves->strip(0)->markWords(), QStringLiteral("A 4.00 N"));
    f.curves->append(rise(500, 4.0));
    f.key(Qt::Key_BracketRight);
    f.curves->redraw();
    QVERIFY(f.curves->stack()->markText().contains(QStringLiteral("Δt 0.500 s")));
    QVERIFY(f.curves->stack()->markText().contains(QStringLiteral("2.00 Hz")));
    QCOMPARE(f.curves->strip(0)->markWords(), QStringLiteral("Δ 0.50 N"));
    QCOMPARE(f.curves->strip(1)->markWords(), QStringLiteral("Δ 0.00 mm"));
    QVERIFY(f.curves->strip(2)->markWords().contains(QStringLiteral("—")));  // there is no stiffness
    f.key(Qt::Key_Backslash);
    f.curves->redraw();
    QVERIFY(f.curves->stack()->markText().isEmpty());
    QVERIFY(f.curves->strip(0)->markWords().isEmpty());
  }

  void aClickPutsTheCursorAndKeysMoveIt() {
    CurveFixture f;
    f.curves->chooseSpan(5);
    f.curves->redraw();
    QApplication::processEvents();
    QCustomPlot* plot = f.curves->strip(0)->plot();
    QTest::mouseClick(plot, Qt::LeftButton, {}, plot->axisRect()->rect().center());
    const double at_s = f.curves->stack()->cursor_s();
    QVERIFY2(std::abs(at_s - 1.5) < 0.1, qPrintable(QString::number(at_s)));  // half of 5 s before 3.999 s
    QVERIFY(f.curves->following());  // a look at a value does not stop the curves
    f.key(Qt::Key_Comma);
    QVERIFY(std::abs(f.curves->stack()->cursor_s() - (at_s - 0.001)) < 1e-9);
    f.key(Qt::Key_BracketLeft);
    QCOMPARE(f.curves->stack()->mark_s(CurveStack::Mark::a), f.curves->stack()->cursor_s());
    f.key(Qt::Key_Right, Qt::ControlModifier);
    f.key(Qt::Key_BracketRight);
    QVERIFY(f.curves->stack()->markText().contains(QStringLiteral("Δt 0.050 s")));
  }

  void timeHasANameAndNumeralsSayWhose() {
    CurveFixture f;
    const auto says = [&](const char* text) { return paintedTexts(*f.curves).contains(QString::fromUtf8(text)); };
    QVERIFY2(says("now"), qPrintable(paintedTexts(*f.curves).join(QLatin1Char('|'))));
    QVERIFY(says("−8 s"));
    QVERIFY(!says("session time, s"));
    WAIT_EQUAL(f.curves->readout(0)->when(), QStringLiteral("live"));
    f.key(Qt::Key_Space);
    f.curves->redraw();
    QVERIFY(says("session time, s"));
    QVERIFY(!says("now"));
    QCOMPARE(f.curves->readout(0)->when(), QStringLiteral("live"));  // there is no cursor yet
    f.key(Qt::Key_J);
    widgets::TimeField* field = f.curves->timeField();
    QVERIFY(field->hasFocus());
    for (const char* wrong : {"", "soft", "-1", "99", "0:75", "1:2:3:4", "nan"}) {
      field->setText(QString::fromUtf8(wrong));
      QTest::keyClick(field, Qt::Key_Return);
      QVERIFY2(field->problem().contains(QString::fromUtf8(wrong)) && !field->problem().isEmpty(), wrong);
      QVERIFY(!std::isfinite(f.curves->stack()->cursor_s()));
    }
    field->setText(QStringLiteral("0:01,5"));
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(field->problem().isEmpty());
    QVERIFY(!field->hasFocus());
    QCOMPARE(f.curves->stack()->cursor_s(), 1.5);
    f.curves->redraw();
    QCOMPARE(f.curves->readout(0)->when(), QStringLiteral("at 1.500 s"));
    QCOMPARE(f.curves->readout(0)->valueText(0), QStringLiteral("1.50"));
    QVERIFY(says("1.50 N"));  // beside the curve
    f.key(Qt::Key_F);
    QVERIFY(f.curves->following());
    WAIT_EQUAL(f.curves->readout(0)->when(), QStringLiteral("live"));
  }

  void theEndsThatARefusalNamesCanBeGoneTo() {
    widgets::TimeField field;
    constexpr double kFirst_s = 0.2472, kLast_s = 61.2347;
    field.setSpan([&] { return std::pair(kFirst_s, kLast_s); });
    QSignalSpy asked(&field, &widgets::TimeField::asked);
    field.setText(QStringLiteral("99"));
    QTest::keyClick(&field, Qt::Key_Return);
    QVERIFY(field.problem().contains(QStringLiteral("from 0.247 s to 61.235 s")));
    for (const char* end : {"0.246", "61.236"}) {  // more than the rounding
      field.setText(QString::fromUtf8(end));
      QTest::keyClick(&field, Qt::Key_Return);
      QCOMPARE(asked.count(), 0);
    }
    for (const char* end : {"0.247", "61.235"}) {
      field.setText(QString::fromUtf8(end));
      QTest::keyClick(&field, Qt::Key_Return);
      QVERIFY2(field.problem().isEmpty(), end);
    }
    QCOMPARE(asked.count(), 2);
    QCOMPARE(asked.at(0).first().toDouble(), kFirst_s);
    QCOMPARE(asked.at(1).first().toDouble(), kLast_s);
  }

  void timesAreReadAsTheyAreWritten() {
    QCOMPARE(widgets::readTime_s(QStringLiteral("83.5")), 83.5);
    QCOMPARE(widgets::readTime_s(QStringLiteral(" 1:23,5 ")), 83.5);
    QCOMPARE(widgets::readTime_s(QStringLiteral("1:02:03.5")), 3723.5);
    QCOMPARE(widgets::readTime_s(QStringLiteral("90:00")), 5400.0);
    for (const char* wrong : {"", ":", "1:", "1.5:20", "1:60", "1:-2", "-3", "inf", "1:1:1:1", "ten"}) {
      QVERIFY2(std::isnan(widgets::readTime_s(QString::fromUtf8(wrong))), wrong);
    }
  }

  void labelsFindRoomOrAreLeftOut() {
    std::mt19937 random(5);
    const auto any = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    int placed = 0;
    for (int round = 0; round < 300; ++round) {
      const QRect inside(40, 4, 60 + any(400), 10 + any(150));
      const std::vector<QRect> taken = {QRect(inside.left() + any(inside.width()), inside.top(), 80, 14)};
      std::vector<widgets::LabelWish> wishes;
      for (int i = any(8); i >= 0; --i) {
        wishes.push_back({QPoint(inside.left() + any(inside.width()), inside.top() + any(inside.height())),
                          QSize(20 + any(60), 14)});
      }
      std::vector<QRect> all = taken;
      const auto places = widgets::placeLabels(inside, taken, wishes);
      QCOMPARE(places.size(), wishes.size());
      for (const QRect& place : places) {
        if (!place.isValid()) continue;
        ++placed;
        QVERIFY(inside.contains(place));
        for (const QRect& other : all) QVERIFY(!place.intersects(other));
        all.push_back(place);
      }
    }
    QVERIFY2(placed > 500, qPrintable(QString::number(placed)));
  }

  void withEightCurvesAndTheSpectrumNoTextLiesOnAnother_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("1280x720") << QSize(1280, 720);
    QTest::newRow("1920x1080 at 200 %") << QSize(960, 540);
  }

  void withEightCurvesAndTheSpectrumNoTextLiesOnAnother() {
    QFETCH(QSize, size);
    CurveFixture f;
    f.window->resize(size);
    for (std::size_t i = 0; i < f.curves->stack()->size(); ++i) f.curves->stack()->setShown(i, i < 8);
    f.key(Qt::Key_S);
    QWidget* pictures = f.curves->parentWidget();
    const auto look = [&] {
      QApplication::processEvents();
      f.curves->redraw();
      emit f.tools->spectrum()->changed();
      const QStringList faults = textsOverEachOther(*pictures);
      QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    };
    look();  // live
    f.curves->setMark(CurveStack::Mark::a);
    f.curves->goTo(2.0);
    f.curves->setMark(CurveStack::Mark::b);
    look();
    scrollTo(*f.tools->spectrum());  // below the edge of a low window
    const QStringList texts = paintedTexts(*f.tools->spectrum());
    QVERIFY(texts.contains(QStringLiteral("Frequency, Hz")));
    QVERIFY(texts.contains(QStringLiteral("session time, s")));
    QVERIFY(f.tools->spectrum()->colourScale()->largest() > f.tools->spectrum()->colourScale()->least());
    const auto level = [](QCustomPlot& plot) {
      const QRect rect = plot.axisRect()->rect();
      return std::pair(plot.mapToGlobal(rect.topLeft()).x(), plot.mapToGlobal(rect.topRight()).x());
    };
    QVERIFY(level(*f.curves->strip(0)->plot()) == level(*f.tools->spectrum()->timePlot()));
    QCOMPARE(f.tools->spectrum()->timePlot()->xAxis->range().size(), f.curves->strip(0)->plot()->xAxis->range().size());
  }

  void curvesAreChosenAndTheLastOneStays() {
    CurveFixture f;
    f.key(Qt::Key_C);
    widgets::CurveSetupPanel* panel = f.tools->panel();
    QVERIFY(panel->isVisible());
    QApplication::processEvents();
    const auto* area = panel->findChild<QScrollArea*>();
    QVERIFY2(area->widget()->sizeHint().width() <= area->viewport()->width(), "names and ranges are cut off");
    f.curves->chooseSpan(30.0);
    QCOMPARE(panel->findChild<QLineEdit*>(QStringLiteral("curve_span"))->text(), QStringLiteral("30"));
    const std::size_t stretch = f.indexOf("stretch");
    QVERIFY(!f.curves->strip(stretch)->isVisible());
    panel->shownBox(stretch)->setFocus();
    QTest::keyClick(panel->shownBox(stretch), Qt::Key_Space);
    QVERIFY(f.curves->strip(stretch)->isVisible());
    for (std::size_t i = 0; i < f.curves->stack()->size(); ++i) {
      if (panel->shownBox(i)->isChecked()) panel->shownBox(i)->click();
    }
    int shown = 0;
    for (std::size_t i = 0; i < f.curves->stack()->size(); ++i) {
      shown += f.curves->stack()->shown(i) ? 1 : 0;
      QCOMPARE(panel->shownBox(i)->isChecked(), f.curves->stack()->shown(i));
    }
    QCOMPARE(shown, 1);
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("close_curve_setup")), Qt::LeftButton);
    QVERIFY(!panel->isVisible());
    f.key(Qt::Key_C);  // the key knows that it was closed
    QVERIFY(panel->isVisible());
  }

  void rangesAreTakenAndBadEntriesAreSaidInWords() {
    CurveFixture f;
    f.key(Qt::Key_C);
    widgets::CurveSetupPanel* panel = f.tools->panel();
    const auto enter = [&](QLineEdit* field, const char* text) {
      field->setFocus();
      field->setText(QString::fromUtf8(text));
      field->setModified(true);  // as by a key
      QTest::keyClick(field, Qt::Key_Return);
    };
    enter(panel->lowerField(0), "−1,5");
    enter(panel->upperField(0), "8");
    QCOMPARE(f.curves->strip(0)->shownRange(), (widgets::Range{-1.5, 8.0}));
    f.curves->follow();  // an operator's choice outlives following again
    QCOMPARE(f.curves->strip(0)->shownRange(), (widgets::Range{-1.5, 8.0}));
    for (const char* wrong : {"soft", "nan", "inf", "1e99", "-2", "-1.5"}) {
      enter(panel->upperField(0), wrong);
      QVERIFY2(panel->problem().contains(QString::fromUtf8(wrong)), wrong);
      QCOMPARE(f.curves->strip(0)->shownRange(), (widgets::Range{-1.5, 8.0}));
    }
    for (const char* beyond : {"1e10", "-1e10"}) {
      enter(panel->upperField(0), beyond);
      QVERIFY2(panel->problem().contains(QStringLiteral("to 1000000000")), qPrintable(panel->problem()));
    }
    for (QLineEdit* field : {panel->lowerField(0), panel->upperField(0)}) enter(field, "");
    QVERIFY(panel->problem().isEmpty());
    QVERIFY(!f.curves->strip(0)->chosenRange());
    for (const char* wrong : {"", "0", "-3", "nan", "x", "500", "2000000000"}) {
      enter(panel->spanField(), wrong);
      QVERIFY2(panel->problem().contains(QStringLiteral("0.02 to 240 s")), wrong);
      QCOMPARE(f.curves->timeWindow().span_s(), 10.0);
    }
    enter(panel->spanField(), "2.5");
    QCOMPARE(f.curves->timeWindow().span_s(), 2.5);
    // Going through fields in which nothing is written changes nothing.
    f.curves->strip(0)->chooseRange(widgets::Range{1.0, 2.0});
    panel->lowerField(0)->setFocus();
    for (int i = 0; i < 2; ++i) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(f.curves->strip(0)->shownRange(), (widgets::Range{1.0, 2.0}));
    f.curves->strip(0)->chooseRange(std::nullopt);
    f.key(Qt::Key_R);
    const widgets::Range held = f.curves->strip(0)->shownRange();
    auto high = rise(10, 4.0);
    for (auto& sample : high) sample.force_N = 1000.0;
    f.curves->append(high);
    f.curves->redraw();
    QCOMPARE(f.curves->strip(0)->shownRange(), held);
    f.key(Qt::Key_R);
    f.curves->redraw();
    QVERIFY(f.curves->strip(0)->shownRange().upper >= 1000.0);
  }

  void limitsStandWhereTheParametersSetThem() {
    CurveFixture f;
    const auto limits = [&](const char* id) { return f.curves->strip(f.indexOf(id))->limits(); };
    QCOMPARE(limits("stiffness"), (std::vector{0.501, 0.715}));  // what the law gives within the travel
    QCOMPARE(limits("stretch"), (std::vector{20.0, 90.0}));
    QCOMPARE(limits("translation"), (std::vector{-120.0, 120.0}));
    QVERIFY2(std::abs(limits("force")[1] - 19.51) < 0.01, qPrintable(QString::number(limits("force")[1])));
    QCOMPARE(limits("vibration"), (std::vector{-100.0, 100.0}));
    QVERIFY(limits("indentation").empty());
    f.row("texture.maximum_percent")->slider()->setValue(0);
    const double most = f.session->profile.step.texture.maximum_percent;
    QVERIFY(most < 100.0);
    QCOMPARE(limits("vibration"), (std::vector{-most, most}));
    f.session->profile.step.control.travel_maximum_deg = 60.0;  // as the session begins anew with another profile
    f.window->frame()->go(QStringLiteral("calibrate"));
    f.window->frame()->go(QStringLiteral("operate"));
    QCOMPARE(limits("stiffness"), (std::vector{0.501, 0.673}));
  }

  void aDragOverTheOverviewShowsThatTimeWhicheverWayItGoes() {
    widgets::SessionOverview overview;
    overview.resize(600, 72);
    overview.setDuration(60.0);
    std::vector<std::pair<double, double>> asked;
    connect(&overview, &widgets::SessionOverview::windowAsked, &overview,
            [&](double from_s, double to_s) { asked.emplace_back(from_s, to_s); });
    const auto drag = [&](double from_s, double to_s) {
      const auto at = [&](double time_s) { return QPoint(static_cast<int>(std::lround(overview.xOf(time_s))), 30); };
      QTest::mousePress(&overview, Qt::RightButton, {}, at(from_s));
      QTest::mouseMove(&overview, at(0.5 * (from_s + to_s)));
      QTest::mouseRelease(&overview, Qt::RightButton, {}, at(to_s));
    };
    drag(10.0, 40.0);
    drag(40.0, 10.0);
    drag(20.0, 20.0);  // a click asks for nothing
    QCOMPARE(asked.size(), 2U);
    for (const auto& [from_s, to_s] : asked) {
      QVERIFY2(std::abs(from_s - 10.0) < 0.2, qPrintable(QString::number(from_s)));
      QVERIFY2(std::abs(to_s - 40.0) < 0.2, qPrintable(QString::number(to_s)));
    }
  }

  void timeIsUnlinkedAndLinkedAgain() {
    CurveFixture f;
    CurveStack* stack = f.curves->stack();
    f.key(Qt::Key_T);
    QVERIFY(!stack->linked());
    QWidget* plot = f.curves->strip(1)->plot();
    const QPointF middle = plot->rect().center();
    QWheelEvent wheel(middle, plot->mapToGlobal(middle), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot, &wheel);
    QCOMPARE(stack->window(0).span_s(), 10.0);
    QVERIFY(stack->window(1).span_s() < 8.0);
    const double span_s = stack->window(1).span_s();
    f.key(Qt::Key_T);
    QVERIFY(stack->linked());
    QCOMPARE(stack->window(0).span_s(), span_s);
    QVERIFY(f.tools->panel()->linkBox()->isChecked());
  }

  void unlinkedCurvesFollowOnlyWhenEachDoes() {
    CurveFixture f;
    CurveStack* stack = f.curves->stack();
    f.key(Qt::Key_T);
    QVERIFY(f.curves->following());
    QWidget* looked_back = f.curves->strip(0)->plot();
    const QPoint from = looked_back->rect().center();
    QTest::mousePress(looked_back, Qt::LeftButton, {}, from);
    QTest::mouseMove(looked_back, from + QPoint(40, 0));
    QTest::mouseRelease(looked_back, Qt::LeftButton, {}, from + QPoint(40, 0));
    QVERIFY(!stack->window(0).following());
    QVERIFY(!f.curves->following());
    QWidget* plot = f.curves->strip(1)->plot();
    const QPointF middle = plot->rect().center();
    QWheelEvent wheel(middle, plot->mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot, &wheel);  // the one moved last follows
    QVERIFY(stack->window(1).following());
    QVERIFY(!f.curves->following());
    f.key(Qt::Key_Space);
    QVERIFY(stack->window(0).following());
    QVERIFY(f.curves->following());
  }

  void picturesAndValuesAreWrittenAndNothingIsWrittenOver() {
    CurveFixture f;
    f.key(Qt::Key_G, Qt::ControlModifier);
    WAIT_FOR(f.told().contains(QStringLiteral(".png is written")));
    QVERIFY(QImage(f.saved("png")).width() > 400);
    const QString first = f.saved("png");
    QVERIFY(f.tools->saver().pathFor(QStringLiteral("png")) != first);
    f.window->commands().action(QStringLiteral("curves.save_svg"))->trigger();
    WAIT_FOR(f.told().contains(QStringLiteral(".svg is written")));
    QFile svg(f.saved("svg"));
    QVERIFY(svg.open(QIODevice::ReadOnly));
    QVERIFY(svg.readAll().contains("<polyline"));
    f.window->commands().action(QStringLiteral("curves.save_pdf"))->trigger();
    WAIT_FOR(f.told().contains(QStringLiteral(".pdf is written")));
    QFile pdf(f.saved("pdf"));
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    QVERIFY(pdf.readAll().startsWith("%PDF"));
    f.curves->chooseSpan(1);
    f.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    WAIT_FOR(f.told().contains(QStringLiteral(".csv is written")));
    QFile csv(f.saved("csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().split('\n');
    QVERIFY(lines.front().startsWith("time [s],force_N [N],indentation_mm [mm]"));
    QCOMPARE(lines.size(), qsizetype{1003});  // what is shown: 1 s with both ends, the names, the end
    QVERIFY(lines.at(1).startsWith("2.999000,2.999,2,nan"));
  }

  void aPictureOfAHeldRangeShowsTheCurveCutOffAtItsEdges() {
    CurveFixture f;
    auto far = rise(1000, 4.0);
    for (std::size_t i = 0; i < far.size(); ++i) far[i].force_N = i % 2 == 0 ? 1e6 : -1e6;
    f.curves->append(far);
    for (std::size_t i = 1; i < f.curves->stack()->size(); ++i) f.curves->stack()->setShown(i, false);
    f.curves->strip(0)->chooseRange(widgets::Range{1.0, 2.0});  // the rise passes through it in a fifth of the time
    f.curves->chooseSpan(5);
    f.curves->redraw();
    QApplication::processEvents();
    f.curves->redraw();
    const widgets::CurveStrip* strip = f.curves->strip(0);
    const auto svg = widgets::pictureOf(*f.curves->stack(), widgets::PictureKind::svg, QStringLiteral("held"));
    QVERIFY(svg.has_value());
    // In the strip's own pixels, as the file's lines are.
    const QRectF inside = strip->plot()->axisRect()->rect().adjusted(-1, -1, 2, 2);
    const QRegularExpression lines(QStringLiteral("<polyline[^>]*points=\"([^\"]*)\""));
    double least_y = inside.bottom(), greatest_y = inside.top(), rise_px = 0.0;
    for (const auto& line : lines.globalMatch(QString::fromUtf8(*svg))) {
      double first_x = -1.0;
      for (const QString& point : line.captured(1).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const double x = point.section(QLatin1Char(','), 0, 0).toDouble();
        const double y = point.section(QLatin1Char(','), 1, 1).toDouble();
        QVERIFY2(inside.contains(x, y), qPrintable(point));
        least_y = std::min(least_y, y);
        greatest_y = std::max(greatest_y, y);
        if (first_x < 0.0) first_x = x;
        if (x < 0.7 * inside.right()) rise_px = std::max(rise_px, x - first_x);
      }
    }
    QVERIFY2(greatest_y - least_y > 0.9 * (inside.height() - 3), qPrintable(QString::number(greatest_y - least_y)));
    // And what lies outside is no line along the edge.
    QVERIFY2(rise_px > 0.1 * inside.width() && rise_px < 0.3 * inside.width(), qPrintable(QString::number(rise_px)));
  }

  void aPictureShowsALoneSampleAndTheWindowKeepsIt() {
    CurveFixture f;
    auto gaps = rise(1000, 4.0);
    constexpr double kAlone_N = 1.5;
    for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i].force_N = i == 500 ? kAlone_N : std::nan("");
    f.curves->append(gaps);
    for (std::size_t i = 1; i < f.curves->stack()->size(); ++i) f.curves->stack()->setShown(i, false);
    f.curves->strip(0)->chooseRange(widgets::Range{1.0, 2.0});
    f.curves->chooseSpan(5);
    f.curves->redraw();
    QApplication::processEvents();
    f.curves->redraw();
    widgets::CurveStrip& strip = *f.curves->strip(0);
    const QCustomPlot& plot = *strip.plot();
    const auto drawn = [&plot] {
      std::vector<std::pair<double, double>> points;
      for (const QCPGraphData& point : *plot.graph(0)->data()) points.emplace_back(point.key, point.value);
      return points;
    };
    const auto before = drawn();
    const auto alone = std::ranges::find_if(
        before, [](const auto& point) { return point.first > -0.9 && std::isfinite(point.second); });
    QVERIFY(alone != before.end());
    QCOMPARE(alone->second, kAlone_N);
    const double share = (alone->first - plot.xAxis->range().lower) / plot.xAxis->range().size();
    QVERIFY(spikeOnScreen(strip, share, kAlone_N));
    const double at_y_px = plot.yAxis->coordToPixel(kAlone_N);
    const auto svg = widgets::pictureOf(*f.curves->stack(), widgets::PictureKind::svg, QStringLiteral("alone"));
    QVERIFY(svg.has_value());
    const QRegularExpression lines(QStringLiteral("<polyline[^>]*points=\"([^\"]*)\""));
    int dots = 0;
    for (const auto& line : lines.globalMatch(QString::fromUtf8(*svg))) {
      const QStringList points = line.captured(1).split(QLatin1Char(' '), Qt::SkipEmptyParts);
      if (points.size() != 2) continue;
      const auto number = [&points](int point, int axis) {
        return points[point].section(QLatin1Char(','), axis, axis).toDouble();
      };
      // The picture is wider than the strip, not higher.
      dots += std::abs(number(0, 1) - at_y_px) < 1.0 && std::abs(number(1, 0) - number(0, 0)) < 0.1 &&
              number(0, 0) > plot.axisRect()->left();
    }
    QCOMPARE(dots, 1);
    // A gap is no number, which equals nothing, itself neither.
    QVERIFY(std::ranges::equal(drawn(), before, [](const auto& a, const auto& b) {
      return a.first == b.first && (a.second == b.second || (std::isnan(a.second) && std::isnan(b.second)));
    }));
    QVERIFY(spikeOnScreen(strip, share, kAlone_N));
  }

  void aPictureThatCannotBeWrittenIsToldWithItsPath() {
    CurveFixture f;
    f.tools->saver().setFolder(QStringLiteral("/proc/nothing"));
    f.key(Qt::Key_G, Qt::ControlModifier);
    WAIT_FOR(f.told().contains(QStringLiteral("/proc/nothing")));
    f.tools->saver().setFolder(f.folder.filePath(QStringLiteral("full")));
    bool told = false;
    {
      const FilesOfAtMost small(1024);
      f.key(Qt::Key_G, Qt::ControlModifier);
      told = QTest::qWaitFor([&] { return f.told().contains(QStringLiteral("is not written")); }, kPatience_ms);
    }
    QVERIFY(told);
    QVERIFY(f.saved("png").isEmpty());  // and half a picture is not left behind
  }

  void theSpectrumReadsTheVibrationInItsUnit() {
    CurveFixture f;
    f.key(Qt::Key_S);
    widgets::SpectrumView* spectrum = f.tools->spectrum();
    QVERIFY(spectrum->isVisible());
    // 0.5 g at 125 Hz.
    WAIT_EQUAL(spectrum->words(), QStringLiteral("largest 4.903 m/s² at 125 Hz"));
    QCOMPARE(spectrum->shown().resolution_Hz * static_cast<double>(spectrum->shown().bins - 1), 500.0);
    spectrum->scaleBox()->setCurrentIndex(1);
    QCOMPARE(spectrum->words(), QStringLiteral("largest 4.903 m/s² at 125 Hz"));
    spectrum->signalBox()->setCurrentIndex(1);  // no robot speaks: no acceleration
    QVERIFY(spectrum->words().contains(QStringLiteral("is needed")));
    f.key(Qt::Key_S);
    QVERIFY(!spectrum->isVisible());
  }

  void aSpikeInTenMillionSamplesIsOnTheScreenAtEveryZoom() {
    constexpr std::size_t kSamples = 10'000'000;
    constexpr std::size_t kSpike = std::size_t{65536} * 100;
    widgets::CurveBuffer buffer(1, kSamples);
    std::mt19937 random(11);
    std::vector<std::size_t> spikes = {0, 1, kSamples - 1, kSpike, kSpike - 1};
    for (int i = 0; i < 20; ++i) spikes.push_back(random() % kSamples);
    std::ranges::sort(spikes);
    std::size_t next = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      float value[] = {static_cast<float>(i % 17) * 0.05F};
      if (next < spikes.size() && spikes[next] == i) {
        value[0] = 10.0F;
        ++next;
      }
      (void)buffer.append(0.001 * static_cast<double>(i), value);
    }
    widgets::CurveStrip strip(QStringLiteral("Force"), QStringLiteral("N"), {0, 2},
                              {{.channel = 0, .quantity = widgets::Quantity::force}}, true);
    strip.resize(640, 160);
    strip.show();
    QVERIFY(QTest::qWaitForWindowExposed(&strip, kPatience_ms));
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    std::vector<widgets::CurveColumn> columns;
    double span_s = 0.02;
    for (int i = 0; i < 14; ++i, span_s *= 2.6) {  // up to about 5000 s
      for (const double share : {0.0, 0.0004, anywhere(random), anywhere(random), 0.9996, 1.0}) {
        const std::size_t spike = spikes[random() % spikes.size()];
        const double at_s = 0.001 * static_cast<double>(spike);
        // A sample exactly at an edge may fall to either side of it by a rounding.
        const double from_s = at_s - std::clamp(share, 1e-6, 1.0 - 1e-6) * span_s;
        buffer.decimate(0, from_s, from_s + span_s, 640, columns);
        const QByteArray where =
            QStringLiteral("sample %1, %2 s shown, at %3").arg(spike).arg(span_s).arg(share).toUtf8();
        QVERIFY2(std::ranges::any_of(columns, [](const auto& c) { return c.maximum == 10.0F; }), where);
        widgets::TimeWindow window(2e4);
        window.show(from_s, from_s + span_s);
        strip.draw(buffer, window);
        QVERIFY2(spikeOnScreen(strip, share, 10.0), where);
      }
    }
  }

  void hoursOfSamplesPassAndMemoryStays() {
    widgets::CurveView view;
    view.resize(600, 400);
    view.chooseSpan(60);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, kPatience_ms));
    const auto resident_pages = [] {
      QFile file(QStringLiteral("/proc/self/statm"));
      return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(1).toLongLong() : 0;
    };
    // The ring goes round in 4.4 min; 20 min more are four times that.
    constexpr int kFilled = 5, kMinutes = 25;
    qint64 filled_pages = 0;
    for (int minute = 0; minute < kMinutes; ++minute) {
      auto samples = rise(60'000, 60.0 * minute);
      samples[30'000].force_N = 1e6;  // one sample; seen in every minute
      view.append(samples);
      view.redraw();
      QCOMPARE(view.strip(0)->drawnExtent().upper, 1e6);
      QCOMPARE(view.timeWindow().to_s(), view.buffer().lastTime_s());  // the newest is what is shown
      QApplication::processEvents();
      if (minute == kFilled) filled_pages = resident_pages();
    }
    QVERIFY(view.buffer().size() <= view.buffer().capacity());
    const qint64 grown = resident_pages() - filled_pages;
    QVERIFY2(grown < filled_pages / 10, qPrintable(QString::number(grown)));
  }

  void everyQuantityHasItsFieldAndTheFirstAreThoseReviewReckonsWith() {
    const auto fields = pipeline::telemetryFields();
    for (std::size_t c = 0; c < widgets::kCurveChannels; ++c) {
      QVERIFY2(widgets::curveFields()[c] < fields.size(), widgets::curveQuantities()[c].field);
    }
    for (std::size_t q = 0; q < console::kReviewQuantities.size(); ++q) {
      QCOMPARE(std::string(console::kReviewQuantities[q].field), std::string(widgets::curveQuantities()[q].field));
    }
    std::set<std::size_t> drawn;
    for (const widgets::StripPlan& plan : widgets::stripPlans())
      drawn.insert(plan.channels.begin(), plan.channels.end());
    QCOMPARE(drawn.size(), std::size_t{widgets::kCurveChannels});
  }
};

std::unique_ptr<QObject> makeCurveToolsTest() { return std::make_unique<CurveToolsTest>(); }

}  // namespace fyd::tests

#include "curve_tools_test.moc"
