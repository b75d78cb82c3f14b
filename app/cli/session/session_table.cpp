// Entries of the catalogue as a table and as JSON.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iostream>

#include "app/cli/parts/terminal_text.h"
#include "app/cli/session/session_catalogue.h"

namespace fyd::cli {
namespace {

constexpr std::size_t kColumns = 9;
using TableRow = std::array<std::string, kColumns>;

/// In one line. Cut at a UTF-8 character boundary: bytes 10xxxxxx continue a character.
std::string shortened(const std::string& whole, std::size_t most) {
  std::string text = forTerminal(whole);
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\t'; }, '?');
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) continue;
    if (++characters > most) return text.substr(0, i) + "…";
  }
  return text;
}

std::string durationText(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// In characters, as fmt pads.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

nlohmann::ordered_json toJson(const catalogue::CatalogueEntry& entry) {
  return {{"id", entry.id},
          {"path", entry.path},
          {"file_state", catalogue::toString(entry.file_state)},
          {"station", entry.station},
          {"started_utc", entry.started_utc},
          {"duration_s", jsonNumber(entry.duration_s)},
          {"operator", entry.operator_name},
          {"subject", entry.subject},
          {"tags", entry.tags},
          {"notes", entry.notes},
          {"touchpad", entry.touchpad},
          {"robot", entry.robot},
          {"samples", entry.samples},
          {"gaps", entry.gaps},
          {"events", entry.events},
          {"wholeness", catalogue::toString(entry.wholeness)},
          {"health", entry.health},
          {"bytes", entry.bytes}};
}

nlohmann::ordered_json toJson(const catalogue::ScanReport& report) {
  return {
      {"added", report.added}, {"known", report.known}, {"copies", report.copies}, {"unreadable", report.unreadable}};
}

void printScan(const catalogue::ScanReport& report) {
  std::cout << fmt::format("{} added, {} known already\n", report.added, report.known);
  printLeftOut(report);
}

void printLeftOut(const catalogue::ScanReport& report) {
  for (const std::string& path : report.copies) std::cout << forTerminal(fmt::format("copy, left out: {}\n", path));
  for (const Message& problem : report.unreadable) std::cout << forTerminal(fmt::format("not read: {}\n", problem));
}

void printEntries(const std::vector<catalogue::CatalogueEntry>& entries) {
  std::vector<TableRow> rows = {
      {"id", "started (UTC)", "length", "operator", "subject", "health", "MB", "tags", "file"}};
  for (const catalogue::CatalogueEntry& entry : entries) {
    const bool present = entry.file_state == catalogue::FileState::present;
    rows.push_back(
        {shortened(entry.id.substr(0, 8), 8), shortened(entry.started_utc.substr(0, 19), 19),
         durationText(entry.duration_s), shortened(entry.operator_name, 20), shortened(entry.subject, 20),
         shortened(entry.health, 12), fmt::format("{:.1f}", static_cast<double>(entry.bytes) / 1e6),
         shortened(fmt::format("{}", fmt::join(entry.tags, ",")), 30),
         (present ? "" : fmt::format("[{}] ", catalogue::toString(entry.file_state))) + shortened(entry.path, 400)});
  }
  std::array<std::size_t, kColumns> widths{};
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (const TableRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i + 1 < kColumns; ++i) {
      const bool is_number = i == 2 || i == 6;
      line += is_number ? fmt::format("{:>{}}  ", row[i], widths[i]) : fmt::format("{:<{}}  ", row[i], widths[i]);
    }
    std::cout << line << row.back() << '\n';
  }
}

}  // namespace fyd::cli
