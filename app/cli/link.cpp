// fyd link keygen, show: the key that both ends of FYD Link share.
#include <iostream>

#include "app/cli/parts/command.h"
#include "core/protocol/link/link_key_file.h"

namespace fyd::cli {
namespace {

struct LinkOptions {
  std::string file;
  bool from_words = false;
  bool fingerprint_only = false;
  bool json = false;
};

void printKey(const protocol::LinkKey& key, const LinkOptions& options) {
  std::string words = options.fingerprint_only ? "" : key.words();
  if (options.json) {
    nlohmann::ordered_json out{{"file", options.file}, {"fingerprint", key.fingerprint()}};
    if (!options.fingerprint_only) out["words"] = words;
    printJson(out);
  } else {
    if (!options.fingerprint_only) std::cout << words << '\n';
    std::cout << "fingerprint " << key.fingerprint() << '\n';
  }
  protocol::wipe(words);
}

void keygen(const LinkOptions& options) {
  if (!options.from_words) {
    const protocol::LinkKey key = protocol::LinkKey::generate();
    valueOrFail(protocol::writeKeyFile(key, options.file));
    printKey(key, options);
    return;
  }
  // The words are read from standard input: every user of the machine can see command lines.
  std::cerr << "Type the " << protocol::kPairingWords << " words, then Enter:\n";
  std::string words;
  std::getline(std::cin, words);
  const auto key = protocol::LinkKey::parseWords(words);
  protocol::wipe(words);
  const protocol::LinkKey good = valueOrFail(key);
  valueOrFail(protocol::writeKeyFile(good, options.file));
  LinkOptions quiet = options;
  quiet.fingerprint_only = true;
  printKey(good, quiet);
}

}  // namespace

void add_link(CLI::App& app) {
  CLI::App* link = app.add_subcommand("link", "Keys of FYD Link, the secured protocol between touchpad and robot");
  link->require_subcommand(1);
  auto options = std::make_shared<LinkOptions>();

  CLI::App* make = link->add_subcommand("keygen", "Make a key file that only its owner can read; print its words");
  make->add_option("file", options->file, "Key file to make; it must not exist yet")->required();
  make->add_flag("--words", options->from_words, "From the other end's words, typed in, in place of a new key");
  make->add_flag("--json", options->json, "Result as JSON");
  make->callback([options] { keygen(*options); });

  CLI::App* show = link->add_subcommand("show", "Print a key file's pairing words and fingerprint");
  show->add_option("file", options->file, "Key file")->required();
  show->add_flag("--fingerprint", options->fingerprint_only, "The fingerprint alone, which is no secret");
  show->add_flag("--json", options->json, "Result as JSON");
  show->callback([options] { printKey(valueOrFail(protocol::readKeyFile(options->file)), *options); });
}

}  // namespace fyd::cli
