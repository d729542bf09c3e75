#pragma once
// Unit strings, which exist only where a case file is read and where results are written.

#include <string>
#include <string_view>

namespace turgor {

/// Reads "30 cm" as a number in the given SI unit.
/// @param text  a number and a unit of UDUNITS-2 ("1.5 MPa", "120 mmHg", "1e-3 Pa s", "0.5 1/s")
/// @param unit  SI unit of the result; the unit in `text` must have its dimension
/// @throws InvalidInput (without a key) saying what is wrong: no number, no unit, unknown unit, wrong dimension, not
/// finite
[[nodiscard]] double parse_quantity(std::string_view text, const std::string& unit);

/// The same for an argument that is no key of a case: an option of a command, a parameter of a function.
/// @throws InvalidInput with the argument's name as its key
[[nodiscard]] double parse_argument(const std::string& name, std::string_view text, const std::string& unit);

/// Factor f such that x [from] = f x [to]; both units of the same dimension, without offset.
/// @throws InvalidInput (without a key) when a unit is unknown or the dimensions differ
[[nodiscard]] double unit_factor(const std::string& from, const std::string& to);

}  // namespace turgor
