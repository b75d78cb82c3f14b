#include "core/base/csv.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <csv.h>
#include "core/base/whole_file.h"

namespace fyd {
namespace {

struct Reader {
  std::string_view source;
  const std::vector<std::string>& wanted;
  EmptyField empty;
  CsvTable table;
  std::vector<std::size_t> position;  // of each wanted column in the file
  std::vector<std::string> header;
  std::vector<double> row;
  std::size_t columns_seen = 0;
  std::size_t line = 1;
  bool has_header = false;
  Message problem;

  void field(std::string_view text) {
    if (!problem.empty()) return;
    if (!has_header) {
      if (header.size() == kMostCsvColumns) {
        problem = say("{}:{}: more than {} columns; expected a table of measurements", source, line, kMostCsvColumns);
        return;
      }
      header.emplace_back(text);
    } else {
      for (std::size_t i = 0; i < position.size(); ++i) {
        if (position[i] == columns_seen) row[i] = number(text, wanted[i]);
      }
    }
    ++columns_seen;
  }

  double number(std::string_view text, const std::string& column) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    if (text.empty() && empty == EmptyField::nan) return std::numeric_limits<double>::quiet_NaN();
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) {
      problem = say("{}:{}: column {}: '{}' is not a number", source, line, column, text.substr(0, 40));
    }
    return value;
  }

  void endRow() {
    if (problem.empty()) {
      if (!has_header) {
        takeHeader();
      } else if (columns_seen != header.size()) {
        problem = say("{}:{}: {} fields; the header has {}", source, line, columns_seen, header.size());
      } else {
        for (std::size_t i = 0; i < row.size(); ++i) table.values[i].push_back(row[i]);
        table.lines.push_back(line);
      }
    }
    columns_seen = 0;
  }

  void takeHeader() {
    has_header = true;
    for (const std::string& name : wanted) {
      std::size_t i = 0;
      while (i < header.size() && header[i] != name) ++i;
      if (i == header.size()) {
        problem = say("{}:{}: no column '{}'; expected {}", source, line, name, fmt::join(wanted, ","));
        return;
      }
      if (std::find(header.begin() + static_cast<std::ptrdiff_t>(i) + 1, header.end(), name) != header.end()) {
        problem = say("{}:{}: column '{}' stands there more than once; expected each name once", source, line, name);
        return;
      }
      position.push_back(i);
    }
    row.resize(wanted.size());
    table.columns = wanted;
    table.values.resize(wanted.size());
  }
};

}  // namespace

Result<CsvTable> parseCsv(std::string_view text, std::string_view source_name, const std::vector<std::string>& wanted,
                          EmptyField empty) {
  Reader reader{.source = source_name,
                .wanted = wanted,
                .empty = empty,
                .table = {},
                .position = {},
                .header = {},
                .row = {},
                .problem = {}};
  csv_parser parser{};
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0)
    return fail("{}: the CSV parser could not start", source_name);
  const auto on_field = [](void* data, std::size_t size, void* self) {
    static_cast<Reader*>(self)->field({static_cast<const char*>(data), size});
  };
  const auto on_row = [](int, void* self) { static_cast<Reader*>(self)->endRow(); };
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  bool parsed = true;
  reader.line = 0;
  while (parsed && !text.empty()) {  // line by line, because libcsv does not count the blank ones
    std::size_t size = std::min(text.find_first_of("\r\n"), text.size() - 1) + 1;
    if (text.substr(size - 1).starts_with("\r\n")) ++size;
    const std::string_view line = text.substr(0, size);
    ++reader.line;
    parsed = csv_parse(&parser, line.data(), line.size(), on_field, on_row, &reader) == line.size();
    text.remove_prefix(line.size());
  }
  parsed = parsed && csv_fini(&parser, on_field, on_row, &reader) == 0;
  const char* parser_problem = csv_strerror(csv_error(&parser));
  csv_free(&parser);
  if (!reader.problem.empty()) return fail(std::move(reader.problem));
  if (!parsed) return fail("{}:{}: not valid CSV: {}", source_name, reader.line, verbatim(parser_problem));
  if (!reader.has_header) return fail("{}: empty; expected a header with {}", source_name, fmt::join(wanted, ","));
  if (reader.table.rows() == 0) return fail("{}: a header but no rows", source_name);
  reader.table.header = std::move(reader.header);
  return std::move(reader.table);
}

Result<void> checkLength(double length_s, double most_s) {
  if (!(length_s <= most_s)) {
    return fail("{} s from the first row to the last; expected at most {}: are the times in seconds?", length_s,
                most_s);
  }
  return {};
}

Result<CsvTable> readCsv(const std::string& path, const std::vector<std::string>& wanted, EmptyField empty) {
  const auto text = readWholeFile(path, kLargestCsv_bytes, FileKind::pipe_too);
  if (!text) return tl::unexpected(text.error());
  return parseCsv(*text, path, wanted, empty);
}

}  // namespace fyd
