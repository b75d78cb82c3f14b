// Recordings: columns of telemetry into NumPy's memory, events, notes, pictures, the inputs of each step.
#include "app/python/recordings.h"

#include <fmt/format.h>

#include "app/python/described.h"
#include "app/python/parameters.h"
#include "core/recording/reader/recorded_profile.h"
#include "core/recording/reader/recording_health.h"

namespace fyd::python {
namespace {

using pipeline::TelemetrySample;
using recording::Recording;
using recording::RecordingInfo;

constexpr auto& kFields = kFieldsOf<TelemetrySample>;
constexpr std::size_t kRowsAtOnce = 4096;
/// now_ns, the first column, is not among telemetryFields().
constexpr std::size_t kNotFields = 1;

/// A column of /telemetry.
struct Column {
  std::string name, unit, help;
  py::dtype dtype;
  bool real;  ///< a double
  void (*put)(std::span<const TelemetrySample> rows, void* to);
};

template <std::size_t I>
void putColumn(std::span<const TelemetrySample> rows, void* to) {
  constexpr auto& kField = std::get<I>(kFields);
  using V = FieldValue<decltype(kField), const TelemetrySample>;
  auto* out = static_cast<V*>(to);
  for (const TelemetrySample& row : rows) *out++ = kField.of(row);
}

const std::vector<Column>& columns() {
  static const auto* const kColumns = [] {  // kept: the dtypes are Python's
    auto* out = new std::vector<Column>;
    forEachField<TelemetrySample>([&](auto i, const auto& field) {
      using V = FieldValue<decltype(field), const TelemetrySample>;
      out->push_back({nameOf(field), std::string(field.unit), std::string(field.help), dtypeOf<V>(),
                      std::is_same_v<V, double>, &putColumn<decltype(i)::value>});
    });
    return out;
  }();
  return *kColumns;
}

std::size_t columnNamed(const std::string& name) {
  for (std::size_t i = 0; i < columns().size(); ++i)
    if (columns()[i].name == name) return i;
  throw py::key_error(name);
}

/// Rows [first, first + length of the arrays) of these columns, into the arrays, in one pass over the file.
void readInto(OpenRecording& file, const std::vector<std::string>& names, std::uint64_t first,
              const std::vector<py::array>& into) {
  if (names.size() != into.size()) throw py::value_error("as many arrays as names");
  struct Place {
    std::size_t column;
    std::byte* to;
    std::size_t item;
  };
  std::vector<Place> places;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t column = columnNamed(names[i]);
    py::array array = into[i];
    const bool fits = array.ndim() == 1 && array.writeable() && array.dtype().equal(columns()[column].dtype) &&
                      (array.shape(0) < 2 || array.strides(0) == array.itemsize()) &&
                      (i == 0 || static_cast<std::size_t>(array.shape(0)) == rows);
    if (!fits)
      throw Refusal{fmt::format("{}: an array of {}, shape {}; expected a contiguous one of {}, of one length",
                                names[i], std::string(py::str(array.dtype())), shapeOf(array),
                                std::string(py::str(py::handle(columns()[column].dtype))))};
    rows = static_cast<std::size_t>(array.shape(0));
    places.push_back(
        {column, static_cast<std::byte*>(array.mutable_data()), static_cast<std::size_t>(array.itemsize())});
  }
  if (places.empty()) return;
  file.run([&](Recording& recording) -> Result<void> {
    if (places.size() == 1 && places[0].column >= kNotFields && columns()[places[0].column].real)
      return recording.field(places[0].column - kNotFields, first, {reinterpret_cast<double*>(places[0].to), rows});
    std::vector<TelemetrySample> some(std::min(rows, kRowsAtOnce));
    for (std::size_t at = 0; at < rows; at += some.size()) {
      some.resize(std::min(rows - at, kRowsAtOnce));
      if (auto read = recording.telemetry(first + at, some); !read) return read;
      for (const Place& place : places) columns()[place.column].put(some, place.to + at * place.item);
    }
    return {};
  });
}

py::object pictureArray(const cv::Mat& picture) {
  if (picture.empty()) return py::none();
  auto* kept = new cv::Mat(picture);  // shares the pixels
  const py::capsule owner(kept, [](void* mat) { delete static_cast<cv::Mat*>(mat); });
  std::vector<py::ssize_t> shape{kept->rows, kept->cols};
  std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(kept->step[0]), static_cast<py::ssize_t>(kept->elemSize())};
  if (kept->channels() > 1) {
    shape.push_back(kept->channels());
    strides.push_back(1);
  }
  return py::array_t<std::uint8_t>(shape, strides, kept->data, owner);
}

struct LoggedNote {
  double time_s = 0.0;
  recording::NoteKind kind = recording::NoteKind::note;
  std::string text;
};

void addInfo(py::module_& module) {
  enumOf<recording::Wholeness>(module, "Wholeness", "How a recording was left.")
      .value("whole", recording::Wholeness::whole)
      .value("growing", recording::Wholeness::growing)
      .value("crashed", recording::Wholeness::crashed)
      .value("damaged", recording::Wholeness::damaged);
  const auto header = [](auto member) {
    return [member](const RecordingInfo& info) { return textOf(info.header.*member); };
  };
  using H = recording::RecordingHeader;
  py::class_<RecordingInfo>(module, "RecordingInfo", "The summary of a recording, as of its last refresh.")
      .def_readonly("wholeness", &RecordingInfo::wholeness, "How it was left [—]")
      .def_readonly("duration_s", &RecordingInfo::duration_s, "From its start to its last row [s]")
      .def_readonly("rows", &RecordingInfo::committed_samples, "Rows of telemetry to trust [1]")
      .def_readonly("rows_present", &RecordingInfo::samples, "Rows of telemetry in the file [1]")
      .def_readonly("pictures", &RecordingInfo::frames, "Pictures [1]")
      .def_readonly("gaps", &RecordingInfo::gaps, "Steps lost, not missed cycles [1]")
      .def_readonly("events", &RecordingInfo::events, "Events [1]")
      .def_readonly("bytes", &RecordingInfo::bytes, "Of the file [byte]")
      .def_property_readonly(
          "damage", [](const RecordingInfo& info) { return textOf(info.damage.text()); },
          "What is damaged; empty: nothing [—]")
      .def_property_readonly(
          "why_not_exact", [](const RecordingInfo& info) { return textOf(recording::whyNoExactReplay(info).text()); },
          "What of the steps is lost, so that they cannot come out bit for bit again; empty: nothing [—]")
      .def_property_readonly(
          "arithmetic", [](const RecordingInfo& info) { return info.header.arithmetic; },
          fmt::format("Of the step that was recorded; bit for bit it comes out of the same one only, here {} [1]",
                      pipeline::kArithmetic)
              .c_str())
      .def_readonly("missing_columns", &RecordingInfo::missing_columns,
                    "Columns that this library has and the file has not: read as a new value has them [—]")
      .def_property_readonly(
          "unknown_columns", [](const RecordingInfo& info) { return textOf(info.unknown_columns); },
          "Columns that are not read [—]")
      .def_property_readonly(
          "started_ns", [](const RecordingInfo& info) { return toPython(info.header.started); },
          "The station's clock at time 0 of the recording [ns]")
      .def_property_readonly("id", header(&H::id), "Globally unique [—]")
      .def_property_readonly("started_utc", header(&H::started_utc), "ISO 8601, of its start [—]")
      .def_property_readonly("operator", header(&H::operator_name), "Who operated [—]")
      .def_property_readonly("subject", header(&H::subject), "A code, never a name [—]")
      .def_property_readonly("notes", header(&H::notes), "Written when it started [—]")
      .def_property_readonly("tags", header(&H::tags), "Words to find it by [—]")
      .def_property_readonly("touchpad", header(&H::touchpad), "Where the touchpad was [—]")
      .def_property_readonly("camera", header(&H::camera), "Where the pictures came from [—]")
      .def_property_readonly("robot", header(&H::robot), "Where the robot was [—]")
      .def_property_readonly("profile", header(&H::profile), "TOML of the whole station's parameters [—]")
      .def_property_readonly("surface", header(&H::surface), "TOML of the stored surface; empty: none [—]")
      .def_property_readonly("version", header(&H::version), "Of the program that recorded [—]");
}

}  // namespace

OpenRecording::OpenRecording(const std::string& path) : path_(path) {
  const Hdf5Turn turn;
  done(file_.run([&](std::unique_ptr<Recording>& file) -> Result<void> {
    auto opened = Recording::open(path);
    if (!opened) return tl::unexpected(opened.error());
    file = std::move(*opened);
    return {};
  }));
}

OpenRecording::~OpenRecording() {
  try {
    close();
  } catch (const std::exception& error) {  // said as Python says what a destructor cannot raise
    PyErr_Format(PyExc_RuntimeError, "%s: closing: %s", path_.c_str(), error.what());
    PyErr_WriteUnraisable(nullptr);
  }
}

void OpenRecording::close() {
  const Hdf5Turn turn;
  file_.run([](std::unique_ptr<Recording>& file) { file.reset(); });
}

void addRecordings(py::module_& module) {
  addInfo(module);
  py::dict units, help;
  py::dict dtypes;
  py::list names;
  for (const Column& column : columns()) {
    names.append(column.name);
    units[column.name.c_str()] = column.unit;
    help[column.name.c_str()] = column.help;
    dtypes[column.name.c_str()] = column.dtype;
  }
  module.attr("TELEMETRY_NAMES") = py::tuple(names);
  module.attr("TELEMETRY_UNITS") = units;
  module.attr("TELEMETRY_HELP") = help;
  module.attr("TELEMETRY_DTYPES") = dtypes;

  using recording::EventRow;
  py::class_<EventRow> event(module, "EventRow", "What a step reported, with its time.");
  describe(event);
  copyable(event);
  event.def_property_readonly(
      "id", [](const EventRow& row) { return idOfEvent(row.event); }, kIdOfEvent);
  py::class_<recording::LinkRow> link(module, "LinkRow", "The robot's link, as it was once a second.");
  describe(link);
  py::class_<LoggedNote>(module, "Note", "A line of the recording's own log.")
      .def_readonly("time_s", &LoggedNote::time_s, "From the recording's start [s]")
      .def_readonly("kind", &LoggedNote::kind, "What it is [—]")
      .def_property_readonly(
          "text", [](const LoggedNote& note) { return textOf(note.text); }, "What it says [—]");
  using recording::RecordedPicture;
  py::class_<RecordedPicture>(module, "Picture", "A picture of the camera, and what the detector said of it.")
      .def_readonly("time_s", &RecordedPicture::time_s, "When it was taken, from the recording's start [s]")
      .def_readonly("number", &RecordedPicture::number, "The camera's [1]")
      .def_property_readonly(
          "whole", [](const RecordedPicture& picture) { return pictureArray(picture.whole); },
          "Grey values (height, width), or blue, green, red; what lies around the region is as "
          "compressed, perhaps of an earlier picture. None: there is none [grey value, 0 to 255]")
      .def_property_readonly(
          "region", [](const RecordedPicture& picture) { return pictureArray(picture.region); },
          "The region of interest exactly as the detector saw it. None: it lay outside of the picture [grey value, 0 "
          "to "
          "255]")
      .def_property_readonly(
          "region_px",
          [](const RecordedPicture& picture) {
            const cv::Rect& r = picture.region_px;
            return py::make_tuple(r.x, r.y, r.width, r.height);
          },
          "Left edge, upper edge, width and height of the region in the whole picture [px]")
      .def_readonly("finger", &RecordedPicture::finger, "What the detector said [each in its unit]");
  using recording::StepRecord;
  py::class_<StepRecord>(module, "RecordedStep", "What went into a step and what came out.")
      .def_property_readonly(
          "missing", [](const StepRecord& step) { return py::tuple(py::cast(recording::missingTables(step))); },
          "Paths of the tables that a recovered recording lost for this step: what they held is as if nothing had ever "
          "come. Empty: none [—]")
      .def_readonly("inputs", &StepRecord::inputs, "As the step had them, but for what is `missing` [each in its unit]")
      .def_readonly("motors", &StepRecord::motors, "As written to the motors [each in its unit]")
      .def_readonly("telemetry", &StepRecord::telemetry, "The step's sample [each in its unit]")
      .def_property_readonly(
          "events",
          [](const StepRecord& step) { return std::vector<pipeline::Event>(step.events.begin(), step.events.end()); },
          "What the step reported [each in its unit]");

  py::class_<OpenRecording>(module, "RecordingFile", "An open recording: whole, growing, or left behind by a crash.")
      .def(py::init([](const py::bytes& path) { return std::make_unique<OpenRecording>(pathOf(path)); }),
           py::arg("path"), "Opens FILE or FILE.partial; FILE alone also finds FILE.partial beside it. Units: none.")
      .def("close", &OpenRecording::close, "Closes the file; the arrays that were read stay. Units: none.")
      .def("info", &OpenRecording::info, "The summary, as of the last refresh. Units: [s] and [byte], in its names.")
      .def(
          "refresh",
          [](OpenRecording& file) { return file.run([](Recording& recording) { return recording.refresh(); }); },
          "Takes in what was committed since; whether there was news. Units: none.")
      .def("read_into", &readInto, py::arg("names"), py::arg("first"), py::arg("arrays"),
           "Rows of these columns, from row `first` on, into arrays of the columns' dtypes. Units: those of the "
           "columns.")
      .def(
          "row_at",
          [](OpenRecording& file, double time_s) {
            return file.run([&](Recording& recording) { return recording.rowAt(time_s); });
          },
          py::arg("time_s"),
          "The first row at or after time_s [s] from the recording's start; the number of rows when there is none.")
      .def(
          "step",
          [](OpenRecording& file, std::uint64_t row) {
            return file.run([&](Recording& recording) { return recording.step(row); });
          },
          py::arg("row"), "What went into the step of this row and what came out. Units: those of its values.")
      .def(
          "overview",
          [](OpenRecording& file, const std::string& name, double from_s, double to_s, std::size_t buckets) {
            const std::size_t column = columnNamed(name);
            if (column < kNotFields) throw Refusal{name + ": has no overview"};
            if (buckets == 0) throw Refusal{"buckets: 0; expected 1 or more"};
            if (!(from_s <= to_s)) throw Refusal{fmt::format("from_s: {}; expected at most to_s = {}", from_s, to_s)};
            auto overview = file.run(
                [&](Recording& recording) { return recording.overview(column - kNotFields, from_s, to_s, buckets); });
            std::vector<double> low, high;
            for (const auto& each : overview.values) low.push_back(each.low), high.push_back(each.high);
            return py::make_tuple(arrayOf(std::move(overview.time_s)), arrayOf(std::move(low)),
                                  arrayOf(std::move(high)));
          },
          py::arg("name"), py::arg("from_s"), py::arg("to_s"), py::arg("buckets"),
          "Smallest and largest of a column between from_s and to_s [s], in at most so many buckets, one or more: "
          "(start of each "
          "bucket [s], smallest, largest [the column's unit]). No spike is lost.")
      .def(
          "events",
          [](OpenRecording& file) { return file.run([](Recording& recording) { return recording.events(); }); },
          "What the steps reported, in their order. Units: those of its values.")
      .def(
          "event_columns",
          [](OpenRecording& file) {
            return columnsOf(file.run([](Recording& recording) { return recording.events(); }));
          },
          "The events' columns by name. Units: those of EventRow.units.")
      .def(
          "link_columns",
          [](OpenRecording& file) {
            return columnsOf(file.run([](Recording& recording) { return recording.linkRows(); }));
          },
          "The robot's link once a second, columns by name. Units: in the names; counts without.")
      .def(
          "notes",
          [](OpenRecording& file) {
            const RecordingInfo info = file.info();
            std::vector<LoggedNote> out;
            for (const auto& note : file.run([](Recording& recording) { return recording.notes(); }))
              out.push_back({recording::secondsInto(info, note.when), note.kind, note.text});
            return out;
          },
          "Notes, bookmarks, trials' markers and alarms, in their order. Units: [s], in its names.")
      .def(
          "picture",
          [](OpenRecording& file, std::uint64_t index) {
            return file.run([&](Recording& recording) { return recording.picture(index); });
          },
          py::arg("index"), "A picture by its number in the recording, from 0. Units: [s], [px].")
      .def(
          "picture_at",
          [](OpenRecording& file, double time_s) {
            return file.run([&](Recording& recording) { return recording.pictureAt(time_s); });
          },
          py::arg("time_s"), "The newest picture at time_s [s] from the recording's start.")
      .def(
          "parameters",
          [](OpenRecording& file) {
            return std::make_unique<ParameterSet>(done(recording::recordedParameters(file.info().header)));
          },
          "The step's parameters at the first row. Units: each parameter's own.");
}

}  // namespace fyd::python
