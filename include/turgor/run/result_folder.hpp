#pragma once
// A folder that a command leaves behind.

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {

/// A folder of results that never holds a mixture of two of them, nor half a file.
class ResultFolder {
 public:
  /// What a command writes: files by their names, and pictures and films by theirs without ending.
  struct Contents {
    std::string what;  ///< for messages: "run directory"
    std::vector<std::string> files;
    std::vector<std::string> pictures;
    std::vector<std::string> films{};  ///< NAME.gif and the folder NAME with its frames
  };

  /// Creates the folder, and the folders above it.
  /// @param force  replace earlier results in an existing folder; only `contents` are touched
  /// @throws InvalidInput when the folder exists (without force), is not a folder, or cannot be created
  ResultFolder(std::filesystem::path path, Contents contents, bool force);

  /// Opens the folder of earlier results to add to them.
  /// @throws InvalidInput when there is none
  ResultFolder(std::filesystem::path path, Contents contents);

  /// Writes beside and renames, so that a file is either the old one or the whole new one.
  /// @throws ComputationFailed when a file cannot be written
  void write(const std::string& name, const std::string& text) const;

  /// The same for the first file of all, where a failure means that the folder was badly chosen.
  /// @throws InvalidInput when it cannot be written
  void write_first(const std::string& name, const std::string& text) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Contents contents_;
};

}  // namespace turgor
