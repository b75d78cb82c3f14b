// The manual's pages in the program's resources: their headings, a search through them, and the page and heading for
// the widget in focus. A page is shown in the window's language where it is translated (resources/manual/it), else in
// English. Topics and links name the English page and heading in every language: a translation has the same headings in
// the same order (tests/translations/manual.py), so a place is found by its heading's number.
#pragma once

#include <QString>
#include <QUrl>
#include <vector>

class QWidget;

namespace fyd::console {

/// A heading and the text under it.
struct ManualSection {
  QString page;     ///< "operate.md"
  QString topic;    ///< "operate.md#curves", in every language
  QString title;    ///< "Operate", of the page, without what follows its colon
  QString heading;  ///< "Curves", "Curve"; of a page's first one: its title
  QString text;     ///< Markdown, without the heading
};

/// All of the window's language, in the order of the manual's own list of pages.
[[nodiscard]] const std::vector<ManualSection>& manualSections();

/// Where the page is read from. @param page "operate.md"
[[nodiscard]] QUrl manualPage(const QString& page);
/// The number of the topic's heading among those of its page, from 0; -1 when there is no such heading.
[[nodiscard]] int manualHeading(const QString& topic);

/// Sections that contain every word, matches in headings first. @param words empty: none
[[nodiscard]] std::vector<ManualSection> searchManual(const QString& words, std::size_t at_most = 40);

/// "operate.md#curves" for the curves; the place's page for widgets without their own topic.
[[nodiscard]] QString manualTopic(const QWidget* focus, const QString& place);
/// Every answer that `manualTopic` can give, for tests.
[[nodiscard]] QStringList manualTopics();

}  // namespace fyd::console
