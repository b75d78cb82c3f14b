// fyd params [ID] [--profile FILE] [--set id=value] [--json] [--markdown] [--save FILE]
#include <iostream>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "app/cli/parts/profile_options.h"

namespace fyd::cli {
namespace {

nlohmann::ordered_json describe(const Parameter& parameter, const Parameter& standard) {
  nlohmann::ordered_json json;
  json["id"] = parameter.id;
  json["unit"] = parameter.info.unit;
  json["value"] = formatParameter(parameter);
  json["default"] = formatParameter(standard);
  if (parameter.kind == ParameterKind::choice) {
    json["choices"] = parameter.choices;
  } else if (parameter.isNumber() && parameter.kind != ParameterKind::boolean) {
    json["minimum"] = jsonNumber(parameter.info.minimum);
    json["maximum"] = jsonNumber(parameter.info.maximum);
  }
  json["live"] = parameter.info.live;
  json["help"] = parameter.info.help;
  return json;
}

void printParameter(const Parameter& parameter, const Parameter& standard) {
  const std::string value = formatParameter(parameter);
  const std::string changed =
      value == formatParameter(standard) ? "" : fmt::format(" (default {})", formatParameter(standard));
  std::cout << fmt::format("{} = {}{}\n    {}{}\n    {}\n", parameter.id, value, changed, describeRange(parameter),
                           parameter.info.live ? "; may change while active" : "", parameter.info.help);
}

/// Where the parameters of that id, or of that module, stand. @param id empty: all
std::vector<std::size_t> placesOf(const std::vector<Parameter>& parameters, const std::string& id) {
  const Parameter* one = parameterNamed(parameters, id);
  const std::string wanted = one == nullptr ? id : std::string(one->id);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string_view each = parameters[i].id;
    if (wanted.empty() || each == wanted || each.starts_with(wanted + ".")) places.push_back(i);
  }
  if (places.empty()) throw UsageError(say("params: no parameter '{}'; 'fyd params' lists them all", id));
  return places;
}

void printMarkdown(const std::vector<Parameter>& parameters, const std::vector<std::size_t>& places) {
  std::cout << "| id | default | range | live | meaning |\n|---|---|---|---|---|\n";
  for (const std::size_t place : places) {
    const Parameter& parameter = parameters[place];
    std::cout << fmt::format("| `{}` | {} | {} | {} | {} |\n", parameter.id, formatParameter(parameter),
                             describeRange(parameter), parameter.info.live ? "yes" : "", parameter.info.help);
  }
}

}  // namespace

void add_params(CLI::App& app) {
  struct Options {
    std::string id;
    ProfileOptions profile;
    std::string save;
    bool json = false;
    bool markdown = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("params", "Print every parameter: value, unit, range, default and meaning");
  command->add_option("id", options->id, "One parameter or one module, such as control.kp or control");
  options->profile.addTo(*command);
  command->add_option("--save", options->save, "Write the profile, complete and checked, to this file");
  auto* as_json = command->add_flag("--json", options->json, "As JSON");
  command->add_flag("--markdown", options->markdown, "As the manual's table")->excludes(as_json);
  command->callback([options, command] {
    if (options->markdown && options->save.empty()) {  // a table of defaults says nothing of a profile
      for (const char* values : {"--profile", "--set"}) {
        if (command->count(values) > 0) throw CLI::ExcludesError("--markdown", values);
      }
    }
    station::Profile standard;
    const auto standards = bindParameters(standard);
    const auto places = placesOf(standards, options->id);  // before anything is written
    station::Profile profile = options->profile.load();
    const auto values = bindParameters(profile);
    if (!options->save.empty()) {
      refuseToDestroy(options->save, {});  // the profile itself may be saved over
      valueOrFail(station::saveProfile(profile, options->save));
    }
    if (options->markdown) {
      printMarkdown(standards, places);
      return;
    }
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const std::size_t i : places) {
      if (options->json) {
        json.push_back(describe(values[i], standards[i]));
      } else {
        printParameter(values[i], standards[i]);
      }
    }
    if (options->json) printJson(json);
  });
}

}  // namespace fyd::cli
