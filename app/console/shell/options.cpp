#include "app/console/shell/options.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <limits>

#include "app/console/shell/language.h"
#include "core/catalogue/catalogue_address.h"
#include "core/experiment/trials.h"
#include "core/station/profile/option_words.h"
#include "core/station/station_sources.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {
namespace {

namespace words = station::words;

struct OptionInfo {
  const char* name;
  const char* argument;  ///< empty: a switch
  const char* help;
};

// In the order of the help. In English, as in `fyd`: they are read before a language is chosen.
constexpr OptionInfo kOptions[] = {
    {"help", "", "Show this help."},
    {"version", "", "Show the version."},
    {"simulate", "", "The same as --touchpad simulated."},
    {"touchpad", "TOUCHPAD", words::kTouchpad},
    {"motors", "MOTORS", words::kMotors},
    {"finger", "CSV", words::kFinger},
    {"camera", "SOURCE", words::kCamera},
    {"robot", "ROBOT", words::kRobot},
    {"key", "FILE", words::kKey},
    {"scene", "FILE", words::kScene},
    {"surface", "FILE", words::kSurface},
    {"record", "FILE", words::kRecord},
    {"operator", "NAME", words::kOperator},
    {"subject", "CODE", words::kSubject},
    {"notes", "TEXT", words::kNotes},
    {"tag", "WORD", words::kTag},
    {"catalogue", "CATALOGUE", words::kCatalogue},
    {"trials", "A,B,...", "Conditions of an experiment; Ctrl+Shift+M begins the next trial and marks it."},
    {"trial-repetitions", "N", "How often each condition comes; default: 1."},
    {"trial-seed", "N", "The same seed gives the same order; default: 1."},
    {"review", "FILE", "Recording to review at once."},
    {"profile", "FILE", "Profile to load and to save to."},
    {"theme", "NAME", "dark, light or system; default: that of the last time, at first the system's."},
    {"language", "CODE", "en, it or fr; default: that of the last time, at first the system's."},
    {"page", "NAME", "Place of the window to begin with, such as operate or devices; default: that of the last time."},
    {"screenshot", "FILE", "Save a picture of the window and leave; arms once in simulation."},
    {"after", "S", "Seconds before the picture is taken; default: 5."},
    {"dump-geometry", "", "Print where the visible controls stand, as JSON, and leave."},
    {"open", "PANELS", "Panels to open first: recording, link, manual, log, first-steps; several with commas."},
    {"scale", "S", "Scale of everything on the screen, from 0.5 to 4; default: the screen's."},
    {"size", "WIDTHxHEIGHT", "Size of the window in logical pixels; default: that of the last time."},
};

Result<std::optional<widgets::ThemeChoice>> readTheme(const QString& name) {
  if (name.isEmpty()) return std::nullopt;
  if (const auto choice = widgets::themeOf(name)) return choice;
  return fail("--theme {}: expected dark, light or system", name.toStdString());
}

Result<void> checkLanguage(const QString& code) {
  QStringList known;
  for (const Language& language : languages()) known << QLatin1String(language.code);
  if (code.isEmpty() || isLanguage(code)) return {};
  return fail("--language {}: expected one of {}", code.toStdString(), known.join(QStringLiteral(", ")).toStdString());
}

Result<void> checkPage(const QString& name, const QStringList& known) {
  if (name.isEmpty() || known.contains(name)) return {};
  return fail("--page {}: expected one of {}", name.toStdString(), known.join(QStringLiteral(", ")).toStdString());
}

Result<double> readSeconds(const QString& text) {
  if (text.isEmpty()) return Options{}.screenshot_after_s;
  const double seconds = widgets::readNumber(text);
  if (seconds >= 0.0 && seconds <= 3600.0) return seconds;
  return fail("--after {}: expected a number of seconds from 0 to 3600", text.toStdString());
}

Result<QStringList> readPanels(const QString& text) {
  if (text.isEmpty()) return QStringList{};
  QStringList known;
  for (const char* name : kPanelNames) known << QLatin1String(name);
  QStringList out;
  for (const QString& each : text.split(QLatin1Char(','))) {
    if (!known.contains(each.trimmed())) {
      return fail("--open {}: expected one or more of {}", each.toStdString(),
                  known.join(QStringLiteral(", ")).toStdString());
    }
    out << each.trimmed();
  }
  return out;
}

Result<double> readScale(const QString& text) {
  if (text.isEmpty()) return 0.0;
  const double scale = widgets::readNumber(text);
  if (scale >= 0.5 && scale <= 4.0) return scale;
  return fail("--scale {}: expected a number from 0.5 to 4", text.toStdString());
}

Result<QSize> readSize(const QString& text) {
  if (text.isEmpty()) return QSize();
  static const QRegularExpression kSize(QStringLiteral("^([0-9]{1,5})x([0-9]{1,5})$"));
  const auto match = kSize.match(text);
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  constexpr int kLeast_px = 100;
  constexpr int kMost_px = 16'384;
  if (match.hasMatch() && std::min(size.width(), size.height()) >= kLeast_px &&
      std::max(size.width(), size.height()) <= kMost_px) {
    return size;
  }
  return fail("--size {}: expected WIDTHxHEIGHT, each from {} to {}", text.toStdString(), kLeast_px, kMost_px);
}

Result<TrialWords> readTrials(const QCommandLineParser& parser) {
  TrialWords words;
  const QString conditions = parser.value(QStringLiteral("trials"));
  if (!conditions.isEmpty()) words.conditions = conditions.split(QLatin1Char(','));
  const auto read = [&](const char* name, std::uint64_t least, std::uint64_t most, auto& into) -> Result<void> {
    if (!parser.isSet(QLatin1String(name))) return {};
    const QString text = parser.value(QLatin1String(name));
    bool good = false;
    const std::uint64_t value = text.toULongLong(&good);
    if (!good || value < least || value > most) {
      return fail("--{} {}: expected a whole number from {} to {}", name, text.toStdString(), least, most);
    }
    if (words.conditions.isEmpty()) return fail("--{}: only with --trials", name);
    into = static_cast<std::remove_reference_t<decltype(into)>>(value);
    return {};
  };
  if (auto good = read("trial-repetitions", 1, experiment::kMaximumRepetitions, words.repetitions); !good) {
    return tl::unexpected(good.error());
  }
  if (auto good = read("trial-seed", 0, std::numeric_limits<std::uint64_t>::max(), words.seed); !good) {
    return tl::unexpected(good.error());
  }
  if (words.conditions.isEmpty()) return words;
  std::vector<std::string> names;
  for (const QString& each : words.conditions) names.push_back(each.trimmed().toStdString());
  const auto order =
      experiment::orderTrials(names, static_cast<std::size_t>(std::max(0, words.repetitions)), words.seed);
  if (!order) return fail("--trials: {}", order.error().message);
  return words;
}

/// Reads the station's options.
Result<station::StationOptions> readStation(const QCommandLineParser& parser) {
  const auto value = [&](const char* name) { return parser.value(QLatin1String(name)).toStdString(); };
  station::StationOptions out;
  out.touchpad = value("touchpad");
  if (parser.isSet(QStringLiteral("simulate"))) {
    if (!out.touchpad.empty() && out.touchpad != "simulated") return fail(words::contradiction(out.touchpad));
    out.touchpad = "simulated";
  }
  out.motors = value("motors");
  out.finger_csv = value("finger");
  out.camera = value("camera");
  out.robot = value("robot");
  out.key_file = value("key");
  out.scene = value("scene");
  out.surface = value("surface");
  recording::RecordingRequest record{.path = value("record"),
                                     .operator_name = value("operator"),
                                     .subject = value("subject"),
                                     .notes = value("notes"),
                                     .tags = {}};
  for (const QString& tag : parser.values(QStringLiteral("tag"))) record.tags.push_back(tag.toStdString());
  const bool described =
      !record.operator_name.empty() || !record.subject.empty() || !record.notes.empty() || !record.tags.empty();
  if (record.path.empty() && described) return fail(phrase(words::kRecordMissing));
  if (!record.path.empty()) out.record = record;
  if (const auto good = station::checkWords(out); !good) return tl::unexpected(good.error());
  return out;
}

}  // namespace

Result<Options> readOptions(const QStringList& arguments, const QStringList& places) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("FYD Console: the operator's window of the FYD Touchpad."));
  for (const OptionInfo& each : kOptions) {
    QStringList names = {QLatin1String(each.name)};
    if (names.first() == QLatin1String("help")) names.prepend(QStringLiteral("h"));
    parser.addOption(QCommandLineOption(names, QString::fromUtf8(each.help), QLatin1String(each.argument)));
  }
  if (!parser.parse(arguments)) return fail(verbatim(parser.errorText().toStdString()));
  Options options;
  if (parser.isSet(QStringLiteral("help"))) {
    // There is no application yet whose name Qt could put there.
    options.help = parser.helpText().replace(QStringLiteral("<executable_name>"), QStringLiteral("fyd-console"));
    return options;
  }
  if (parser.isSet(QStringLiteral("version"))) {
    options.help = QStringLiteral("fyd-console " FYD_VERSION "\n");
    return options;
  }
  if (!parser.positionalArguments().isEmpty()) {
    return fail("unexpected argument '{}'; --help shows the options",
                parser.positionalArguments().first().toStdString());
  }
  const auto seconds = readSeconds(parser.value(QStringLiteral("after")));
  if (!seconds) return tl::unexpected(seconds.error());
  const auto panels = readPanels(parser.value(QStringLiteral("open")));
  if (!panels) return tl::unexpected(panels.error());
  const auto scale = readScale(parser.value(QStringLiteral("scale")));
  if (!scale) return tl::unexpected(scale.error());
  const auto size = readSize(parser.value(QStringLiteral("size")));
  if (!size) return tl::unexpected(size.error());
  const auto theme = readTheme(parser.value(QStringLiteral("theme")));
  if (!theme) return tl::unexpected(theme.error());
  auto station = readStation(parser);
  if (!station) return tl::unexpected(station.error());
  options.station = std::move(*station);
  options.profile = parser.value(QStringLiteral("profile"));
  options.catalogue = parser.value(QStringLiteral("catalogue"));
  auto trials = readTrials(parser);
  if (!trials) return tl::unexpected(trials.error());
  options.trials = std::move(*trials);
  options.review = parser.value(QStringLiteral("review"));
  options.theme = *theme;
  options.page = parser.value(QStringLiteral("page"));
  options.screenshot = parser.value(QStringLiteral("screenshot"));
  options.screenshot_after_s = *seconds;
  options.dump_geometry = parser.isSet(QStringLiteral("dump-geometry"));
  options.open = *panels;
  options.scale = *scale;
  options.size = *size;
  options.language = parser.value(QStringLiteral("language"));
  if (const auto ok = checkLanguage(options.language); !ok) return tl::unexpected(ok.error());
  if (const auto ok = checkPage(options.page, places); !ok) return tl::unexpected(ok.error());
  if (const auto ok = catalogue::parseCatalogueAddress(options.catalogue.toStdString()); !ok) {
    return fail("--catalogue: {}", ok.error().message);
  }
  return options;
}

Result<void> checkReview(const Options& options) {
  const QFileInfo file(options.review);
  if (options.review.isEmpty() || (file.isFile() && file.isReadable())) return {};
  return fail("--review {}: no such file, or it may not be read", options.review.toStdString());
}

}  // namespace fyd::console
