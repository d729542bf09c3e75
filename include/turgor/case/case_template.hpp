#pragma once
// Many cases that differ in a few values, made far faster than by reading a file for each.

#include <span>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"

namespace turgor {

/// A case with blanks. Filling them gives the case that `--set key=value` would give, to the last bit: the same reader
/// reads the same tree, but units are converted once, only parts that can differ are read again, and no resolved text
/// is written.
class CaseTemplate {
 public:
  /// @param base  a case as read; what stands at the keys is replaced
  /// @param keys  "inlet.orifice_radius", "pressure.segments[0].to"
  /// @throws InvalidInput when a key leads through something that is not a table or list
  CaseTemplate(const Case& base, const std::vector<std::string>& keys);

  /// @param values  one for each key: a number, a quantity in the key's SI unit, or a word
  /// @return the case without expectations, sweep, source, resolved text and tree
  /// @throws InvalidInput when these values do not go together
  [[nodiscard]] Case with(std::span<const Node> values);

 private:
  Node tree_;
  std::vector<std::string> keys_;
  std::vector<void (*)(class Reader&, Case&)> readers_;  ///< of the parts that can differ
  Case base_;
};

}  // namespace turgor
