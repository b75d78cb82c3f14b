#include "core/calibration/calibration_record.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/base/toml_parameters.h"
#include "core/calibration/calibration_part.h"

namespace fyd::calibration {
namespace {

constexpr std::int64_t kFormat = 2;
constexpr std::int64_t kFirstFormat = 1;

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
  RecordReader(std::string_view source, std::int64_t format) : source_(source), format_(format) {}

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
    if (format_ > kFirstFormat) {
      known += take(table, "touchpad", record.touchpad, say("a text"));
      known += take(table, "simulated", record.simulated, say("true or false"));
      known += take(table, "picture", record.picture, say("a text"));
      known += readSamples(table, record);
      known += readCoefficients(table, record);
    } else {
      record.simulated = record.conditions.starts_with(kSimulatedPoints);
    }
    known += readNumbers(table, "residuals", record.residuals);
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
  std::size_t readNumbers(const toml::table& table, const char* key, std::vector<double>& out) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return 0;
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      complain(*node, say("{}: expected a list of numbers", key));
      return 1;
    }
    for (const toml::node& item : *array) {
      const auto value = item.value_exact<double>();
      if (!value) complain(item, say("{}: expected numbers with a point", key));
      out.push_back(value.value_or(kUnknown));
    }
    return 1;
  }
  /// Calls `read` with each table of a list. @param keys that each of them has, in words
  template <class Read>
  std::size_t readTables(const toml::table& table, const char* key, std::size_t size, const char* keys, Read read) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return 0;
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      complain(*node, say("{}: expected [[record.{}]]", key, key));
      return 1;
    }
    for (const toml::node& item : *array) {
      const toml::table* entry = item.as_table();
      if (entry == nullptr || entry->size() != size) {
        complain(item, say("{}: expected {}", key, keys));
      } else {
        read(*entry);
      }
    }
    return 1;
  }
  std::size_t readChanges(const toml::table& table, CalibrationRecord& record) {
    return readTables(table, "change", 3, "id, before and after", [&](const toml::table& change) {
      AppliedChange& applied = record.changes.emplace_back();
      take(change, "id", applied.id, say("a text"));
      take(change, "before", applied.before, say("a text"));
      take(change, "after", applied.after, say("a text"));
    });
  }
  std::size_t readSamples(const toml::table& table, CalibrationRecord& record) {
    return readTables(table, "column", 3, "name, unit and values", [&](const toml::table& entry) {
      SampleColumn& column = record.samples.emplace_back();
      take(entry, "name", column.name, say("a text"));
      take(entry, "unit", column.unit, say("a text"));
      if (readNumbers(entry, "values", column.values) == 0) complain(entry, say("values is missing"));
    });
  }
  std::size_t readCoefficients(const toml::table& table, CalibrationRecord& record) {
    return readTables(table, "coefficient", 4, "name, unit, value and standard_error", [&](const toml::table& entry) {
      Coefficient& coefficient = record.coefficients.emplace_back();
      take(entry, "name", coefficient.name, say("a text"));
      take(entry, "unit", coefficient.unit, say("a text"));
      take(entry, "value", coefficient.value, say("a number with a point, or nan"));
      take(entry, "standard_error", coefficient.standard_error, say("a number with a point, or nan"));
    });
  }

  std::string_view source_;
  std::int64_t format_;
  Message problem_;
};

toml::array numbers(const std::vector<double>& values) {
  toml::array out;
  for (const double value : values) out.push_back(value);
  return out;
}

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

CalibrationRecord makeRecord(const CalibrationResult& result, std::vector<AppliedChange> changes,
                             CalibrationRecord said) {
  said.procedure = result.procedure;
  said.curve = result.curve.text();
  said.unit = result.unit;
  said.verdict = result.verdict.reason.text();
  said.points = static_cast<std::int64_t>(result.points);
  said.outliers = static_cast<std::int64_t>(result.outliers.size());
  said.rmse = result.rmse;
  said.held_out_rmse = result.held_out_rmse;
  said.max_residual = result.max_residual;
  said.condition_number = result.condition_number;
  said.residuals = result.residuals;
  said.samples = result.samples;
  said.coefficients = result.coefficients;
  said.changes = std::move(changes);
  return said;
}

std::string formatRecords(std::span<const CalibrationRecord> records) {
  toml::array list;
  for (const CalibrationRecord& record : records) {
    toml::table table;
    const auto put = [&](const char* key, const auto& value) { table.insert(key, value); };
    eachField(record, put, put, put);
    put("sensor", static_cast<std::int64_t>(record.sensor));
    put("touchpad", record.touchpad);
    put("simulated", record.simulated);
    put("picture", record.picture);
    toml::array columns, coefficients, changes;
    for (const SampleColumn& column : record.samples) {
      columns.push_back(toml::table{{"name", column.name}, {"unit", column.unit}, {"values", numbers(column.values)}});
    }
    for (const Coefficient& c : record.coefficients) {
      coefficients.push_back(
          toml::table{{"name", c.name}, {"unit", c.unit}, {"value", c.value}, {"standard_error", c.standard_error}});
    }
    for (const AppliedChange& change : record.changes) {
      changes.push_back(toml::table{{"id", change.id}, {"before", change.before}, {"after", change.after}});
    }
    table.insert("residuals", numbers(record.residuals));
    table.insert("column", std::move(columns));
    table.insert("coefficient", std::move(coefficients));
    table.insert("change", std::move(changes));
    list.push_back(std::move(table));
  }
  std::ostringstream out;
  out << toml::table{{"format", kFormat}, {"record", std::move(list)}} << '\n';
  return out.str();
}

Result<std::vector<CalibrationRecord>> parseRecords(std::string_view text, std::string_view source_name) {
  const auto parsed = parseToml(text, source_name);
  if (!parsed) return tl::unexpected(parsed.error());
  const toml::table& root = *parsed;
  const auto format = root["format"].value_exact<std::int64_t>();
  if (!format) return fail("{}: no 'format'; expected a record of calibrations, format = {}", source_name, kFormat);
  if (*format < kFirstFormat || *format > kFormat) {
    return fail("{}: format {}; this program reads formats {} to {}", source_name, *format, kFirstFormat, kFormat);
  }
  RecordReader reader(source_name, *format);
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
