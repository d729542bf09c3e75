#pragma once
// Numbers on a command line.

#include <optional>
#include <string_view>
#include <vector>

namespace turgor::cli {

/// A finite number without a unit, decimal ("0.01") or a fraction ("1/100"); nothing when the text is no such number.
[[nodiscard]] std::optional<double> plain_number(std::string_view text);

/// Values of kappa = r_ch/r: "K" for one, "FROM:TO:N" for N of them in equal ratios, both ends included.
/// @param name  of the option, for messages
/// @throws InvalidInput when the text is malformed, N < 2, FROM >= TO, or a value is not between 0 and 1
[[nodiscard]] std::vector<double> kappa_values(const char* name, std::string_view text);

/// "FROM:TO", either of which may be left out.
struct NumberRange {
  std::optional<double> from;
  std::optional<double> to;
};
/// @param name  of the option, for messages
/// @throws InvalidInput when the text is malformed or FROM >= TO
[[nodiscard]] NumberRange number_range(const char* name, std::string_view text);

}  // namespace turgor::cli
