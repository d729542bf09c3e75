#pragma once
// Numbers as text, for messages and files.

#include <string>

namespace turgor {

/// The shortest decimal text that reads back as exactly this double.
[[nodiscard]] std::string shortest(double value);

/// A number for people: at most `digits` significant digits.
[[nodiscard]] std::string rounded(double value, int digits = 4);

/// Where a text differs from what it was, by its first such line: it has "...", now there is "...".
[[nodiscard]] std::string first_difference(const std::string& stored, const std::string& wanted);

}  // namespace turgor
