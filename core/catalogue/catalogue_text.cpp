#include "core/catalogue/catalogue_text.h"

#include <clocale>
#include <cwctype>

#include <algorithm>
#include <boost/locale/encoding_utf.hpp>
#include <cmath>
#include <limits>
#include <sstream>

namespace fyd::catalogue {
namespace {

namespace utf = boost::locale::conv;

constexpr std::size_t kLongestField = 4096;
constexpr std::size_t kLongestNotes = std::size_t{1024} * 1024;
constexpr std::size_t kLongestTag = 200;
constexpr std::size_t kMostTags = 100;

bool isControl(wchar_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }
bool isLine(wchar_t c) { return c == L'\n' || c == L'\t' || c == L'\r'; }

Result<void> checkText(std::string_view field, std::string_view text, std::size_t longest, bool lines = false) {
  if (text.size() > longest) {
    return fail("{}: {} bytes long, at most {} are catalogued", field, text.size(), longest);
  }
  try {
    for (const wchar_t c : utf::utf_to_utf<wchar_t>(text.data(), text.data() + text.size(), utf::stop)) {
      if (isControl(c) && !(lines && isLine(c))) {
        return fail("{}: holds the control character U+{:04X}", field, static_cast<unsigned>(c));
      }
    }
  } catch (const utf::conversion_error&) {
    return fail("{}: not UTF-8", field);
  }
  return {};
}

bool isId(std::string_view id) {
  return !id.empty() && id.size() <= 64 && std::ranges::all_of(id, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
  });
}

/// At most so many bytes.
std::string cut(std::string text, std::size_t longest) {
  constexpr std::string_view kMore = "…";
  if (text.size() <= longest) return text;
  std::size_t end = longest - kMore.size();
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // within a character
  return text.substr(0, end).append(kMore);
}

/// Lower case by glibc's table of all scripts, independent of the user's locale.
wchar_t smallLetter(wchar_t c) {
  static const locale_t kTable = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  return kTable ? static_cast<wchar_t>(towlower_l(static_cast<wint_t>(c), kTable))
                : static_cast<wchar_t>(std::towlower(static_cast<wint_t>(c)));
}

}  // namespace

Result<void> checkNotes(std::string_view notes) { return checkText("notes", notes, kLongestNotes, true); }

Result<void> checkTags(const std::vector<std::string>& tags) {
  if (tags.size() > kMostTags) return fail("tags: {}, at most {} are catalogued", tags.size(), kMostTags);
  for (const std::string& tag : tags) {
    if (splitWords(tag).empty()) return fail("tag '{}': empty", tag);
    if (auto ok = checkText("tag", tag, kLongestTag); !ok) return ok;
  }
  return {};
}

Result<void> checkEntry(const CatalogueEntry& entry) {
  if (!isId(entry.id)) return fail("recording's id '{}': expected 1 to 64 letters, digits or dashes", entry.id);
  if (entry.path.empty() || entry.path.front() != '/') return fail("path '{}': expected an absolute one", entry.path);
  const std::pair<const char*, const std::string*> fields[] = {{"path", &entry.path},
                                                               {"station", &entry.station},
                                                               {"started_utc", &entry.started_utc},
                                                               {"operator", &entry.operator_name},
                                                               {"subject", &entry.subject},
                                                               {"touchpad", &entry.touchpad},
                                                               {"robot", &entry.robot},
                                                               {"health", &entry.health}};
  for (const auto& [name, text] : fields) {
    if (auto ok = checkText(name, *text, kLongestField); !ok) return ok;
  }
  if (auto ok = checkNotes(entry.notes); !ok) return ok;
  if (auto ok = checkTags(entry.tags); !ok) return ok;
  if (auto started = parseUtc(entry.started_utc); !started) return fail("started_utc: {}", started.error().message);
  if (!std::isfinite(entry.duration_s) || entry.duration_s < 0.0) {
    return fail("duration {} s: expected 0 or more", entry.duration_s);
  }
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  for (const std::uint64_t number : {entry.samples, entry.gaps, entry.events, entry.bytes}) {
    if (number > kMost) return fail("recording {}: the count {} is beyond all measure", entry.id, number);
  }
  return {};
}

std::string foldCase(std::string_view utf8) {
  std::wstring wide = utf::utf_to_utf<wchar_t>(utf8.data(), utf8.data() + utf8.size(), utf::skip);
  std::ranges::transform(wide, wide.begin(), smallLetter);
  return utf::utf_to_utf<char>(wide);
}

std::string searchText(const CatalogueEntry& entry) {
  std::string all = entry.operator_name + '\n' + entry.subject + '\n' + entry.notes;
  for (const std::string& tag : entry.tags) all += '\n' + tag;
  return foldCase(all);
}

std::vector<std::string> splitWords(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::string likeAnywhere(std::string_view text) {
  std::string pattern = "%";
  for (const char c : text) {
    if (c == '%' || c == '_' || c == '!') pattern += '!';
    pattern += c;
  }
  return pattern + '%';
}

std::string cleanedText(std::string_view text, bool lines) {
  std::wstring wide = utf::utf_to_utf<wchar_t>(text.data(), text.data() + text.size(), utf::skip);
  std::ranges::replace_if(
      wide, [lines](wchar_t c) { return isControl(c) && !(lines && isLine(c)); }, L' ');
  return utf::utf_to_utf<char>(wide);
}

CatalogueEntry withFittingTexts(CatalogueEntry entry) {
  for (std::string* text : {&entry.operator_name, &entry.subject, &entry.touchpad, &entry.robot}) {
    *text = cut(cleanedText(*text, false), kLongestField);
  }
  entry.notes = cut(cleanedText(entry.notes, true), kLongestNotes);
  for (std::string& tag : entry.tags) tag = cut(cleanedText(tag, false), kLongestTag);
  std::erase_if(entry.tags, [](const std::string& tag) { return splitWords(tag).empty(); });
  entry.tags.resize(std::min(entry.tags.size(), kMostTags));
  return entry;
}

Result<UtcSpan> parseUtc(std::string_view text) {
  std::string_view rest = text;
  const auto number = [&rest](std::size_t digits, int& value) {
    if (rest.size() < digits) return false;
    value = 0;
    for (const char c : rest.substr(0, digits)) {
      if (c < '0' || c > '9') return false;
      value = value * 10 + (c - '0');
    }
    rest.remove_prefix(digits);
    return true;
  };
  const auto sign = [&rest](char c) {
    if (!rest.starts_with(c)) return false;
    rest.remove_prefix(1);
    return true;
  };
  const auto wrong = [text] {
    return fail("time '{}': expected UTC as 2026-11-21, 2026-11-21T14:05 or 2026-11-21T14:05:09.250Z", text);
  };
  int year = 0;
  int month = 0;
  int day = 0;
  if (!number(4, year) || !sign('-') || !number(2, month) || !sign('-') || !number(2, day)) return wrong();
  const std::chrono::year_month_day date{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok() || year < 1970) return wrong();
  std::int64_t begin_ms = std::int64_t{std::chrono::sys_days{date}.time_since_epoch().count()} * 86'400'000;
  std::int64_t length_ms = 86'400'000;
  if (sign('T') || sign(' ')) {
    int hour = 0;
    int minute = 0;
    int second = 0;
    if (!number(2, hour) || !sign(':') || !number(2, minute) || hour > 23 || minute > 59) return wrong();
    length_ms = 60'000;
    if (sign(':')) {
      if (!number(2, second) || second > 60) return wrong();
      length_ms = 1000;
      if (sign('.')) {
        int digits = 0;
        int millisecond = 0;
        for (int digit = 0; number(1, digit); ++digits) {
          if (digits < 3) millisecond = millisecond * 10 + digit;
        }
        if (digits == 0) return wrong();
        for (; digits < 3; ++digits) millisecond *= 10;
        begin_ms += millisecond;
        length_ms = 1;
      }
    }
    begin_ms += (hour * 60LL + minute) * 60'000 + second * 1000LL;
    sign('Z');
  }
  if (!rest.empty()) return wrong();
  return UtcSpan{begin_ms, begin_ms + length_ms};
}

}  // namespace fyd::catalogue
