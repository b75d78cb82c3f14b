// One connection to the catalogue's database through SOCI: opening, transactions, and error messages.
// Statements are written once for SQLite and PostgreSQL; every value is a bound parameter, never part of the text.
#pragma once

#include <soci/soci.h>

#include <deque>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

#include "core/base/error.h"
#include "core/catalogue/catalogue_address.h"

namespace fyd::catalogue {

/// The tables, step by step: step N brings version N to N + 1. Published steps are never changed, only added to.
using SchemaSteps = std::span<const std::span<const char* const>>;
[[nodiscard]] SchemaSteps catalogueSchema();
[[nodiscard]] SchemaSteps pendingSchema();

/// Whether a SQLite file, which is one program's, has tables and none of them is ours.
[[nodiscard]] bool isOfAnother(soci::session& sqlite);

/// SQLite's name for a database without a file.
inline constexpr const char* kInMemory = ":memory:";

class CatalogueDatabase {
 public:
  [[nodiscard]] static Result<std::unique_ptr<CatalogueDatabase>> open(const CatalogueAddress& word,
                                                                       SchemaSteps schema);

  /// One transaction around `work(soci::session&) -> Result<T>`: committed when it succeeds, rolled back when it
  /// returns an error or throws. `write` takes SQLite's lock at once, so that waiting for it needs no second attempt.
  template <class Work>
  auto read(Work&& work) {
    return transact("BEGIN", work);
  }
  template <class Work>
  auto write(Work&& work) {
    return transact(word_.kind == CatalogueAddress::Kind::sqlite ? "BEGIN IMMEDIATE" : "BEGIN", work);
  }

  [[nodiscard]] const CatalogueAddress& word() const { return word_; }
  /// Whether the last error was about the values of one statement: others may go in, as the database answers.
  [[nodiscard]] bool refusedValues() const { return refused_values_; }

 private:
  explicit CatalogueDatabase(CatalogueAddress word) : word_(std::move(word)) {}

  /// Rolled back unless `keep` was called.
  class Transaction {
   public:
    Transaction(soci::session& session, const char* begin) : session_(session) { session_ << begin; }
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void keep();

   private:
    soci::session& session_;
    bool open_ = true;
  };

  template <class Work>
  auto transact(const char* begin, Work& work) -> std::invoke_result_t<Work&, soci::session&> {
    try {
      if (lost_) connect();
      Transaction transaction(session_, begin);
      auto result = work(session_);
      if (result) transaction.keep();
      return result;
    } catch (const std::exception& error) {
      return tl::unexpected(explained(error));
    }
  }

  void connect();
  [[nodiscard]] Error explained(const std::exception& error);
  [[nodiscard]] Result<void> prepareSchema(SchemaSteps schema);

  CatalogueAddress word_;
  soci::session session_;
  bool lost_ = true;  ///< connect before the next transaction
  bool refused_values_ = false;
};

/// Whether the SQLite file at `path` is damaged; an error when that cannot be found out (locked, not readable), or when
/// it is another file than a catalogue.
[[nodiscard]] Result<bool> isDamaged(const std::string& path);

/// Programs that have the file open, as "fyd (process 4711)"; those of other users are not found. Empty: none found.
[[nodiscard]] std::string holdersOf(const std::string& path);

/// A statement whose number of bound values is known only at run time.
class BoundStatement {
 public:
  explicit BoundStatement(soci::session& session) : statement_(session) {}
  void bind(const std::string& name, std::string value);
  void bind(const std::string& name, long long value);
  template <class T>
  void into(T& value) {
    statement_.exchange(soci::into(value));
  }
  void execute(const std::string& sql);
  /// @return false after the last row
  [[nodiscard]] bool fetch() { return statement_.fetch(); }

 private:
  soci::statement statement_;
  std::deque<std::pair<std::string, std::string>> texts_;  // SOCI keeps references: these never move
  std::deque<std::pair<std::string, long long>> numbers_;
};

}  // namespace fyd::catalogue
