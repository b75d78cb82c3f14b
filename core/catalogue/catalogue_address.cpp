#include "core/catalogue/catalogue_address.h"

#include <pwd.h>
#include <unistd.h>

#include <libpq-fe.h>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace fyd::catalogue {
namespace {

constexpr std::string_view kSqlite = "sqlite:";
constexpr std::string_view kPostgresql = "postgresql:";

std::string asValue(std::string_view value) {
  std::string out = "'";
  for (const char c : value) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

Result<CatalogueAddress> postgresql(std::string_view word) {
  const std::string_view after = word.substr(kPostgresql.size());
  const std::string text(after.starts_with("//") ? word : after);
  // libpq's error message quotes the words, which may contain a mistyped password: it is not passed on.
  const std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)> options(PQconninfoParse(text.c_str(), nullptr),
                                                                             PQconninfoFree);
  if (!options) {
    return fail("catalogue: libpq cannot read the words after '{}'; expected host=… dbname=… user=…", kPostgresql);
  }
  CatalogueAddress out{.kind = CatalogueAddress::Kind::postgresql};
  std::string host = "this computer";
  std::string database = "default";
  std::string extra;
  for (const PQconninfoOption* option = options.get(); option->keyword; ++option) {
    const std::string_view key = option->keyword;
    if (!option->val) continue;
    if (key == "password" || key == "sslpassword") {
      return fail(
          "catalogue: the word carries a password, which logs and lists of processes would show; put it into "
          "~/.pgpass (mode 600) instead");
    }
    if (key == "host" || key == "hostaddr") host = option->val;
    if (key == "dbname") database = option->val;
    if (key == "options") {
      extra = std::string(" ") + option->val;
      continue;
    }
    if (key == "client_encoding") continue;
    out.target += fmt::format("{}={} ", key, asValue(option->val));
  }
  out.key = fmt::format("{}{}{}", kPostgresql, out.target, extra);
  // A dead computer or cable is noticed within 10 s; below, the server limits a request to 10 s and the wait for a lock
  // to 5 s. Nothing bounds a server process that is frozen while its kernel acknowledges: libpq waits for its answer.
  constexpr std::pair<std::string_view, std::string_view> kDefaults[] = {
      {"connect_timeout", "5"}, {"keepalives_idle", "5"}, {"tcp_user_timeout", "10000"}, {"application_name", "fyd"}};
  for (const auto& [key, value] : kDefaults) {
    if (out.target.find(fmt::format("{}=", key)) == std::string::npos) out.target += fmt::format("{}={} ", key, value);
  }
  out.target += "client_encoding=UTF8 options=" +
                asValue("-c statement_timeout=10000 -c lock_timeout=5000 -c client_min_messages=warning" + extra);
  out.name = fmt::format("PostgreSQL catalogue '{}' on {}", database, host);
  return out;
}

Result<CatalogueAddress> sqlite(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error).lexically_normal();
  if (path.empty() || error || !absolute.has_filename()) return fail("catalogue 'sqlite:{}': expected a file", path);
  if (absolute.native().find('"') != std::string::npos) {
    return fail("catalogue '{}': a path with a quotation mark is not possible", path);
  }
  return CatalogueAddress{
      .kind = CatalogueAddress::Kind::sqlite, .target = absolute, .name = absolute, .key = absolute};
}

}  // namespace

Result<CatalogueAddress> parseCatalogueAddress(std::string_view word) {
  if (word == "none") return CatalogueAddress{.kind = CatalogueAddress::Kind::none, .name = "no catalogue"};
  if (word.starts_with(kPostgresql)) return postgresql(word);
  if (const auto at = word.find("://"); at != std::string_view::npos) {  // it may hold a password: it is not repeated
    return fail("catalogue '{}://…': expected sqlite:PATH, postgresql:host=… dbname=… user=…, or none",
                word.substr(0, at));
  }
  if (word.empty() || word == "sqlite") return sqlite(catalogueFolder() + "/sessions.sqlite");
  if (word.starts_with(kSqlite)) return sqlite(std::string(word.substr(kSqlite.size())));
  if (word.find('/') != std::string_view::npos || word.ends_with(".sqlite")) return sqlite(std::string(word));
  // Words for libpq without the first one may hold a password, too.
  const std::size_t value = word.find('=');
  return fail("catalogue '{}': expected sqlite:PATH, postgresql:host=… dbname=… user=…, or none",
              value == std::string_view::npos ? std::string(word) : fmt::format("{}=…", word.substr(0, value)));
}

bool isDefault(const CatalogueAddress& address) {
  const auto own = parseCatalogueAddress({});
  return own && own->key == address.key;
}

std::string catalogueFolder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data && *data == '/') return std::string(data) + "/fyd-console";  // XDG demands that relative ones are ignored
  const char* home = std::getenv("HOME");
  const passwd* user = home && *home ? nullptr : getpwuid(getuid());
  return std::string(user ? user->pw_dir : home ? home : "") + "/.local/share/fyd-console";
}

std::string pendingPath() { return catalogueFolder() + "/pending.sqlite"; }

std::string stationName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "unnamed";
  return name.data();
}

}  // namespace fyd::catalogue
