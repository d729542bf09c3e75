#include "turgor/fem/checkpoint.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t magic = 0x54'55'52'47'4F'52'43'50;  // "TURGORCP", and the order of bytes
constexpr std::uint64_t format = 1;
constexpr const char* newest_name = "checkpoint.bin";
constexpr const char* previous_name = "checkpoint.previous.bin";

class Writer {
 public:
  void put(std::uint64_t number) { append(&number, sizeof number); }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    append(text.data(), text.size());
  }
  void put(const std::vector<double>& numbers, const std::string& name) {
    for (const double number : numbers) {
      if (!std::isfinite(number)) {
        throw ComputationFailed("the state is not finite: \"" + name + "\" has " + shortest(number));
      }
    }
    put(std::uint64_t{numbers.size()});
    append(numbers.data(), numbers.size() * sizeof(double));
  }
  std::string finish() && {
    put(fingerprint(bytes_));
    return std::move(bytes_);
  }

 private:
  void append(const void* from, std::size_t size) { bytes_.append(static_cast<const char*>(from), size); }
  std::string bytes_;
};

class Parser {
 public:
  explicit Parser(const std::string& bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    take(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string value(count(1), '\0');
    take(value.data(), value.size());
    return value;
  }
  std::vector<double> reals() {
    std::vector<double> values(count(sizeof(double)));
    take(values.data(), values.size() * sizeof(double));
    return values;
  }

 private:
  /// A number of items that are still to come.
  std::size_t count(std::size_t size) {
    const std::uint64_t n = number();
    if (n > (bytes_.size() - at_) / size) throw ComputationFailed("it is cut short");
    return n;
  }
  void take(void* to, std::size_t size) {
    if (size > bytes_.size() - at_) throw ComputationFailed("it is cut short");
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

[[noreturn]] void cannot_write(const fs::path& file) {
  throw ComputationFailed("cannot write " + file.string() + " (" + std::strerror(errno) +
                          "): is the disk full?");  // NOLINT: one thread
}

/// Opens, writes or not, and syncs; a folder is synced so that its renames last.
void sync(const fs::path& path, int flags, const std::string& bytes) {
  const int file = open(path.c_str(), flags | O_CLOEXEC, 0666);  // NOLINT: POSIX
  if (file < 0) cannot_write(path);
  std::size_t done = 0;
  bool good = true;
  while (good && done < bytes.size()) {
    const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
    good = written >= 0 || errno == EINTR;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  good = good && fsync(file) == 0;
  const int reason = errno;
  close(file);
  errno = reason;
  if (!good) cannot_write(path);
}

}  // namespace

const std::vector<double>& array_of(const Checkpoint& checkpoint, const std::string& name, std::size_t size) {
  const auto found = checkpoint.arrays.find(name);
  if (found == checkpoint.arrays.end() || found->second.size() != size) {
    throw ComputationFailed("the checkpoint has no array \"" + name + "\" of " + std::to_string(size) +
                            " numbers: it is of another version of turgor");
  }
  return found->second;
}

std::uint64_t fingerprint(const std::string& text) {
  boost::crc_optimal<64, 0x42F0'E1EB'A9EA'3693, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> crc;
  crc.process_bytes(text.data(), text.size());
  return crc.checksum();
}

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
  Writer writer;
  for (const std::uint64_t number : {magic, format, checkpoint.case_hash, checkpoint.history_rows,
                                     checkpoint.solver_rows, static_cast<std::uint64_t>(checkpoint.step)}) {
    writer.put(number);
  }
  writer.put({checkpoint.time, checkpoint.wall_seconds}, "time");
  writer.put(checkpoint.field_times, "field times");
  writer.put(checkpoint.times, "times");
  writer.put(std::uint64_t{checkpoint.arrays.size()});
  for (const auto& [name, numbers] : checkpoint.arrays) {
    writer.put(name);
    writer.put(numbers, name);
  }
  return std::move(writer).finish();
}

Checkpoint parse_checkpoint(const std::string& bytes) {
  constexpr std::size_t checksum_size = sizeof(std::uint64_t);
  if (bytes.size() < 3 * checksum_size) throw ComputationFailed("it is cut short");
  const std::string body = bytes.substr(0, bytes.size() - checksum_size);
  Parser parser(body);
  if (parser.number() != magic) throw ComputationFailed("it is no checkpoint of turgor on this kind of machine");
  const std::uint64_t version = parser.number();
  if (version != format)
    throw ComputationFailed("its format is " + std::to_string(version) + ", not " + std::to_string(format));
  if (Parser(bytes.substr(body.size())).number() != fingerprint(body)) throw ComputationFailed("its checksum is wrong");
  Checkpoint c;
  c.case_hash = parser.number();
  c.history_rows = parser.number();
  c.solver_rows = parser.number();
  c.step = static_cast<long>(parser.number());
  const std::vector<double> clocks = parser.reals();
  if (clocks.size() != 2) throw ComputationFailed("it has " + std::to_string(clocks.size()) + " clocks");
  c.time = clocks[0];
  c.wall_seconds = clocks[1];
  c.field_times = parser.reals();
  c.times = parser.reals();
  for (std::uint64_t n = parser.number(); n > 0; --n) {
    const std::string name = parser.text();
    c.arrays[name] = parser.reals();
  }
  return c;
}

void CheckpointFiles::save(const Checkpoint& checkpoint) const {
  const std::string bytes = checkpoint_bytes(checkpoint);
  const fs::path newest = folder_ / newest_name;
  const fs::path partial = folder_ / (std::string(newest_name) + ".part");
  sync(partial, O_WRONLY | O_CREAT | O_TRUNC, bytes);
  std::error_code error;
  if (fs::exists(newest, error)) fs::rename(newest, folder_ / previous_name, error);
  if (!error) fs::rename(partial, newest, error);
  if (error) throw ComputationFailed("cannot write " + newest.string() + ": " + error.message());
  sync(folder_, O_RDONLY | O_DIRECTORY, "");
}

CheckpointFiles::Loaded CheckpointFiles::load() const {
  std::string problems;
  for (const char* name : {newest_name, previous_name}) {
    std::ifstream stream(folder_ / name, std::ios::binary);
    if (!stream) continue;
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    try {
      return {parse_checkpoint(bytes), problems.empty() ? "" : problems + "; going on from " + name};
    } catch (const ComputationFailed& error) {
      problems += (problems.empty() ? "" : "; ") + (folder_ / name).string() + " cannot be used: " + error.what();
    }
  }
  throw InvalidInput("", "", problems.empty() ? folder_.string() + " has no checkpoint to go on from" : problems,
                     "start over with --force, or choose another folder with -o DIR");
}

void CheckpointFiles::remove() const {
  std::error_code ignored;
  for (const char* name : {newest_name, previous_name}) {
    fs::remove(folder_ / name, ignored);
    fs::remove(folder_ / (std::string(name) + ".part"), ignored);
  }
}

}  // namespace turgor
