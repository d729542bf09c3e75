#include "numbers.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include "turgor/base/errors.hpp"

namespace turgor::cli {

namespace {

constexpr int most_values = 100'000;

std::optional<double> decimal(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

double kappa_value(const char* name, std::string_view text) {
  const auto value = plain_number(text);
  if (!value) {
    throw InvalidInput(name, std::string(text), "is not a number", "write 0.01 or 1/100");
  }
  if (!(*value > 0 && *value < 1)) {
    throw InvalidInput(name, std::string(text), "out of range",
                       "r_ch/r lies between 0 and 1: the orifice is smaller than the balloon");
  }
  return *value;
}

}  // namespace

std::optional<double> plain_number(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return decimal(text);
  const auto above = decimal(text.substr(0, slash));
  const auto below = decimal(text.substr(slash + 1));
  if (!above || !below || *below == 0 || !std::isfinite(*above / *below)) return std::nullopt;
  return *above / *below;
}

std::vector<double> kappa_values(const char* name, std::string_view text) {
  const std::size_t first = text.find(':');
  if (first == std::string_view::npos) return {kappa_value(name, text)};
  const std::size_t second = text.find(':', first + 1);
  if (second == std::string_view::npos || text.find(':', second + 1) != std::string_view::npos) {
    throw InvalidInput(name, std::string(text), "is neither one number nor FROM:TO:N", "write 1/100 or 1/200:1/10:9");
  }
  const double from = kappa_value(name, text.substr(0, first));
  const double to = kappa_value(name, text.substr(first + 1, second - first - 1));
  if (!(from < to)) throw InvalidInput(name, std::string(text), "FROM must be less than TO");
  const std::string_view digits = text.substr(second + 1);
  int count = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (error != std::errc{} || end != digits.data() + digits.size() || count < 2 || count > most_values) {
    throw InvalidInput(name, std::string(text), "N = \"" + std::string(digits) + "\" is no number of points",
                       "allowed are 2 to " + std::to_string(most_values));
  }
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) values.push_back(from * std::pow(to / from, static_cast<double>(k) / (count - 1)));
  values.back() = to;
  return values;
}

NumberRange number_range(const char* name, std::string_view text) {
  const auto wrong = [&](const std::string& problem) {
    return InvalidInput(name, std::string(text), problem, "write FROM:TO; either may be left out");
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) throw wrong("is not of the form FROM:TO");
  const auto value = [&](std::string_view part) -> std::optional<double> {
    if (part.empty()) return std::nullopt;
    const auto number = plain_number(part);
    if (!number) throw wrong("\"" + std::string(part) + "\" is not a number");
    return number;
  };
  const NumberRange range{value(text.substr(0, colon)), value(text.substr(colon + 1))};
  if (range.from && range.to && !(*range.from < *range.to)) throw wrong("FROM must be less than TO");
  return range;
}

}  // namespace turgor::cli
