#include "turgor/case/units.hpp"

#include <udunits2.h>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>

#include "turgor/base/errors.hpp"

namespace turgor {

namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// The unit database; reading it takes about 10 ms, so it happens at the first unit met.
ut_system* database() {
  static const std::unique_ptr<ut_system, void (*)(ut_system*)> system = [] {
    ut_set_error_message_handler(ut_ignore);
    return std::unique_ptr<ut_system, void (*)(ut_system*)>(ut_read_xml(nullptr), ut_free_system);
  }();
  if (!system) throw ComputationFailed("the unit database of UDUNITS-2 cannot be read (package libudunits2-data)");
  return system.get();
}

InvalidInput wrong(std::string problem, std::string advice = {}) {
  return InvalidInput("", "", std::move(problem), std::move(advice));
}

Unit parse_unit(const std::string& text, const std::string& advice) {
  Unit unit(ut_parse(database(), text.c_str(), UT_UTF8));
  if (!unit) throw wrong("unknown unit \"" + text + "\"", advice);
  return unit;
}

/// An everyday unit of the same dimension, for messages.
std::string example_of(const std::string& unit) {
  if (unit == "m") return "\"3 cm\"";
  if (unit == "s") return "\"2 s\"";
  if (unit == "Pa") return "\"36 kPa\"";
  if (unit == "kg/m^3") return "\"1000 kg/m^3\"";
  if (unit == "Pa s") return "\"1 mPa s\"";
  if (unit == "1/s") return "\"0.5 1/s\"";
  if (unit == "Hz") return "\"2 Hz\"";
  if (unit == "rad") return "\"90 degrees\"";
  return "a number and a unit such as " + unit;
}

bool has_radians(const ut_unit* unit) {
  std::array<char, 256> text{};
  const int length = ut_format(unit, text.data(), text.size(), UT_ASCII | UT_DEFINITION);
  return length > 0 &&
         std::string_view(text.data(), static_cast<std::size_t>(length)).find("rad") != std::string_view::npos;
}

double factor(const std::string& from, const std::string& to) {
  static std::mutex one_at_a_time;  // UDUNITS-2 keeps its parser's state in globals
  const std::scoped_lock lock(one_at_a_time);
  const Unit a = parse_unit(from, "write for example " + example_of(to));
  const Unit b = parse_unit(to, {});
  // ut_are_convertible also says yes to reciprocals (s and Hz), and radians count as dimensionless (rpm and Hz), so the
  // quotient and its spelling decide.
  const Unit quotient(ut_divide(a.get(), b.get()));
  if (!quotient || ut_is_dimensionless(quotient.get()) == 0 || has_radians(quotient.get())) {
    throw wrong("\"" + from + "\" has the wrong dimension", "write " + example_of(to));
  }
  const std::unique_ptr<cv_converter, void (*)(cv_converter*)> converter(ut_get_converter(a.get(), b.get()), cv_free);
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0) {
    throw wrong("\"" + from + "\" is not a multiple of " + to, "write " + example_of(to));
  }
  return cv_convert_double(converter.get(), 1.0);
}

}  // namespace

double unit_factor(const std::string& from, const std::string& to) { return factor(from, to); }

double parse_quantity(std::string_view text, const std::string& unit) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  std::string_view digits = text;
  if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') digits.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::invalid_argument) throw wrong("does not start with a number", "write " + example_of(unit));
  if (error == std::errc::result_out_of_range || !std::isfinite(number)) throw wrong("not a finite number");
  std::string_view rest(end, static_cast<std::size_t>(digits.data() + digits.size() - end));
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  if (rest.empty()) throw wrong("missing unit", "write " + example_of(unit));
  const std::string given(rest);
  const double value = given == unit ? number : number * factor(given, unit);
  if (!std::isfinite(value)) throw wrong("not a finite number in " + unit);
  return value;
}

double parse_argument(const std::string& name, std::string_view text, const std::string& unit) {
  try {
    return parse_quantity(text, unit);
  } catch (const InvalidInput& error) {
    const Issue& issue = error.issues().front();
    throw InvalidInput(name, "\"" + std::string(text) + "\"", issue.problem, issue.advice);
  }
}

}  // namespace turgor
