#pragma once
// history.csv and solver.csv: headers and rows, units of [output], forces in N.

#include <string>
#include <vector>

#include "turgor/fem/flow_problem.hpp"

namespace turgor {

/// A column of a table of Rows.
template <class Row>
struct TableColumn {
  std::string name;
  std::string unit;
  double factor;  ///< how many SI units the unit is
  double Row::* value;
};

/// The columns of history.csv.
[[nodiscard]] std::vector<TableColumn<FlowRow>> history_columns(const OutputSettings& output);
[[nodiscard]] std::string history_header(const OutputSettings& output);
/// @throws ComputationFailed, naming the column, when a number is not finite
[[nodiscard]] std::string history_line(const OutputSettings& output, const FlowRow& row);

[[nodiscard]] std::string solver_header(const OutputSettings& output);
/// @throws ComputationFailed, naming the column, when a number is not finite
[[nodiscard]] std::string solver_line(const OutputSettings& output, const SolverRow& row);

}  // namespace turgor
