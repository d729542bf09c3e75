#include "turgor/base/text.hpp"

#include <array>
#include <charconv>

namespace turgor {

std::string shortest(double value) {
  std::array<char, 32> buffer{};
  const auto* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {static_cast<const char*>(buffer.data()), end};
}

std::string rounded(double value, int digits) {
  std::array<char, 64> buffer{};
  const auto* end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits).ptr;
  return {static_cast<const char*>(buffer.data()), end};
}

}  // namespace turgor
