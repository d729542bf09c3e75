#pragma once
// Runs the real program, as a user does.

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace turgor::test {

/// A folder of its own for one test, removed with it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "turgor-test-").string() + std::string(6, 'X');
    path_ = mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

[[nodiscard]] inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// Path of a shipped case, such as "orifice-30mm", or of another shipped file by its whole name.
[[nodiscard]] inline std::string shipped(const std::string& name) {
  std::filesystem::path file = std::filesystem::path(TURGOR_CASES) / name;
  if (!file.has_extension()) file += ".toml";
  return file.string();
}

struct Finished {
  int code;
  std::string out;
  std::string err;
};

/// Runs a shell command with its output caught.
[[nodiscard]] inline Finished shell(const Folder& folder, const std::string& command) {
  const std::string out = (folder / "stdout").string();
  const std::string err = (folder / "stderr").string();
  const int status = std::system(
      ("cd '" + folder.path().string() + "' && " + command + " >'" + out + "' 2>'" + err + "' </dev/null").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
}

/// Runs turgor with arguments that need no shell.
[[nodiscard]] inline Finished turgor(const Folder& folder, const std::vector<std::string>& arguments) {
  std::string command = std::string("'") + TURGOR_PROGRAM + "'";
  for (const auto& argument : arguments) {
    std::string safe;
    for (const char c : argument) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    command += " '" + safe + "'";
  }
  return shell(folder, command);
}

}  // namespace turgor::test
