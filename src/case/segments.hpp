#pragma once
// Lists of segments, by which a case leads a quantity through time.

#include <optional>
#include <string>

#include "turgor/case/reader.hpp"
#include "turgor/pressure/program.hpp"

namespace turgor {

/// Where the keys of one list stand, and what they are about.
struct SegmentKeys {
  std::string start;     ///< "pressure.start"
  std::string list;      ///< "pressure.segments"
  std::string unit;      ///< SI unit of the quantity
  std::string quantity;  ///< "pressure"
  std::string example;   ///< a value for messages: "36 kPa"
  bool steps;            ///< whether the quantity may jump
};

void declare_segments(Schema& schema, const SegmentKeys& keys);

/// The list that stands in a case; nothing when there is none, or it cannot be read, about which an issue is kept.
/// Wrong segments are left out, each with an issue.
[[nodiscard]] std::optional<SegmentList<double>> read_segments(Reader& reader, const SegmentKeys& keys);

}  // namespace turgor
