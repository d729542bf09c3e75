#pragma once

#include <filesystem>
#include <string>

namespace turgor {

/// A text as a gnuplot string that is shown as it is.
[[nodiscard]] std::string quoted(const std::string& text);

/// 1, 2 or 5 times a power of ten: the greatest up to `wanted` > 0.
[[nodiscard]] double round_step(double wanted);

/// Writes NAME.gp and runs gnuplot on it, which draws NAME.svg and NAME.png beside it.
/// @param data  named data blocks
/// @param plot  commands that draw them, run once for each format
/// @return what went wrong; empty when both pictures are there
[[nodiscard]] std::string gnuplot(const std::filesystem::path& folder, const std::string& name, const std::string& data,
                                  const std::string& plot);

}  // namespace turgor
