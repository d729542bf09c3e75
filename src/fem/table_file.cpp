#include "table_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "turgor/base/errors.hpp"

namespace turgor {

namespace {

std::string reason() { return std::strerror(errno); }  // NOLINT: one thread

ComputationFailed unwritable(const std::filesystem::path& file) {
  return ComputationFailed("cannot write " + file.string() + " (" + reason() + "): is the disk full?");
}

}  // namespace

TableFile::TableFile(std::filesystem::path file, const std::string& header, bool existing, std::uint64_t rows)
    : path_(std::move(file)),
      file_(open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | (existing ? 0 : O_CREAT), 0666)),  // NOLINT: POSIX
      rows_(existing ? rows : 0) {
  if (file_ < 0) throw InvalidInput("", "", "cannot open " + path_.string() + " (" + reason() + ")");
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      throw InvalidInput("", "", path_.string() + ": another run is writing to it",
                         "wait for that, or choose another folder with -o DIR");
    }
    if (ftruncate(file_, existing ? static_cast<off_t>(size_of(rows, header)) : 0) != 0) throw unwritable(path_);
    if (!existing) write(header + "\n");
  } catch (...) {
    close(file_);
    throw;
  }
}

TableFile::~TableFile() { close(file_); }

std::uintmax_t TableFile::size_of(std::uint64_t rows, const std::string& header) const {
  std::ifstream stream(path_, std::ios::binary);
  std::string line;
  std::uintmax_t size = 0;
  for (std::uint64_t i = 0; i <= rows; ++i) {
    if (!std::getline(stream, line) || stream.eof() || (i == 0 && line != header)) {
      throw InvalidInput("", "", path_.string() + " is not the table that the checkpoint belongs to",
                         "start over with --force");
    }
    size += line.size() + 1;
  }
  return size;
}

void TableFile::append(const std::string& row) {
  write(row + "\n");
  ++rows_;
}

void TableFile::write(const std::string& text) const {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = ::write(file_, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) throw unwritable(path_);
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

void TableFile::sync() const {
  if (fdatasync(file_) != 0) throw unwritable(path_);
}

}  // namespace turgor
