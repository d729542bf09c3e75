#include "turgor/run/report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/case/units.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json ratios(const std::vector<DroppedTerm>& terms) {
  Json out = Json::object();
  for (const DroppedTerm& term : terms) out[term.name] = std::isfinite(term.ratio) ? Json(term.ratio) : Json(nullptr);
  return out;
}

Json model_json(const Case& c, const ModelChoice& choice) {
  Json dropped = Json::object();
  for (const auto& [model, terms] : choice.dropped) dropped[std::string(name_of(model))] = ratios(terms);
  return {{"name", name_of(choice.model)},
          {"chosen_automatically", choice.automatic},
          {"closure", name_of(c.parameters.closure)},
          {"material", c.material_name},
          {"tolerance", c.auto_tolerance},
          {"stretch_range", {choice.least_stretch, choice.greatest_stretch}},
          {"dropped_term_ratios", dropped}};
}

Json statistics_json(Method method, const IntegratorStatistics& s) {
  return {{"method", method == Method::quadrature ? "quadrature" : "DOP853 and Rodas5P"},
          {"steps", s.steps},
          {"rejected", s.rejected},
          {"rate_evaluations", s.rate_evaluations},
          {"linearizations", s.linearizations},
          {"factorizations", s.factorizations},
          {"event_refinements", s.event_refinements}};
}

int number_of(Regime regime) { return static_cast<int>(regime); }

}  // namespace

void append_number(std::string& out, double value, double factor) { out += shortest(value / factor + 0.0); }

std::string summary_line(const std::string& name, const std::string& text) {
  return "  " + name + std::string(name.size() < 18 ? 18 - name.size() : 1, ' ') + text + "\n";
}

std::string run_json(const Case& c, const RunResult& result) {
  const Trajectory<double>& trajectory = *result.trajectory;
  const Oscillator<double>& oscillator = *result.oscillator;
  const Scales<double>& scales = c.scales;
  const PhysicalState last = physical_state(oscillator, trajectory, trajectory.last.time);

  Json quantities = Json::object();
  Json units = Json::object();
  for (const Quantity& quantity : result.quantities) {
    quantities[quantity.name] = number_or_null(quantity.value);
    units[quantity.name] = quantity.unit;
  }
  Json warnings = Json::array();
  for (const Warning& warning : result.warnings) warnings.push_back({{"name", warning.name}, {"text", warning.text}});
  Json expectations = Json::array();
  for (const ExpectationResult& e : result.expectations) {
    expectations.push_back({{"quantity", e.expected.quantity},
                            {"value", e.expected.value},
                            {"tolerance", e.expected.tolerance},
                            {"found", number_or_null(e.found)},
                            {"met", e.met}});
  }
  const Json document{
      {"title", c.title},
      {"status", result.status()},
      {"outcome", name_of(trajectory.outcome)},
      {"message", trajectory.message},
      {"versions", {{"turgor", version}, {"compiler", compiler}}},
      {"timings", {{"integration_s", result.integration_seconds}}},
      {"model", model_json(c, result.choice)},
      {"tolerances", {{"rtol", c.solve.rtol}, {"atol", c.solve.atol}}},
      {"integrator", statistics_json(c.solve.method, trajectory.statistics)},
      {"quantities", quantities},
      {"units", units},
      {"final_state",
       {{"t_s", last.time},
        {"R", last.stretch},
        {"dRdt_1_per_s", last.stretch_rate},
        {"p_gauge_Pa", last.gauge_pressure}}},
      {"dimensionless",
       {{"p_typ_Pa", scales.pressure},
        {"t_typ_s", scales.time},
        {"r0_m", scales.length},
        {"T_end", last.time / scales.time},
        {"energy_unit_J", scales.energy()}}},
      {"warnings", warnings},
      {"expectations", expectations},
  };
  return document.dump(2) + "\n";
}

std::vector<double> requested_times(const SolveSettings& solve) {
  std::vector<double> times = solve.times;
  for (long i = 0; i < solve.samples; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(solve.samples - 1);
    times.push_back(i + 1 == solve.samples ? solve.t_end : solve.t_end * share);
  }
  return times;
}

std::vector<RowTime> row_times(const Case& c, const RunResult& result) {
  const double clock = result.oscillator->scales().time;
  const Trajectory<double>& trajectory = *result.trajectory;
  const bool continues = trajectory.outcome == Outcome::reached_end || trajectory.outcome == Outcome::at_rest;
  std::vector<RowTime> rows;
  for (const double t : requested_times(c.solve)) {
    if (continues || t / clock < trajectory.last.time) rows.push_back({t / clock, t});
  }
  if (!continues) rows.push_back({trajectory.last.time, trajectory.last.time * clock});
  return rows;
}

std::vector<TrajectoryRow> trajectory_rows(const Case& c, const RunResult& result) {
  std::vector<TrajectoryRow> rows;
  for (const RowTime& time : row_times(c, result)) {
    TrajectoryRow& row = rows.emplace_back();
    row.state = physical_state(*result.oscillator, *result.trajectory, time.scaled);
    row.state.time = time.seconds;
    row.state.gauge_pressure = c.pressure(time.seconds);
    row.energies = result.energies->at(std::min(time.scaled, result.trajectory->last.time));
  }
  return rows;
}

std::string trajectory_csv(const Case& c, const RunResult& result) {
  const OutputSettings& o = c.output;
  const double s = unit_factor(o.time_unit, "s");
  const double m = unit_factor(o.length_unit, "m");
  const double pa = unit_factor(o.pressure_unit, "Pa");
  const double m3 = unit_factor(o.volume_unit, "m^3");
  const double m3_s = unit_factor(o.flow_unit, "m^3/s");
  const double joule = unit_factor(o.energy_unit, "J");
  std::string out = "t [" + o.time_unit + "],R [1],dRdt [1/" + o.time_unit + "],r [" + o.length_unit + "],p_gauge [" +
                    o.pressure_unit + "],regime,volume [" + o.volume_unit + "],flow_rate [" + o.flow_unit +
                    "],kinetic [" + o.energy_unit + "],elastic [" + o.energy_unit + "],inlet_work [" + o.energy_unit +
                    "],dissipated [" + o.energy_unit + "]\n";
  const std::vector<TrajectoryRow> rows = trajectory_rows(c, result);
  out.reserve(out.size() + rows.size() * 200);
  for (const auto& [state, energies] : rows) {
    append_number(out, state.time, s);
    const auto column = [&](double value, double factor) {
      out += ',';
      append_number(out, value, factor);
    };
    column(state.stretch, 1);
    column(state.stretch_rate, 1 / s);
    column(state.radius, m);
    column(state.gauge_pressure, pa);
    out += ',' + std::to_string(number_of(state.regime));
    column(state.volume, m3);
    column(state.flow_rate, m3_s);
    column(energies.kinetic, joule);
    column(energies.elastic, joule);
    column(energies.inlet_work, joule);
    column(energies.dissipated, joule);
    out += '\n';
  }
  return out;
}

std::string dimensionless_csv(const Case& c, const RunResult& result) {
  const double rate_unit = result.oscillator->scales().time / c.scales.time;
  std::string out = "T,R,dRdT,P,regime\n";
  for (const RowTime& row : row_times(c, result)) {
    const Point<double> point = result.trajectory->at(row.scaled);
    append_number(out, row.seconds, c.scales.time);
    for (const double value : {point.stretch, point.rate / rate_unit, c.pressure(row.seconds) / c.scales.pressure}) {
      out += ',';
      append_number(out, value);
    }
    out += ',' + std::to_string(number_of(point.regime)) + '\n';
  }
  return out;
}

std::string events_csv(const Case& c, const RunResult& result) {
  const double clock = result.oscillator->scales().time;
  const double s = unit_factor(c.output.time_unit, "s");
  std::string out = "index,t [" + c.output.time_unit + "],R [1],old_regime,new_regime\n";
  long index = 0;
  for (const auto& event : result.trajectory->events) {
    out += std::to_string(index++) + ',';
    append_number(out, event.time * clock, s);
    out += ',';
    append_number(out, event.stretch);
    out += ',' + std::to_string(number_of(event.before)) + ',' + std::to_string(number_of(event.after)) + '\n';
  }
  return out;
}

std::string summary(const Case& c, const RunResult& result, bool verbose) {
  const Trajectory<double>& trajectory = *result.trajectory;
  std::string out = c.title + "\n";
  const auto line = [&](const std::string& name, const std::string& text) { out += summary_line(name, text); };
  line("status", result.status() + " (" + std::string(name_of(trajectory.outcome)) + ")" +
                     (trajectory.message.empty() ? "" : ": " + trajectory.message));
  line("model", std::string(name_of(result.choice.model)) + (result.choice.automatic ? " (chosen automatically)" : "") +
                    ", " + std::string(name_of(c.parameters.closure)) + " closure, " + c.material_name);
  for (const Quantity& q : result.quantities) {
    if (q.value) line(q.name, rounded(*q.value, 9) + (q.unit == "1" ? "" : " " + q.unit));
  }
  if (verbose || result.choice.automatic) {
    for (const auto& [model, terms] : result.choice.dropped) {
      for (const DroppedTerm& term : terms) {
        out += "  " + std::string(name_of(model)) + " drops " + term.name + ": " + rounded(100 * term.ratio, 3) +
               " % over R = " + rounded(result.choice.least_stretch, 5) + " ... " +
               rounded(result.choice.greatest_stretch, 5) + "\n";
      }
    }
  }
  if (verbose) {
    const IntegratorStatistics& s = trajectory.statistics;
    line("integrator", std::to_string(s.steps) + " steps, " + std::to_string(s.rejected) + " rejected, " +
                           std::to_string(s.rate_evaluations) + " rate evaluations, " +
                           rounded(1e3 * result.integration_seconds, 3) + " ms");
  }
  for (const Warning& warning : result.warnings) out += "  warning: " + warning.text + "\n";
  for (const ExpectationResult& e : result.expectations) {
    line(std::string(e.met ? "as expected" : "NOT AS EXPECTED"),
         e.expected.quantity + " = " + (e.found ? rounded(*e.found, 9) : "none") + ", expected " +
             rounded(e.expected.value, 9) + " +- " + rounded(e.expected.tolerance, 3));
  }
  return out;
}

}  // namespace turgor
