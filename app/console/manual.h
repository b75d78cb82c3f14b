// The manual's pages as the program carries them: their headings, a search through them, and which page and heading
// belongs to what is in focus.
#pragma once

#include <QString>
#include <QUrl>
#include <vector>

class QWidget;

namespace fyd::console {

/// A heading and what stands under it.
struct ManualSection {
  QString page;     ///< "operate.md"
  QString heading;  ///< "Curves"; of a page's first one: its title
  QString text;     ///< Markdown, without the heading
};

/// All, in the order of the manual's own list of pages.
[[nodiscard]] const std::vector<ManualSection>& manualSections();

/// A heading as a link names it: "Start, work, stop" is "start-work-stop".
[[nodiscard]] QString headingLink(const QString& heading);
[[nodiscard]] QUrl manualPage(const QString& page_and_heading);  ///< "operate.md#curves"

/// Those that hold every word, headings first. @param words empty: none
[[nodiscard]] std::vector<ManualSection> searchManual(const QString& words, std::size_t at_most = 40);

/// "operate.md#curves" for the curves; the place's page for what has none of its own.
[[nodiscard]] QString manualTopic(const QWidget* focus, const QString& place);
/// Every answer that `manualTopic` can give, for tests.
[[nodiscard]] QStringList manualTopics();

}  // namespace fyd::console
