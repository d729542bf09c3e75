#include "journal.hpp"

#include <sqlite3.h>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

InvalidInput unusable(const std::filesystem::path& file, std::string problem, std::string advice) {
  return InvalidInput("", "", "journal " + file.string() + ": " + std::move(problem), std::move(advice));
}

}  // namespace

void Journal::Close::operator()(sqlite3* database) const { sqlite3_close(database); }
void Journal::Close::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Journal::Statement Journal::prepare(const std::string& sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) {
    throw ComputationFailed("journal " + file_.string() + ": " + sqlite3_errmsg(database_.get()));
  }
  return Statement(statement);
}

void Journal::execute(const std::string& sql) const {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    throw ComputationFailed("journal " + file_.string() + ": " + sqlite3_errmsg(database_.get()));
  }
}

Journal::Journal(std::filesystem::path file, const Identity& identity) : file_(std::move(file)) {
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file_.c_str(), &database);
  database_.reset(database);
  const std::string place = "choose a place you may write to with -o OUT.nc";
  if (opened != SQLITE_OK)
    throw unusable(file_, "cannot be opened (" + std::string(sqlite3_errstr(opened)) + ")", place);
  try {
    // Exclusive: no shared memory, which network file systems lack, and no second sweep into the same file.
    execute("PRAGMA locking_mode = EXCLUSIVE");
    execute("PRAGMA journal_mode = WAL");
    execute("PRAGMA synchronous = NORMAL");
    if (has_tables()) {
      compare(identity);
    } else {
      begin(identity);
    }
    insert_ = prepare("INSERT OR REPLACE INTO chunk VALUES (?1, ?2)");
  } catch (const ComputationFailed&) {
    const int code = sqlite3_errcode(database_.get());
    if (code == SQLITE_BUSY)
      throw unusable(file_, "another sweep is writing to it", "wait for that, or choose another -o");
    if (code == SQLITE_NOTADB) throw unusable(file_, "is not a journal of turgor", "remove it, or choose another -o");
    throw unusable(file_, "cannot be written to (" + std::string(sqlite3_errmsg(database_.get())) + ")", place);
  }
}

Journal::~Journal() = default;

bool Journal::has_tables() const {
  const Statement query = prepare("SELECT count(*) FROM sqlite_master WHERE name IN ('identity', 'chunk')");
  if (sqlite3_step(query.get()) != SQLITE_ROW) throw ComputationFailed("cannot be read");
  return sqlite3_column_int(query.get(), 0) == 2;
}

void Journal::begin(const Identity& identity) {
  execute("BEGIN");
  execute("CREATE TABLE identity (name TEXT, value TEXT)");
  execute("CREATE TABLE chunk (number INTEGER PRIMARY KEY, data BLOB)");
  const Statement insert = prepare("INSERT INTO identity VALUES (?1, ?2)");
  for (const auto& [name, value] : identity) {
    sqlite3_bind_text(insert.get(), 1, name.data(), static_cast<int>(name.size()), SQLITE_STATIC);
    sqlite3_bind_text(insert.get(), 2, value.data(), static_cast<int>(value.size()), SQLITE_STATIC);
    sqlite3_step(insert.get());
    sqlite3_reset(insert.get());
  }
  execute("COMMIT");
}

void Journal::compare(const Identity& identity) const {
  const Statement query = prepare("SELECT value FROM identity WHERE name = ?1");
  for (const auto& [name, value] : identity) {
    sqlite3_bind_text(query.get(), 1, name.data(), static_cast<int>(name.size()), SQLITE_STATIC);
    std::string stored;
    if (sqlite3_step(query.get()) == SQLITE_ROW) {
      const auto* bytes = static_cast<const char*>(sqlite3_column_blob(query.get(), 0));
      if (bytes != nullptr) stored.assign(bytes, static_cast<std::size_t>(sqlite3_column_bytes(query.get(), 0)));
    }
    sqlite3_reset(query.get());
    if (stored == value) continue;
    throw unusable(file_, "belongs to another sweep; the " + name + " differs: " + first_difference(stored, value),
                   "start over with --force, or choose another file with -o");
  }
}

std::vector<bool> Journal::finished(std::uint64_t chunks) const {
  std::vector<bool> done(chunks, false);
  const Statement query = prepare("SELECT number FROM chunk");
  int code = 0;
  while ((code = sqlite3_step(query.get())) == SQLITE_ROW) {
    const auto number = static_cast<std::uint64_t>(sqlite3_column_int64(query.get(), 0));
    if (number < chunks) done[number] = true;
  }
  if (code != SQLITE_DONE)
    throw ComputationFailed("journal " + file_.string() + ": " + sqlite3_errmsg(database_.get()));
  return done;
}

void Journal::store(std::uint64_t chunk, const std::string& bytes) {
  sqlite3_bind_int64(insert_.get(), 1, static_cast<sqlite3_int64>(chunk));
  sqlite3_bind_blob64(insert_.get(), 2, bytes.data(), bytes.size(), SQLITE_STATIC);
  const int code = sqlite3_step(insert_.get());
  sqlite3_reset(insert_.get());
  if (code != SQLITE_DONE) {
    throw ComputationFailed("cannot write " + file_.string() + " (" + sqlite3_errstr(code) +
                            "): is the disk full? What was finished is kept; make room and go on with --resume");
  }
}

void Journal::read(const std::function<void(const std::string&)>& use) const {
  const Statement query = prepare("SELECT data FROM chunk ORDER BY number");
  int code = 0;
  while ((code = sqlite3_step(query.get())) == SQLITE_ROW) {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(query.get(), 0));
    use({bytes, static_cast<std::size_t>(sqlite3_column_bytes(query.get(), 0))});
  }
  if (code != SQLITE_DONE)
    throw ComputationFailed("journal " + file_.string() + ": " + sqlite3_errmsg(database_.get()));
}

void Journal::remove() {
  insert_.reset();
  database_.reset();
  remove_journal(file_);
}

void remove_journal(const std::filesystem::path& file) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(file.string() + ending, ignored);
}

}  // namespace turgor
