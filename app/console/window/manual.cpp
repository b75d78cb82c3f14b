#include "app/console/window/manual.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QWidget>
#include <algorithm>
#include <map>

#include "app/console/shell/language.h"

namespace fyd::console {
namespace {

const QString kFolder = QStringLiteral(":/fyd/manual/");

struct Topic {
  const char* of;  ///< class of a widget, or a place
  const char* page;
};

constexpr Topic kWidgets[] = {
    {"fyd::widgets::StateBar", "operate.md#state-bar"},
    {"fyd::widgets::LinkPanel", "operate.md#link"},
    {"fyd::widgets::RobotForm", "operate.md#link"},
    {"fyd::widgets::ConnectionForm", "devices.md#choosing-and-connecting-in-the-window"},
    {"fyd::console::SceneDock", "operate.md#scene"},
    {"fyd::widgets::GuideStrip", "first-session.md#in-the-window"},
    {"fyd::widgets::CameraPanel", "operate.md#camera"},
    {"fyd::widgets::CurveView", "operate.md#curves"},
    {"fyd::widgets::CurveSetupPanel", "operate.md#curves"},
    {"fyd::widgets::SpectrumView", "operate.md#curves"},
    {"fyd::widgets::TuningPanel", "operate.md#tuning"},
    {"fyd::widgets::TuningList", "tuning.md#a-value"},
    {"fyd::widgets::TuningCompare", "tuning.md#a-and-b"},
    {"fyd::widgets::TuningDifferences", "tuning.md#a-and-b"},
    {"fyd::widgets::TuningPresetList", "tuning.md#presets"},
    {"fyd::widgets::TuningResponse", "tuning.md#step-response"},
    {"fyd::widgets::TuningProposal", "tuning.md#auto-tune"},
    {"fyd::widgets::TuningReadback", "tuning.md#read-back"},
    {"fyd::widgets::RecordingForm", "operate.md#recording"},
    {"fyd::widgets::ReadinessList", "operate.md#start-work-stop"},
    {"fyd::widgets::LogView", "operate.md#notices-and-log"},
    {"fyd::widgets::NoticeStack", "operate.md#notices-and-log"},
    {"fyd::console::SessionList", "review.md#finding-a-session"},
    {"fyd::widgets::ProgressBars", "review.md#long-work"},
    {"fyd::console::TouchTable", "review.md#touches"},
    {"fyd::console::FiguresTable", "review.md#figures-between-a-and-b"},
    {"fyd::console::WhatIfPanel", "review.md#what-if"},
    {"fyd::console::NoteTable", "review.md#notes-and-tags"},
    {"fyd::console::CalibrationFitPanel", "calibration.md#what-the-answer-says"},
    {"fyd::console::LayoutsDialog", "operate.md#panels-and-layouts"},
    {"fyd::console::CommandPalette", "operate.md#keys"},
    {"fyd::widgets::NavigationBar", "operate.md#places"},
};

constexpr Topic kPlaces[] = {
    {"operate", "operate.md"}, {"calibrate", "calibration.md#in-the-window"},
    {"review", "review.md"},   {"devices", "operate.md#devices"},
    {"tune", "tuning.md"},
};

/// In the window's language where there is one, else in English.
QString placeOf(const QString& page) {
  const QString translated = kFolder + spoken() + QLatin1Char('/') + page;
  return QFile::exists(translated) ? translated : kFolder + page;
}

QString read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// In the order of the list of pages; pages missing there come last.
QStringList pages() {
  QStringList out = {QStringLiteral("README.md")};
  static const QRegularExpression kLink(QStringLiteral("\\]\\(([\\w-]+\\.md)\\)"));
  for (auto all = kLink.globalMatch(read(kFolder + out.first())); all.hasNext();) {
    const QString page = all.next().captured(1);
    if (!out.contains(page)) out << page;
  }
  for (const QString& page : QDir(kFolder).entryList({QStringLiteral("*.md")})) {
    if (!out.contains(page)) out << page;
  }
  return out;
}

/// A heading as a link names it: "Start, work, stop" is "start-work-stop".
QString headingLink(const QString& heading) {
  QString link;
  for (const QChar c : heading.toLower()) {
    if (c.isLetterOrNumber() || c == QLatin1Char('-') || c == QLatin1Char('_')) link += c;
    if (c == QLatin1Char(' ')) link += QLatin1Char('-');
  }
  return link;
}

std::vector<ManualSection> split(const QString& page, const QString& path) {
  static const QRegularExpression kHeading(QStringLiteral("^#{1,6} +(.*?)\\s*$"));
  std::vector<ManualSection> out;
  bool quoted = false;
  for (const QString& line : read(path).split(QLatin1Char('\n'))) {
    if (line.startsWith(QLatin1String("```"))) quoted = !quoted;
    const auto match = kHeading.match(line);
    if (match.hasMatch() && !quoted) {
      const QString heading = match.captured(1).remove(QLatin1Char('`'));
      const QString title = out.empty() ? heading.section(QLatin1Char(':'), 0, 0) : out.front().title;
      out.push_back({page, page + QLatin1Char('#') + headingLink(heading), title, heading, {}});
    } else if (!out.empty()) {
      out.back().text += line + QLatin1Char('\n');
    }
  }
  return out;
}

/// The sections of the shown page, with topics from its English headings.
std::vector<ManualSection> sectionsOf(const QString& page) {
  const std::vector<ManualSection> english = split(page, kFolder + page);
  std::vector<ManualSection> shown = split(page, placeOf(page));
  for (std::size_t i = 0; i < std::min(english.size(), shown.size()); ++i) shown[i].topic = english[i].topic;
  return shown;
}

}  // namespace

const std::vector<ManualSection>& manualSections() {
  static std::map<QString, std::vector<ManualSection>> of_language;
  std::vector<ManualSection>& sections = of_language[spoken()];
  if (sections.empty()) {
    for (const QString& page : pages()) std::ranges::move(sectionsOf(page), std::back_inserter(sections));
  }
  return sections;
}

QUrl manualPage(const QString& page) { return QUrl(QStringLiteral("qrc") + placeOf(page)); }

int manualHeading(const QString& topic) {
  int number = 0;
  for (const ManualSection& each : manualSections()) {
    if (each.topic == topic) return number;
    if (each.page == topic.section(QLatin1Char('#'), 0, 0)) ++number;
  }
  return -1;
}

std::vector<ManualSection> searchManual(const QString& words, std::size_t at_most) {
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (wanted.isEmpty()) return {};
  const auto holds = [&](const QString& text) {
    return std::ranges::all_of(wanted, [&](const QString& w) { return text.contains(w, Qt::CaseInsensitive); });
  };
  std::vector<ManualSection> in_heading;
  std::vector<ManualSection> in_text;
  for (const ManualSection& each : manualSections()) {
    if (holds(each.heading)) {
      in_heading.push_back(each);
    } else if (holds(each.heading + QLatin1Char('\n') + each.text)) {
      in_text.push_back(each);
    }
  }
  in_heading.insert(in_heading.end(), in_text.begin(), in_text.end());
  in_heading.resize(std::min(in_heading.size(), at_most));
  return in_heading;
}

QString manualTopic(const QWidget* focus, const QString& place) {
  for (const QWidget* each = focus; each != nullptr; each = each->parentWidget()) {
    for (const Topic& topic : kWidgets) {
      if (each->inherits(topic.of)) return QLatin1String(topic.page);
    }
  }
  for (const Topic& topic : kPlaces) {
    if (place == QLatin1String(topic.of)) return QLatin1String(topic.page);
  }
  return QStringLiteral("README.md");
}

QStringList manualTopics() {
  QStringList out = {QStringLiteral("README.md")};
  for (const Topic& topic : kWidgets) out << QLatin1String(topic.page);
  for (const Topic& topic : kPlaces) out << QLatin1String(topic.page);
  return out;
}

}  // namespace fyd::console
