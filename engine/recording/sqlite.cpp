// SPDX-License-Identifier: MIT
#include "engine/recording/sqlite.h"

#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <utility>

namespace svoscope {

bool isSqliteFile(const std::filesystem::path& file) {
  static constexpr char kMagic[] = "SQLite format 3";  // with its closing zero 16 bytes
  char head[sizeof(kMagic)] = {};
  std::ifstream in(file, std::ios::binary);
  in.read(head, sizeof(head));
  return in && std::equal(head, head + sizeof(head), kMagic);
}

std::int64_t sizeByHeader(const std::filesystem::path& file) {
  unsigned char head[100] = {};  // SQLite database file format, section 1.3
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(head), sizeof(head));
  if (!in) return sizeof(head);
  const auto number = [&](int at, int bytes) {
    std::int64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | head[at + i];
    return value;
  };
  const std::int64_t page = number(16, 2) == 1 ? 65536 : number(16, 2);
  return number(24, 4) == number(92, 4) ? page * number(28, 4) : 0;
}

std::unique_ptr<Database> Database::open(const std::filesystem::path& file, Mode mode,
                                         std::string& problem) {
  const int flags =
      (mode == Mode::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE) |
      SQLITE_OPEN_NOMUTEX;  // one connection is used by one thread at a time
  sqlite3* db = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &db, flags, nullptr);
  std::unique_ptr<Database> database(new Database(db));
  if (code == SQLITE_OK) {
    sqlite3_extended_result_codes(db, 1);
    return database;
  }
  problem = db ? sqlite3_errmsg(db) : sqlite3_errstr(code);
  return nullptr;
}

Database::~Database() { sqlite3_close(db_); }

bool Database::run(const std::string& sql) {
  return sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
}

std::int64_t Database::integer(const std::string& sql, std::int64_t otherwise) {
  Query query(*this, sql);
  return query.valid() && query.next() ? query.integer() : otherwise;
}

std::string Database::problem() const { return sqlite3_errmsg(db_); }

bool Database::damaged() const {
  const int code = sqlite3_errcode(db_) & 0xff;
  return code == SQLITE_CORRUPT || code == SQLITE_NOTADB || code == SQLITE_IOERR;
}

bool Database::failed() const {
  const int code = sqlite3_errcode(db_);
  return code != SQLITE_OK && code != SQLITE_ROW && code != SQLITE_DONE;
}

Query::Query(Database& database, const std::string& sql) {
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), static_cast<int>(sql.size()), &statement_,
                         nullptr) != SQLITE_OK)
    statement_ = nullptr;
}

Query::~Query() { sqlite3_finalize(statement_); }

Query::Query(Query&& o) noexcept : statement_(std::exchange(o.statement_, nullptr)) {}

Query& Query::operator=(Query&& o) noexcept {
  std::swap(statement_, o.statement_);
  return *this;
}

Query& Query::put(std::int64_t value) {
  sqlite3_bind_int64(statement_, ++parameter_, value);
  return *this;
}

Query& Query::put(double value) {
  sqlite3_bind_double(statement_, ++parameter_, value);
  return *this;
}

Query& Query::put(const std::string& text) {
  sqlite3_bind_text(statement_, ++parameter_, text.data(), static_cast<int>(text.size()),
                    SQLITE_STATIC);
  return *this;
}

Query& Query::put(const char* text) {
  sqlite3_bind_text(statement_, ++parameter_, text, -1, SQLITE_STATIC);
  return *this;
}

Query& Query::putBlob(const void* data, std::size_t size) {
  sqlite3_bind_blob(statement_, ++parameter_, data, static_cast<int>(size), SQLITE_STATIC);
  return *this;
}

Query& Query::putNull() {
  sqlite3_bind_null(statement_, ++parameter_);
  return *this;
}

bool Query::run() {
  if (!statement_) return false;
  const int code = sqlite3_step(statement_);
  sqlite3_reset(statement_);
  parameter_ = 0;
  return code == SQLITE_DONE || code == SQLITE_ROW;
}

bool Query::next() {
  if (!statement_) return false;
  column_ = 0;
  const int code = sqlite3_step(statement_);
  failed_ = code != SQLITE_ROW && code != SQLITE_DONE;
  if (code == SQLITE_ROW) return true;
  sqlite3_reset(statement_);
  parameter_ = 0;
  return false;
}

void Query::reset() {
  sqlite3_reset(statement_);
  parameter_ = 0;
}

std::int64_t Query::integer() { return sqlite3_column_int64(statement_, column_++); }

double Query::real() {
  const int column = column_++;
  if (sqlite3_column_type(statement_, column) == SQLITE_NULL)
    return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(statement_, column);
}

std::string Query::text() {
  const int column = column_++;
  const auto* text = sqlite3_column_text(statement_, column);
  if (!text) return "";
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

const unsigned char* Query::blob(std::size_t& size) {
  const int column = column_++;
  const auto* data = static_cast<const unsigned char*>(sqlite3_column_blob(statement_, column));
  size = data ? static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)) : 0;
  return data;
}

}  // namespace svoscope
