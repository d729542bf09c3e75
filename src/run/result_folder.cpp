#include "turgor/run/result_folder.hpp"

#include <fstream>

#include "turgor/base/errors.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

InvalidInput unusable(const std::string& what, const fs::path& path, std::string problem, std::string advice) {
  return InvalidInput("", "", what + " " + path.string() + ": " + std::move(problem), std::move(advice));
}

void remove_earlier(const fs::path& folder, const ResultFolder::Contents& contents) {
  std::error_code ignored;
  for (const std::string& file : contents.files) {
    fs::remove(folder / file, ignored);
    fs::remove(folder / (file + ".part"), ignored);
  }
  for (const std::string& picture : contents.pictures) {
    for (const char* ending : {".svg", ".png", ".gp", ".log"}) fs::remove(folder / (picture + ending), ignored);
  }
  for (const std::string& film : contents.films) {
    for (const char* ending : {".gif", ".gp", ".log"}) fs::remove(folder / (film + ending), ignored);
    for (const auto& entry : fs::directory_iterator(folder / film, ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("frame-") && name.ends_with(".png")) fs::remove(entry.path(), ignored);
    }
    fs::remove(folder / film, ignored);  // unless it holds something else
  }
}

}  // namespace

ResultFolder::ResultFolder(fs::path path, Contents contents, bool force)
    : path_(std::move(path)), contents_(std::move(contents)) {
  const std::string& what = contents_.what;
  std::error_code error;
  if (fs::exists(path_, error)) {
    if (!fs::is_directory(path_, error)) throw unusable(what, path_, "is a file", "choose another name with -o DIR");
    if (!force) throw unusable(what, path_, "exists already", "choose another with -o DIR, or replace it with --force");
    remove_earlier(path_, contents_);
  } else if (!fs::create_directories(path_, error) || error) {
    throw unusable(what, path_, "cannot be created (" + error.message() + ")",
                   "choose a place you may write to with -o DIR");
  }
}

ResultFolder::ResultFolder(fs::path path, Contents contents) : path_(std::move(path)), contents_(std::move(contents)) {
  std::error_code error;
  if (!fs::is_directory(path_, error)) {
    throw unusable(contents_.what, path_, "does not exist", "give the folder of an earlier run with -o DIR");
  }
}

void ResultFolder::write(const std::string& name, const std::string& text) const {
  const fs::path partial = path_ / (name + ".part");
  {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.flush();
    if (!stream) throw ComputationFailed("cannot write " + partial.string() + ": is the disk full?");
  }
  std::error_code error;
  fs::rename(partial, path_ / name, error);
  if (error) throw ComputationFailed("cannot write " + (path_ / name).string() + ": " + error.message());
}

void ResultFolder::write_first(const std::string& name, const std::string& text) const {
  try {
    write(name, text);
  } catch (const ComputationFailed&) {
    throw unusable(contents_.what, path_, "cannot be written to", "choose a place you may write to with -o DIR");
  }
}

}  // namespace turgor
