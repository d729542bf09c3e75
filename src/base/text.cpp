#include "turgor/base/text.hpp"

#include <array>
#include <charconv>
#include <sstream>

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

std::string first_difference(const std::string& stored, const std::string& wanted) {
  std::istringstream a(stored);
  std::istringstream b(wanted);
  std::string before;
  std::string now;
  while (true) {
    const bool more_before = static_cast<bool>(std::getline(a, before));
    const bool more_now = static_cast<bool>(std::getline(b, now));
    if (!more_before) before.clear();
    if (!more_now) now.clear();
    if (before != now || (!more_before && !more_now)) break;
  }
  const auto shown = [](const std::string& line) {
    if (line.empty()) return std::string("nothing");
    return "\"" + (line.size() > 80 ? line.substr(0, 77) + "..." : line) + "\"";
  };
  return "it has " + shown(before) + ", now there is " + shown(now);
}

}  // namespace turgor
