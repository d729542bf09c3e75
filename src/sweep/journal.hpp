#pragma once
// Finished chunks, kept on disk while a sweep is under way: an SQLite database beside the result.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace turgor {

/// What a sweep's results depend on, by name; all of it must agree for a journal to be continued.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// A journal of finished chunks. Each is stored in a transaction of its own: whenever the process ends, what was stored
/// before is whole.
class Journal {
 public:
  /// Opens an existing journal or begins a new one.
  /// @throws InvalidInput when it belongs to another sweep (naming what differs), is in use, is no journal, or cannot
  /// be written
  Journal(std::filesystem::path file, const Identity& identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  Journal(Journal&&) = delete;
  Journal& operator=(Journal&&) = delete;

  /// Chunks that are finished, by number.
  [[nodiscard]] std::vector<bool> finished(std::uint64_t chunks) const;

  /// @throws ComputationFailed when it cannot be stored: the disk is full
  void store(std::uint64_t chunk, const std::string& bytes);

  /// Calls use(bytes) for every chunk in order of its number.
  void read(const std::function<void(const std::string&)>& use) const;

  /// Closes the journal and removes its files.
  void remove();

 private:
  struct Close {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;

  [[nodiscard]] Statement prepare(const std::string& sql) const;
  void execute(const std::string& sql) const;
  void begin(const Identity& identity);
  void compare(const Identity& identity) const;
  [[nodiscard]] bool has_tables() const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> database_;
  Statement insert_;
};

/// Removes a journal's files.
void remove_journal(const std::filesystem::path& file);

}  // namespace turgor
