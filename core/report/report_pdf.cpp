// The report as A4 pages: text flows, tables continue on the next page with their header repeated.
#include <cairo-pdf.h>

#include <algorithm>

#include "core/report/cairo_document.h"
#include "core/report/chart_text.h"
#include "core/report/report.h"

namespace fyd::report {
namespace {

constexpr double kPageWidth = 595.0;
constexpr double kPageHeight = 842.0;
constexpr double kMargin = (kPageWidth - kReportWidth) / 2.0;
constexpr double kBottom = kPageHeight - 50.0;  ///< below it stands the page's number only
constexpr double kText = 8.0;
constexpr double kLine = 11.0;
constexpr double kCellGap = 8.0;

/// Writes downward, page after page.
class Pages {
 public:
  Pages(cairo_t* cairo, std::string footer) : cairo_(cairo), footer_(std::move(footer)) {}

  /// Goes to a new page when less than `height` is left. @return whether it did
  bool need(double height) {
    if (y_ + height <= kBottom) return false;
    endPage();
    y_ = kMargin;
    return true;
  }
  void skip(double height) { y_ += height; }

  void endPage() {
    setFont(cairo_, 7.0);
    setColour(cairo_, kMutedRgb);
    drawText(cairo_, kMargin, kPageHeight - 28.0, footer_);
    drawText(cairo_, kPageWidth - kMargin, kPageHeight - 28.0, fmt::format("page {}", ++page_), TextAlign::right);
    cairo_show_page(cairo_);
  }

  void heading(const std::string& text, double size, double room_after) {
    need(size + room_after);
    skip(size);
    setFont(cairo_, size, true);
    setColour(cairo_, kTextRgb);
    drawText(cairo_, kMargin, y_, text);
    skip(room_after);
  }

  void paragraph(const std::string& text, double x, double width, Rgb colour) {
    setFont(cairo_, kText);
    for (const std::string& line : wrapText(cairo_, text, width)) {
      need(kLine);
      setFont(cairo_, kText);
      setColour(cairo_, colour);
      skip(kLine);
      drawText(cairo_, x, y_ - 3.0, line);
    }
  }

  void fact(const std::string& what, const std::string& text) {
    constexpr double kIndent = 90.0;
    need(kLine);
    setFont(cairo_, kText);
    setColour(cairo_, kMutedRgb);
    drawText(cairo_, kMargin, y_ + kLine - 3.0, what);
    paragraph(text, kMargin + kIndent, kReportWidth - kIndent, kTextRgb);
  }

  void figure(const ReportContent& content) {
    need(figureHeight(content));
    cairo_save(cairo_);
    cairo_translate(cairo_, kMargin, y_);
    drawFigure(cairo_, content);
    cairo_restore(cairo_);
    skip(figureHeight(content));
  }

  void table(const ReportTable& table) {
    skip(14.0);
    need(70.0);  // no heading alone at a page's end
    heading(table.heading, 10.5, 4.0);
    if (!table.remark.empty()) paragraph(table.remark, kMargin, kReportWidth, kMutedRgb);
    if (table.rows.empty()) return;
    std::vector<std::string> titles;
    for (const ReportColumn& column : table.columns) titles.push_back(column.title);
    const auto header = [&] { row(table, titles, true); };
    header();
    for (const auto& cells : table.rows) {
      const double height = rowHeight(table, cells, false);
      // A row taller than a page is cut where the page ends by `row` itself.
      if (height < kBottom - kMargin - 4.0 * kLine && need(height)) header();
      row(table, cells, false);
    }
  }

 private:
  [[nodiscard]] std::vector<std::vector<std::string>> wrapped(const ReportTable& table,
                                                              const std::vector<std::string>& cells, bool bold) const {
    setFont(cairo_, kText, bold);
    std::vector<std::vector<std::string>> lines;
    for (std::size_t c = 0; c < cells.size(); ++c) lines.push_back(wrapText(cairo_, cells[c], width(table, c)));
    return lines;
  }
  [[nodiscard]] double width(const ReportTable& table, std::size_t column) const {
    double all = 0.0;
    for (const ReportColumn& c : table.columns) all += c.share;
    return kReportWidth * table.columns[column].share / all - kCellGap;
  }
  [[nodiscard]] double rowHeight(const ReportTable& table, const std::vector<std::string>& cells, bool bold) const {
    std::size_t most = 1;
    for (const auto& lines : wrapped(table, cells, bold)) most = std::max(most, lines.size());
    return kLine * static_cast<double>(most) + 2.0;
  }

  void row(const ReportTable& table, const std::vector<std::string>& cells, bool bold) {
    const auto lines = wrapped(table, cells, bold);
    std::size_t most = 1;
    for (const auto& cell : lines) most = std::max(most, cell.size());
    for (std::size_t line = 0; line < most; ++line) {
      need(kLine + 2.0);
      skip(kLine);
      setFont(cairo_, kText, bold);
      setColour(cairo_, kTextRgb);
      double x = kMargin;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        // Header cells are bottom-aligned.
        const std::size_t offset = bold ? most - lines[c].size() : 0;
        const bool number = table.columns[c].number;
        if (line >= offset && line - offset < lines[c].size()) {
          drawText(cairo_, number ? x + width(table, c) : x, y_ - 3.0, lines[c][line - offset],
                   number ? TextAlign::right : TextAlign::left);
        }
        x += width(table, c) + kCellGap;
      }
    }
    setColour(cairo_, bold ? kMutedRgb : kLineRgb);
    cairo_set_line_width(cairo_, 0.5);
    cairo_move_to(cairo_, kMargin, y_ + 0.5);
    cairo_line_to(cairo_, kMargin + kReportWidth, y_ + 0.5);
    cairo_stroke(cairo_);
    skip(2.0);
  }

  cairo_t* cairo_;
  std::string footer_;
  double y_ = kMargin;
  int page_ = 0;
};

}  // namespace

Result<std::string> reportPdf(const ReportContent& content) {
  return drawDocument("the report", cairo_pdf_surface_create_for_stream, kPageWidth, kPageHeight,
                      [&](cairo_t* cairo, cairo_surface_t* surface) {
                        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, content.title.c_str());
                        const std::string id = content.facts.empty() ? "" : content.facts.front().second;
                        Pages pages(cairo, fmt::format("FYD Console · {} · {}", content.kind, id));
                        pages.heading(content.title, 16.0, 8.0);
                        for (const auto& [what, text] : content.facts) pages.fact(what, text);
                        pages.skip(8.0);
                        if (!content.strips.empty()) pages.figure(content);
                        pages.paragraph(content.legend, kMargin, kReportWidth, kMutedRgb);
                        for (const ReportTable& table : content.tables) pages.table(table);
                        pages.endPage();
                      });
}

}  // namespace fyd::report
