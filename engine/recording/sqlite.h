// SPDX-License-Identifier: MIT
// A thin wrapper of SQLite: a database, and a statement whose parameters are put and whose columns
// are got one after the other. No exceptions: a call that fails says so, Database::problem() says
// why.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace svoscope {

/// The file begins as every SQLite file does.
bool isSqliteFile(const std::filesystem::path& file);
/// Bytes that the file should have by its header; 0 if that cannot be told.
std::int64_t sizeByHeader(const std::filesystem::path& file);

class Database {
 public:
  enum class Mode { read, create };

  /// Null if it cannot be opened; `problem` says why.
  static std::unique_ptr<Database> open(const std::filesystem::path& file, Mode mode,
                                        std::string& problem);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// One or several statements without parameters or results.
  bool run(const std::string& sql);
  /// First column of the first row; `otherwise` if there is none or the statement fails.
  std::int64_t integer(const std::string& sql, std::int64_t otherwise = -1);

  std::string problem() const;  ///< of the last call that failed
  /// The last failure: the file is no database, or its pages are wrong.
  bool damaged() const;
  /// The last call failed, for whatever reason.
  bool failed() const;
  sqlite3* handle() const { return db_; }

 private:
  explicit Database(sqlite3* db) : db_(db) {}
  sqlite3* db_;
};

class Query {
 public:
  Query() = default;
  Query(Database& database, const std::string& sql);
  ~Query();
  Query(Query&& o) noexcept;
  Query& operator=(Query&& o) noexcept;

  /// False: the statement does not fit the database.
  bool valid() const { return statement_ != nullptr; }

  // Parameters, from the first on. Blobs and texts must live until run() or the last next(). NaN
  // becomes NULL.
  Query& put(std::int64_t value);
  Query& put(int value) { return put(static_cast<std::int64_t>(value)); }
  Query& put(bool value) { return put(static_cast<std::int64_t>(value)); }
  Query& put(double value);
  Query& put(const std::string& text);
  Query& put(const char* text);
  Query& putBlob(const void* data, std::size_t size);
  Query& putNull();

  /// Carries a statement without results out and makes it ready for the next parameters.
  bool run();
  /// Goes to the next row. False at the end or on failure (see failed()), the statement is ready
  /// again.
  bool next();
  bool failed() const { return failed_; }
  void reset();

  // Columns of the row, from the first on. NULL is NaN, 0 or "".
  std::int64_t integer();
  double real();
  std::string text();
  /// Valid until the next call of next() or reset().
  const unsigned char* blob(std::size_t& size);

 private:
  sqlite3_stmt* statement_ = nullptr;
  int parameter_ = 0, column_ = 0;
  bool failed_ = false;
};

}  // namespace svoscope
