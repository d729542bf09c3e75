#pragma once
// Tables of two columns: { file = "p.csv" } or { t = [...], p = [...] }.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/case/reader.hpp"

namespace turgor {

/// Where such a table stands, and its declared lists; its key `file` is declared too.
struct PointKeys {
  std::string table;                   ///< "pressure.table"
  std::array<std::string, 2> columns;  ///< "t", "p"
  std::string forms;                   ///< how to write it, as advice
};

using Points = std::array<std::vector<double>, 2>;

/// Reads the points in SI units and hands them to what is made of them. Complains about what is wrong with the table,
/// and about what `use` throws as InvalidInput: under its key when that is one of the lists, and else under that of the
/// file or the table.
/// @return nothing when something was wrong
std::optional<Points> read_points(Reader& reader, const Case& c, const PointKeys& keys,
                                  const std::function<void(const Points&)>& use);

}  // namespace turgor
