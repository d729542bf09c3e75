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

/// Whose radius: dictated by the case, or that of an elastic wall.
enum class HistoryKind { dictated, coupled };
[[nodiscard]] HistoryKind history_kind(const Case& c);

/// The columns of history.csv.
[[nodiscard]] std::vector<TableColumn<FlowRow>> history_columns(const OutputSettings& output, HistoryKind kind);
[[nodiscard]] std::string history_header(const OutputSettings& output, HistoryKind kind);
/// @throws ComputationFailed naming the column, when a number is not finite
[[nodiscard]] std::string history_line(const OutputSettings& output, HistoryKind kind, const FlowRow& row);

[[nodiscard]] std::string solver_header(const OutputSettings& output);
/// @throws ComputationFailed naming the column, when a number is not finite
[[nodiscard]] std::string solver_line(const OutputSettings& output, const SolverRow& row);

}  // namespace turgor
