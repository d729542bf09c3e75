#pragma once
// A range of one key of a case, as a command line gives it.

#include <string>
#include <string_view>

#include "turgor/case/case.hpp"

namespace turgor {

struct KeyRange {
  std::string key;   ///< "material.s1"
  std::string unit;  ///< SI unit, "1" for a pure number
  double from;
  double to;  ///< > from
};

/// Reads "material.s1=1 MPa:2 MPa".
/// @param c       the key must be one of its balloon, inlet, pressure or motion, and take a quantity or a number
/// @param option  name of the option, for messages
/// @throws InvalidInput
[[nodiscard]] KeyRange read_key_range(const Case& c, const std::string& option, std::string_view text);

/// A value for CaseTemplate::with() in the form that the range's key takes.
[[nodiscard]] Node node_of(const KeyRange& range, double value);

}  // namespace turgor
