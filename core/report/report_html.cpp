// The report as one HTML file: the figure as inline SVG, no scripts, no external resources.
#include <cairo-svg.h>

#include "core/report/cairo_document.h"
#include "core/report/report.h"

namespace fyd::report {
namespace {

constexpr std::string_view kStyle = R"(
body { font: 15px/1.45 "DejaVu Sans", Verdana, sans-serif; color: #14181c; background: #fff; margin: 2rem auto;
       max-width: 60rem; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .4rem; }
dl { display: grid; grid-template-columns: 9rem 1fr; gap: .15rem 1rem; margin: 0; }
dt { color: #55606a; } dd { margin: 0; white-space: pre-wrap; overflow-wrap: anywhere; }
figure { margin: 1.5rem 0; } figure svg { width: 100%; height: auto; }
figcaption, p { color: #55606a; font-size: .85rem; margin: .2rem 0; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; width: 100%; font-size: .85rem; }
th { text-align: left; vertical-align: bottom; border-bottom: 1px solid #55606a; padding: .25rem .5rem; }
td { border-bottom: 1px solid #e6e9ec; padding: .2rem .5rem; vertical-align: top; white-space: pre-wrap;
     overflow-wrap: anywhere; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
@media print { body { margin: 0; max-width: none; } tr { break-inside: avoid; } }
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  }
  return out;
}

Result<std::string> figureSvg(const ReportContent& content) {
  auto drawn = drawDocument("the figure", cairo_svg_surface_create_for_stream, kReportWidth, figureHeight(content),
                            [&](cairo_t* cairo, cairo_surface_t*) { drawFigure(cairo, content); });
  if (!drawn) return drawn;
  const std::string& svg = *drawn;
  const std::size_t begin = svg.find("<svg");  // without the XML declaration, which HTML does not allow
  return begin == std::string::npos ? svg : svg.substr(begin);
}

std::string tableHtml(const ReportTable& table) {
  std::string html = fmt::format("<h2>{}</h2>\n", escaped(table.heading));
  if (!table.remark.empty()) html += fmt::format("<p>{}</p>\n", escaped(table.remark));
  if (table.rows.empty()) return html;
  const auto cell = [&](const char* tag, std::size_t column, std::string_view text) {
    const char* number = table.columns[column].number ? " class=\"n\"" : "";
    html += fmt::format("<{}{}>{}</{}>", tag, number, escaped(text), tag);
  };
  html += "<div class=\"scroll\"><table>\n<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c) cell("th", c, table.columns[c].title);
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) cell("td", c, row[c]);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

Result<std::string> reportHtml(const ReportContent& content) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += fmt::format(
      "<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n"
      "<h1>{0}</h1>\n<dl>\n",
      escaped(content.title), kStyle);
  for (const auto& [what, text] : content.facts) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(text));
  }
  html += "</dl>\n<figure>\n";
  if (!content.strips.empty()) {
    auto svg = figureSvg(content);
    if (!svg) return svg;
    html += fmt::format("<div role=\"img\" aria-label=\"{}\">\n{}</div>\n", escaped(content.figure), *svg);
  }
  html += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", escaped(content.legend));
  for (const ReportTable& table : content.tables) html += tableHtml(table);
  return html + "</body>\n</html>\n";
}

}  // namespace fyd::report
