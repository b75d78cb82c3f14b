// fyd gesture: cards of gestures, made of a recording's touches, trimmed and shown. They are played as the simulated
// finger: `fyd station --simulate --finger CARD`.
#include <cmath>
#include <limits>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "core/export/touch_gesture.h"

namespace fyd::cli {
namespace {

struct GestureOptions {
  std::string recording;
  std::size_t touch = 1;
  std::string card;
  std::string out;
  std::string name;
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
  std::optional<double> speed;
  bool loop = false;
  bool once = false;
  bool json = false;
};

nlohmann::ordered_json jsonOf(const sim::GestureCard& card) {
  double force_over_stiffness_mm = 0.0, deepest_mm = 0.0, fastest_mm_s = 0.0;
  for (std::size_t i = 0; i < card.rows.size(); ++i) {
    const sim::FingerState& at = card.rows[i].state;
    deepest_mm = std::max(deepest_mm, at.indentation_mm);
    if (i == 0) continue;
    const sim::FingerPath::Knot& before = card.rows[i - 1];
    const double moved_mm = std::hypot(at.x_mm - before.state.x_mm, at.y_mm - before.state.y_mm);
    force_over_stiffness_mm += moved_mm;
    fastest_mm_s = std::max(fastest_mm_s, card.speed * moved_mm / (card.rows[i].time_s - before.time_s));
  }
  return {{"name", card.name},
          {"source", card.source},
          {"rows", card.rows.size()},
          {"seconds", card.duration_s()},
          {"speed", card.speed},
          {"loop", card.loop},
          {"way_mm", jsonNumber(force_over_stiffness_mm)},
          {"deepest_mm", jsonNumber(deepest_mm)},
          {"fastest_mm_per_s", jsonNumber(fastest_mm_s)}};
}

void print(const sim::GestureCard& card, bool as_json) { printValues(jsonOf(card), as_json); }

void takeSettings(sim::GestureCard& card, const GestureOptions& options) {
  if (!options.name.empty()) card.name = options.name;
  if (options.speed) card.speed = *options.speed;
  if (options.loop) card.loop = true;
  if (options.once) card.loop = false;
}

void write(const sim::GestureCard& card, const GestureOptions& options) {
  writeTextFile(options.out, valueOrFail(sim::formatGesture(card)), {options.recording, options.card});
  print(card, options.json);
}

void fromRecording(const GestureOptions& options) {
  const auto recording = valueOrFail(recording::Recording::open(options.recording));
  const auto touches = valueOrFail(exports::findTouches(*recording));
  if (options.touch > touches.size()) {
    throw Failure(
        say("{}: touch {}: expected 1 to {}, the touches it holds", options.recording, options.touch, touches.size()));
  }
  const std::string source = exports::touchName(options.recording, options.touch);
  auto card = valueOrFail(exports::gestureOf(*recording, touches[options.touch - 1], source, source));
  takeSettings(card, options);
  write(card, options);
}

void trim(const GestureOptions& options) {
  if (!(options.from_s < options.to_s)) {
    throw UsageError(say("--from {} --to {}: expected an end after the beginning", options.from_s, options.to_s));
  }
  auto card = valueOrFail(sim::readGestureFile(options.card));
  if (options.from_s > 0.0 || std::isfinite(options.to_s)) {
    card = valueOrFail(sim::trimmed(card, options.from_s, options.to_s));
  }
  takeSettings(card, options);
  write(card, options);
}

void addSettings(CLI::App& command, GestureOptions& options) {
  command.add_option("-o,--out", options.out, "The card to write")->required();
  command.add_option("--name", options.name, "What the card is called")->check([](const std::string& name) {
    if (name.empty() || sim::isGestureName(name)) return std::string();
    return fmt::format("'{}': expected a name as a card may have: 200 bytes, printable", name);
  });
  command.add_option("--speed", options.speed, "Played that much faster, 0.05 to 20")
      ->check(numberFrom(sim::kSlowestGesture, sim::kFastestGesture));
  auto* loop = command.add_flag("--loop", options.loop, "Played again and again");
  command.add_flag("--once", options.once, "Played once, then the finger stays lifted")->excludes(loop);
  command.add_flag("--json", options.json, "As JSON");
}

}  // namespace

void add_gesture(CLI::App& app) {
  auto options = std::make_shared<GestureOptions>();
  CLI::App* gesture = app.add_subcommand(
      "gesture", "Cards of gestures, from a recording's touches; fyd station --simulate --finger CARD plays one");
  gesture->require_subcommand(1);
  CLI::App* from = gesture->add_subcommand("from", "A card of a recording's touch");
  from->add_option("recording", options->recording, "Recording")->required();
  from->add_option("--touch", options->touch, "Which of its touches, from 1")
      ->transform(wholeNumberFrom(1))
      ->capture_default_str();
  addSettings(*from, *options);
  from->callback([options] { fromRecording(*options); });
  CLI::App* part = gesture->add_subcommand("trim", "Part of a card, or a card by another name or speed");
  part->add_option("card", options->card, "Card")->required();
  part->add_option("--from", options->from_s, "s, of the card's own time")->check(numberFrom(0.0, 600.0));
  part->add_option("--to", options->to_s, "s")->check(numberFrom(0.0, 600.0));
  addSettings(*part, *options);
  part->callback([options] { trim(*options); });
  CLI::App* show = gesture->add_subcommand("show", "What a card holds");
  show->add_option("card", options->card, "Card")->required();
  show->add_flag("--json", options->json, "As JSON");
  show->callback([options] { print(valueOrFail(sim::readGestureFile(options->card)), options->json); });
}

}  // namespace fyd::cli
