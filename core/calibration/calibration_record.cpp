#include "core/calibration/calibration_record.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include <toml++/toml.h>

#include "core/calibration/calibration_part.h"

namespace fyd::calibration {
namespace {

constexpr std::int64_t kFormat = 1;

/// The record's fields, named once for reading and writing.
template <class Record, class Text, class Whole, class Number>
void eachField(Record& r, Text&& text, Whole&& whole, Number&& number) {
  text("procedure", r.procedure);
  text("who", r.who);
  text("when", r.when);
  text("conditions", r.conditions);
  text("curve", r.curve);
  text("unit", r.unit);
  text("verdict", r.verdict);
  whole("points", r.points);
  whole("outliers", r.outliers);
  number("rmse", r.rmse);
  number("held_out_rmse", r.held_out_rmse);
  number("max_residual", r.max_residual);
  number("condition_number", r.condition_number);
}

class RecordReader {
 public:
  explicit RecordReader(std::string_view source) : source_(source) {}

  CalibrationRecord read(const toml::table& table) {
    CalibrationRecord record;
    std::size_t known = 0;
    eachField(
        record, [&](const char* key, std::string& field) { known += take(table, key, field, say("a text")); },
        [&](const char* key, std::int64_t& field) { known += take(table, key, field, say("a whole number")); },
        [&](const char* key, double& field) {
          known += take(table, key, field, say("a number with a point, or nan"));
        });
    std::int64_t sensor = 0;
    known += take(table, "sensor", sensor, say("a whole number"));
    if (sensor < 0 || sensor > 8) complain(table, say("sensor: expected 0 to 8"));
    record.sensor = static_cast<int>(sensor);
    known += readResiduals(table, record);
    known += readChanges(table, record);
    if (known != table.size()) complain(table, say("a key that no record has"));
    return record;
  }
  void complain(const toml::node& node, Message what) {
    if (problem_.empty()) problem_ = about(fmt::format("{}:{}", source_, node.source().begin.line), std::move(what));
  }
  [[nodiscard]] const Message& problem() const { return problem_; }

 private:
  template <class T>
  std::size_t take(const toml::table& table, const char* key, T& field, Message expected) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
      complain(table, say("{} is missing", key));
      return 0;
    }
    if (const auto value = node->value_exact<T>()) {
      field = *value;
    } else {
      complain(*node, say("{}: expected {}", key, std::move(expected)));
    }
    return 1;
  }
  std::size_t readResiduals(const toml::table& table, CalibrationRecord& record) {
    const toml::node* node = table.get("residuals");
    if (node == nullptr) return 0;
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      complain(*node, say("residuals: expected a list of numbers"));
      return 1;
    }
    for (const toml::node& item : *array) {
      const auto value = item.value_exact<double>();
      if (!value) complain(item, say("residuals: expected numbers with a point"));
      record.residuals.push_back(value.value_or(kUnknown));
    }
    return 1;
  }
  std::size_t readChanges(const toml::table& table, CalibrationRecord& record) {
    const toml::node* node = table.get("change");
    if (node == nullptr) return 0;
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      complain(*node, say("change: expected [[record.change]]"));
      return 1;
    }
    for (const toml::node& item : *array) {
      const toml::table* change = item.as_table();
      if (change == nullptr || change->size() != 3) {
        complain(item, say("change: expected id, before and after"));
        continue;
      }
      AppliedChange& applied = record.changes.emplace_back();
      take(*change, "id", applied.id, say("a text"));
      take(*change, "before", applied.before, say("a text"));
      take(*change, "after", applied.after, say("a text"));
    }
    return 1;
  }

  std::string_view source_;
  Message problem_;
};

Result<std::chrono::sys_days> parseDay(std::string_view text) {
  int year = 0;
  unsigned month = 0, day = 0;
  const auto part = [&](std::size_t from, std::size_t size, auto& out) {
    if (text.size() < from + size) return false;
    const char* end = text.data() + from + size;
    const auto [stopped, problem] = std::from_chars(text.data() + from, end, out);
    return problem == std::errc{} && stopped == end;
  };
  const bool shaped = part(0, 4, year) && part(5, 2, month) && part(8, 2, day) && text[4] == '-' && text[7] == '-' &&
                      (text.size() == 10 || text[10] == 'T');
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  if (!shaped || !date.ok()) return fail("'{}': expected a date such as 2026-11-21", text.substr(0, 40));
  return std::chrono::sys_days(date);
}

}  // namespace

CalibrationRecord makeRecord(const CalibrationResult& result, std::vector<AppliedChange> changes, int sensor,
                             std::string who, std::string when, std::string conditions) {
  return {.procedure = result.procedure,
          .sensor = sensor,
          .who = std::move(who),
          .when = std::move(when),
          .conditions = std::move(conditions),
          .curve = result.curve.text(),
          .unit = result.unit,
          .verdict = result.verdict.reason.text(),
          .points = static_cast<std::int64_t>(result.points),
          .outliers = static_cast<std::int64_t>(result.outliers.size()),
          .rmse = result.rmse,
          .held_out_rmse = result.held_out_rmse,
          .max_residual = result.max_residual,
          .condition_number = result.condition_number,
          .residuals = result.residuals,
          .changes = std::move(changes)};
}

std::string formatRecords(std::span<const CalibrationRecord> records) {
  toml::array list;
  for (const CalibrationRecord& record : records) {
    toml::table table;
    const auto put = [&](const char* key, const auto& value) { table.insert(key, value); };
    eachField(record, put, put, put);
    put("sensor", static_cast<std::int64_t>(record.sensor));
    toml::array residuals, changes;
    for (const double residual : record.residuals) residuals.push_back(residual);
    for (const AppliedChange& change : record.changes) {
      changes.push_back(toml::table{{"id", change.id}, {"before", change.before}, {"after", change.after}});
    }
    table.insert("residuals", std::move(residuals));
    table.insert("change", std::move(changes));
    list.push_back(std::move(table));
  }
  std::ostringstream out;
  out << toml::table{{"format", kFormat}, {"record", std::move(list)}} << '\n';
  return out.str();
}

Result<std::vector<CalibrationRecord>> parseRecords(std::string_view text, std::string_view source_name) {
  toml::table root;
  try {
    root = toml::parse(text, source_name);
  } catch (const toml::parse_error& error) {
    return fail(about(fmt::format("{}:{}", source_name, error.source().begin.line), verbatim(error.description())));
  }
  const auto format = root["format"].value_exact<std::int64_t>();
  if (!format) return fail("{}: no 'format'; expected a record of calibrations, format = {}", source_name, kFormat);
  if (*format != kFormat) return fail("{}: format {}; this program reads format {}", source_name, *format, kFormat);
  RecordReader reader(source_name);
  std::vector<CalibrationRecord> records;
  for (const auto& [key, node] : root) {
    if (key.str() == "format") continue;
    const toml::array* list = node.as_array();
    if (key.str() != "record" || list == nullptr) {
      reader.complain(node, say("'{}': expected [[record]]", key.str()));
      continue;
    }
    for (const toml::node& item : *list) {
      if (const toml::table* table = item.as_table()) {
        records.push_back(reader.read(*table));
      } else {
        reader.complain(item, say("expected [[record]]"));
      }
    }
  }
  if (!reader.problem().empty()) return fail(reader.problem());
  return records;
}

namespace {

/// "[1, 2, 3]" to its entries.
std::vector<std::string> entriesOf(std::string_view list) {
  std::vector<std::string> out;
  std::string entry;
  for (const char c : list) {
    if (c == '[' || c == ' ') continue;
    if (c != ',' && c != ']') {
      entry += c;
    } else if (!entry.empty()) {
      out.push_back(std::exchange(entry, {}));
    }
  }
  return out;
}

}  // namespace

bool sameValue(std::string_view a, std::string_view b, int sensor) {
  if (sensor == 0) return a == b;
  const auto mine = entriesOf(a), theirs = entriesOf(b);
  const auto place = static_cast<std::size_t>(sensor - 1);
  return place < mine.size() && place < theirs.size() && mine[place] == theirs[place];
}

bool inForce(const CalibrationRecord& record, std::span<const Parameter> parameters) {
  for (const AppliedChange& change : record.changes) {
    const Parameter* parameter = findParameter(parameters, change.id);
    if (parameter == nullptr) return false;
    const std::string now = formatParameter(*parameter);
    if (now == change.after) continue;
    const bool shared = record.sensor > 0 && change.id.find(fmt::format("ir{}_", record.sensor)) == std::string::npos;
    if (shared && sameValue(now, change.after, record.sensor)) continue;
    // A tare after the calibration is what the manual asks for.
    if (isTared(record.procedure, change.id)) continue;
    return false;
  }
  return true;
}

std::string_view toString(Age age) {
  switch (age) {
    case Age::fresh: return "fresh";
    case Age::ageing: return "ageing";
    case Age::old: return "old";
  }
  return "unknown";
}

Result<AgeOfRecord> ageOf(const CalibrationRecord& record, std::string_view today, const CalibrationParameters& p) {
  const auto taken = parseDay(record.when), now = parseDay(today);
  if (!taken) return tl::unexpected(taken.error());
  if (!now) return tl::unexpected(now.error());
  const auto days = static_cast<int>((*now - *taken).count());
  AgeOfRecord out{.days = std::max(0, days), .warning = {}};
  if (days < 0) {
    out.age = Age::old;
    out.warning = say("calibrated {} days in the future: the computer's clock was or is wrong", -days);
  } else if (days > p.old_days) {
    out.age = Age::old;
    out.warning = say("calibrated {} days ago: repeat it", days);
  } else if (days > p.ageing_days) {
    out.age = Age::ageing;
    out.warning = say("calibrated {} days ago: repeat it soon", days);
  }
  return out;
}

}  // namespace fyd::calibration
