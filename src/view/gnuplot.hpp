#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>

namespace turgor {

/// A text as a gnuplot string that is shown as it is.
[[nodiscard]] std::string quoted(const std::string& text);

/// 1, 2 or 5 times a power of ten: the greatest up to `wanted` > 0.
[[nodiscard]] double round_step(double wanted);

struct PictureSize {
  int width = 800;
  int height = 560;
};

/// Viridis (S. van der Walt & N. Smith), even in lightness and told apart by every kind of colour vision.
inline constexpr std::array<const char*, 9> viridis{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                                    "#28ae80", "#5ec962", "#addc30", "#fde725"};
/// The command that makes it the palette.
[[nodiscard]] std::string viridis_palette();

/// Writes NAME.gp and runs gnuplot on it, which draws NAME.svg and NAME.png beside it.
/// @param data  named data blocks
/// @param plot  commands that draw them, run once for each format
/// @param size  of the SVG; the PNG has twice the pixels each way
/// @return what went wrong; empty when both pictures are there
[[nodiscard]] std::string gnuplot(const std::filesystem::path& folder, const std::string& name, const std::string& data,
                                  const std::string& plot, PictureSize size = {});

/// A picture of a film: data blocks, which may have the names of those before, and the commands that draw them.
struct FilmFrame {
  std::string data;
  std::string plot;
};

/// Writes NAME.gp and runs gnuplot on it, which draws NAME/frame-0001.png and so on, and joins them to NAME.gif.
/// @param frame  called with 0 to count - 1
/// @param size   in pixels
/// @param pause  between frames [1/100 s]
/// @return what went wrong; empty when the film is there
[[nodiscard]] std::string gnuplot_film(const std::filesystem::path& folder, const std::string& name, std::size_t count,
                                       const std::function<FilmFrame(std::size_t)>& frame, PictureSize size, int pause);

}  // namespace turgor
