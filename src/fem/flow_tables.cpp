#include "turgor/fem/flow_tables.hpp"

#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/report.hpp"

namespace turgor {

namespace {

std::vector<TableColumn<SolverRow>> solver_columns(const OutputSettings& o) {
  const double s = unit_factor(o.time_unit, "s");
  return {{"t", o.time_unit, s, &SolverRow::time},
          {"dt", o.time_unit, s, &SolverRow::dt},
          {"cfl", "1", 1, &SolverRow::cfl},
          {"residual", "1", 1, &SolverRow::residual},
          {"min_jacobian", "1", 1, &SolverRow::min_jacobian},
          {"volume_error", "1", 1, &SolverRow::volume_error},
          {"wall", "s", 1, &SolverRow::wall_seconds}};
}

template <class Row>
std::string header_of(const std::vector<TableColumn<Row>>& columns) {
  std::string out;
  for (const auto& column : columns) out += (out.empty() ? "" : ",") + column.name + " [" + column.unit + "]";
  return out;
}

template <class Row>
std::string line_of(const std::vector<TableColumn<Row>>& columns, const Row& row) {
  std::string out;
  for (const auto& column : columns) {
    const double value = row.*column.value;
    if (!std::isfinite(value)) {
      throw ComputationFailed("at t = " + shortest(row.time) + " s: " + column.name + " is not a finite number");
    }
    if (!out.empty()) out += ',';
    append_number(out, value, column.factor);
  }
  return out;
}

}  // namespace

HistoryKind history_kind(const Case& c) { return c.motion ? HistoryKind::dictated : HistoryKind::coupled; }

std::vector<TableColumn<FlowRow>> history_columns(const OutputSettings& o, HistoryKind kind) {
  const double s = unit_factor(o.time_unit, "s");
  const double m = unit_factor(o.length_unit, "m");
  const double j = unit_factor(o.energy_unit, "J");
  const std::string speed = o.length_unit + "/" + o.time_unit;
  const std::string power = o.energy_unit + "/" + o.time_unit;
  const bool coupled = kind == HistoryKind::coupled;
  std::vector<TableColumn<FlowRow>> all{
      {"t", o.time_unit, s, &FlowRow::time},
      {"p_gauge", o.pressure_unit, unit_factor(o.pressure_unit, "Pa"), &FlowRow::gauge_pressure},
      {coupled ? "r_eff" : "r", o.length_unit, m, &FlowRow::radius},
      {coupled ? "dr_effdt" : "drdt", speed, m / s, &FlowRow::rate}};
  const auto add = [&](bool wanted, TableColumn<FlowRow> column) {
    if (wanted) all.push_back(std::move(column));
  };
  add(!coupled, {"d2rdt2", speed + "^2", m / s / s, &FlowRow::acceleration});
  add(coupled, {"z_top", o.length_unit, m, &FlowRow::top});
  add(coupled, {"r_max", o.length_unit, m, &FlowRow::greatest_radius});
  add(true, {"force", "N", 1, &FlowRow::force});
  add(!coupled, {"force_mode", "N", 1, &FlowRow::force_mode});
  add(true, {"flow_rate", o.flow_unit, unit_factor(o.flow_unit, "m^3/s"), &FlowRow::flow_rate});
  add(true, {"volume", o.volume_unit, unit_factor(o.volume_unit, "m^3"), &FlowRow::volume});
  add(true, {"area", o.length_unit + "^2", m * m, &FlowRow::area});
  add(true, {"kinetic", o.energy_unit, j, &FlowRow::kinetic});
  add(coupled, {"wall_kinetic", o.energy_unit, j, &FlowRow::wall_kinetic});
  add(coupled, {"elastic", o.energy_unit, j, &FlowRow::elastic});
  add(true, {"viscous_power", power, j / s, &FlowRow::viscous_power});
  add(true, {"stabilisation_power", power, j / s, &FlowRow::stabilisation_power});
  add(coupled, {"damping_power", power, j / s, &FlowRow::damping_power});
  add(true, {"inlet_power", power, j / s, &FlowRow::inlet_power});
  add(true, {"wall_power", power, j / s, &FlowRow::wall_power});
  add(true, {"viscous_work", o.energy_unit, j, &FlowRow::viscous_work});
  add(true, {"stabilisation_work", o.energy_unit, j, &FlowRow::stabilisation_work});
  add(coupled, {"damping_work", o.energy_unit, j, &FlowRow::damping_work});
  add(true, {"inlet_work", o.energy_unit, j, &FlowRow::inlet_work});
  add(true, {"wall_work", o.energy_unit, j, &FlowRow::wall_work});
  return all;
}

std::string history_header(const OutputSettings& output, HistoryKind kind) {
  return header_of(history_columns(output, kind));
}

std::string history_line(const OutputSettings& output, HistoryKind kind, const FlowRow& row) {
  return line_of(history_columns(output, kind), row);
}

std::string solver_header(const OutputSettings& output) {
  return "step,nonlinear_iterations,linear_iterations,factorisations," + header_of(solver_columns(output));
}

std::string solver_line(const OutputSettings& output, const SolverRow& row) {
  std::string out;
  for (const long count : {row.step, row.nonlinear_iterations, row.linear_iterations, row.factorisations}) {
    out += std::to_string(count) + ",";
  }
  return out + line_of(solver_columns(output), row);
}

}  // namespace turgor
