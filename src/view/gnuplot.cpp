#include "gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace turgor {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      out += ' ';
      continue;
    }
    if (std::strchr("\"\\", c) != nullptr) out += '\\';
    if (std::strchr("_^@&~{}", c) != nullptr) out += "\\\\";  // enhanced text would read them as markup
    out += c;
  }
  return out + "\"";
}

double round_step(double wanted) {
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  if (wanted < 2 * power) return power;
  return wanted < 5 * power ? 2 * power : 5 * power;
}

namespace {

/// Runs gnuplot on a script in a folder, its messages into a file there; -1 when it cannot be started, else its exit
/// code.
int run_gnuplot(const fs::path& folder, std::string script, const std::string& messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string name = "gnuplot";
  std::array<char*, 3> arguments{name.data(), script.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// A text between single quotes.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return "'" + out + "'";
}

constexpr const char* frame_style = "set border 31 lw 0.8\nset tics nomirror\nset grid lw 0.5 lc rgb 'grey85'\n";

/// Runs gnuplot on NAME.gp; what went wrong.
std::string draw(const fs::path& folder, const std::string& name) {
  const std::string messages = name + ".log";
  const int code = run_gnuplot(folder, name + ".gp", messages);
  if (code != 0 && code != -1 && code != 127) return "no pictures: gnuplot failed, see " + (folder / messages).string();
  std::error_code ignored;
  fs::remove(folder / messages, ignored);
  if (code == 0) return {};
  return "no pictures: gnuplot was not found; install it (package gnuplot-nox) and run it on the .gp files in " +
         folder.string();
}

std::string unwritten(const fs::path& file) { return "no pictures: cannot write " + file.string(); }

}  // namespace

std::string viridis_palette() {
  std::string out;
  for (std::size_t i = 0; i < viridis.size(); ++i) {
    out += (out.empty() ? "" : ", ") + std::to_string(i) + " '" + viridis[i] + "'";
  }
  return "set palette defined (" + out + ")\n";
}

std::string gnuplot(const fs::path& folder, const std::string& name, const std::string& data, const std::string& plot,
                    PictureSize size) {
  const std::string script = name + ".gp";
  {
    std::ofstream stream(folder / script);
    stream << "# Made by turgor; draw again with: gnuplot " << script << "\n" << data;
    stream << "set terminal svg size " << size.width << "," << size.height
           << " font 'Helvetica,15' background rgb 'white' rounded enhanced\n"
           << "set output " << plain(name + ".svg") << "\n"
           << frame_style << plot << "unset output\nreset\n"
           << "set terminal pngcairo size " << 2 * size.width << "," << 2 * size.height
           << " font 'Helvetica,15' fontscale 1.9 linewidth 2 pointscale 2 rounded "
              "enhanced\n"
           << "set output " << plain(name + ".png") << "\n"
           << frame_style << plot << "unset output\n";
    if (!stream.flush()) return unwritten(folder / script);
  }
  return draw(folder, name);
}

std::string gnuplot_film(const fs::path& folder, const std::string& name, std::size_t count,
                         const std::function<FilmFrame(std::size_t)>& frame, PictureSize size, int pause) {
  const std::string script = name + ".gp";
  const std::string pixels = std::to_string(size.width) + "," + std::to_string(size.height);
  const std::string file = "sprintf(" + plain(name + "/frame-%04d.png") + ", ";
  std::error_code error;
  fs::create_directory(folder / name, error);
  if (error) return unwritten(folder / name);
  {
    std::ofstream stream(folder / script);
    stream << "# Made by turgor; draw again with: gnuplot " << script << "\n";
    for (std::size_t i = 0; i < count; ++i) {
      const FilmFrame at = frame(i);
      stream << at.data << "reset\nset terminal pngcairo size " << pixels << " font 'Helvetica,15' rounded enhanced\n"
             << "set output " << file << i + 1 << ")\n"
             << frame_style << at.plot << "unset output\n";
    }
    // of the finished frames, since gnuplot draws no smooth edges into a GIF; truecolor, that each gets its own colours
    stream << "reset\nset terminal gif animate truecolor delay " << pause << " loop 0 size " << pixels
           << "\nset output " << plain(name + ".gif")
           << "\nunset border; unset tics; unset key\nset lmargin 0; set rmargin 0; set bmargin 0; set tmargin 0\n"
           << "set autoscale xfix; set autoscale yfix\ndo for [i=1:" << count << "] {\n  plot " << file
           << "i) binary filetype=png with rgbimage\n}\nunset output\n";
    if (!stream.flush()) return unwritten(folder / script);
  }
  return draw(folder, name);
}

}  // namespace turgor
