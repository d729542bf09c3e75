#include "turgor/run/asymptotics.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "turgor/asymptotics/equilibria.hpp"
#include "turgor/asymptotics/oscillation.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

double final_pressure(const Case& c) {
  const auto& last = c.pressure.pieces().back();
  if (!last.pressure.is_constant()) {
    throw InvalidInput("pressure", "", "it never becomes constant",
                       "free motion needs a pressure that stays the same from some time on");
  }
  return last.pressure(last.start);
}

template <class Function>
Attempt attempt(const Function& f) {
  try {
    return {f(), {}};
  } catch (const InvalidInput& refusal) {
    return {{}, refusal.what()};
  }
}

std::vector<ClosedEquilibrium> closed_equilibria(const Parameters<double>& p, double pressure,
                                                 const std::vector<Equilibrium>& exact) {
  std::vector<ClosedEquilibrium> all{{"(3.3)", attempt([&] { return small_equilibrium(p, pressure).stretch; }), {}},
                                     {"(3.5)", attempt([&] { return large_equilibrium(p, pressure); }), {}}};
  for (ClosedEquilibrium& closed : all) {
    if (!closed.stretch.estimate) continue;
    const double R = closed.stretch.estimate->value;
    for (const Equilibrium& state : exact) {
      if (state.stable && (!closed.exact || std::abs(state.stretch - R) < std::abs(*closed.exact - R))) {
        closed.exact = state.stretch;
      }
    }
  }
  return all;
}

Estimate in_seconds(const Estimate& T, const FreeMotion& motion) {
  return {T.value * motion.scales().time, T.error * motion.scales().time};
}

/// The motion on deflation's own clock.
FreeMotion motion_about(const Case& c, Model model, double pressure, double equilibrium) {
  Scales<double> scales{c.parameters.radius, c.scales.pressure, 1.0};
  const auto on = [&] {
    return FreeMotion(Oscillator<double>(model, c.parameters, c.pressure, scales), pressure / scales.pressure,
                      equilibrium);
  };
  scales.time = on().time_scales().deflation;
  return on();
}

double default_start(const FreeMotion& motion) {
  return std::min(1.05 * motion.equilibrium(), (motion.equilibrium() + motion.greatest()) / 2);
}

MotionForecast forecast(const FreeMotion& motion, double start) {
  const Decay decay(motion);
  const Estimate undershoot = decay.corrected_undershoot(start - motion.equilibrium());
  MotionForecast f{motion,
                   start,
                   {},
                   alpha2(motion),
                   attempt([&] { return in_seconds(MatchedDeflation(motion, start).transition_time(), motion); }),
                   attempt([&] { return in_seconds(SlowDeflation(motion, start).transition_time(), motion); }),
                   attempt([&] { return SlowDeflation(motion, start).turning_point(); }),
                   in_seconds(Oscillation(motion, Regime::inflating).half_period(-undershoot.value), motion),
                   undershoot,
                   decay.greatest_undershoot(),
                   decay.cycle_time() * motion.scales().time,
                   {1, 10, 100, 1000},
                   {}};
  if (motion.deflation()) f.constants = gammas(motion, start);
  for (const long n : f.cycles) f.amplitudes.push_back(decay.amplitude(start - motion.equilibrium(), n));
  return f;
}

}  // namespace

AsymptoticsReport asymptotics_report(const Case& c, std::optional<double> start) {
  AsymptoticsReport report{};
  report.pressure = final_pressure(c);
  report.model = c.model.value_or(c.parameters.channel_length > 0 ? Model::long_channel : Model::orifice);
  report.equilibria = equilibria(c.parameters, report.pressure);
  report.closed = closed_equilibria(c.parameters, report.pressure, report.equilibria);
  bool used = false;
  for (const Equilibrium& state : report.equilibria) {
    if (!state.stable) continue;
    const FreeMotion motion = motion_about(c, report.model, report.pressure, state.stretch);
    const bool here = start && *start > motion.equilibrium() && *start < motion.greatest();
    used = used || here;
    report.motions.push_back(forecast(motion, here ? *start : default_start(motion)));
  }
  if (report.motions.empty()) {
    throw InvalidInput("pressure", rounded(report.pressure, 8) + " Pa", "no stable equilibrium at the final pressure",
                       "a lower pressure may have one; see the limit points in turgor info");
  }
  if (start && !used) {
    throw InvalidInput("--from", shortest(*start), "is not above a stable equilibrium, in its well",
                       "the first is at R = " + shortest(report.motions.front().motion.equilibrium()));
  }
  return report;
}

namespace {

Json estimate_json(const Estimate& e) { return {{"value", e.value}, {"estimated_error", e.error}}; }

Json attempt_json(const Attempt& a) { return a.estimate ? estimate_json(*a.estimate) : Json{{"refused", a.refusal}}; }

Json motion_json(const MotionForecast& f) {
  const TimeScales times = f.motion.time_scales();
  Json constants = nullptr;
  if (f.constants) {
    const auto [C1, C2] = f.motion.require_deflation();
    constants = {{"C1", C1},
                 {"C2", C2},
                 {"delta", 1 / C2},
                 {"gamma1", f.constants->first},
                 {"gamma2", f.constants->second},
                 {"gamma3", f.constants->third}};
  }
  Json decay = Json::array();
  for (std::size_t i = 0; i < f.cycles.size(); ++i) {
    decay.push_back({{"cycles", f.cycles[i]}, {"amplitude", estimate_json(f.amplitudes[i])}});
  }
  return {{"R_eq", f.motion.equilibrium()},
          {"time_scales",
           {{"deflation_s", times.deflation},
            {"inflation_s", times.inflation},
            {"C1_on_deflation_clock", times.C1},
            {"C3_on_inflation_clock", times.C3}}},
          {"beta", f.motion.beta()},
          {"alpha2", f.alpha2},
          {"R_i", f.start},
          {"deflation_constants", constants},
          {"T_deflation_3_17_s", attempt_json(f.deflation_paper)},
          {"T_deflation_uniform_s", attempt_json(f.deflation)},
          {"R_turning_uniform", attempt_json(f.turning_point)},
          {"undershoot", estimate_json(f.undershoot)},
          {"greatest_undershoot", estimate_json(f.greatest_undershoot)},
          {"T_inflation_s", estimate_json(f.inflation)},
          {"small_cycle_s", f.cycle_time},
          {"decay", decay}};
}

std::string estimate_text(const Estimate& e, const std::string& unit = "") {
  return rounded(e.value, 8) + unit + " (estimated error " + rounded(e.error, 2) + ")";
}

std::string attempt_text(const Attempt& a, const std::string& unit = "") {
  return a.estimate ? estimate_text(*a.estimate, unit) : "none: " + a.refusal;
}

std::string motion_text(const MotionForecast& f) {
  const TimeScales times = f.motion.time_scales();
  std::string out = "  about R_eq = " + rounded(f.motion.equilibrium(), 10) + "\n    clocks: ";
  if (f.motion.model() == Model::long_channel) {
    out += rounded(times.deflation, 6) + " s in both regimes, on which C1~ = " + rounded(times.C1, 6) + "  (3.7)\n";
  } else {
    out += "deflating " + rounded(times.deflation, 6) + " s, on which C1 = " + rounded(times.C1, 6) +
           "  (3.6a); inflating " + rounded(times.inflation, 6) + " s, on which C3 = " + rounded(times.C3, 6) +
           "  (3.6b)\n";
  }
  out += "    beta = " + rounded(f.motion.beta(), 8) + ", alpha2 = " + rounded(f.alpha2, 8) + "  (3.20b)\n";
  out += "    deflation from rest at R_i = " + rounded(f.start, 8) + "\n";
  if (f.constants) {
    out += "      delta = 1/C2 = " + rounded(1 / f.motion.require_deflation().C2, 6) +
           ", gamma1 = " + rounded(f.constants->first, 6) + ", gamma2 = " + rounded(f.constants->second, 6) +
           ", gamma3 = " + rounded(f.constants->third, 6) + "  (3.13), on deflation's clock\n";
  }
  out += "      ends after, by (3.17): " + attempt_text(f.deflation_paper, " s") + "\n";
  out += "      ends after, by the uniform solution: " + attempt_text(f.deflation, " s") + "\n";
  out += "      below R_eq by " + estimate_text(f.undershoot) + ", from any height by at most about " +
         estimate_text(f.greatest_undershoot) + "\n";
  out += "    inflation from there takes " + estimate_text(f.inflation, " s") + "\n";
  out += "    decay: a small cycle takes " + rounded(f.cycle_time, 6) + " s; upper turning point above R_eq after\n";
  for (std::size_t i = 0; i < f.cycles.size(); ++i) {
    out += "      " + std::to_string(f.cycles[i]) + (f.cycles[i] == 1 ? " cycle: " : " cycles: ") +
           estimate_text(f.amplitudes[i]) + "\n";
  }
  return out;
}

}  // namespace

std::string asymptotics_json(const Case& c, const AsymptoticsReport& report) {
  Json states = Json::array();
  for (const Equilibrium& e : report.equilibria) states.push_back({{"R", e.stretch}, {"stable", e.stable}});
  Json closed = Json::array();
  for (const ClosedEquilibrium& e : report.closed) {
    Json entry = attempt_json(e.stretch);
    entry["equation"] = e.equation;
    if (e.exact) entry["nearest_exact"] = *e.exact;
    closed.push_back(entry);
  }
  Json motions = Json::array();
  for (const MotionForecast& f : report.motions) motions.push_back(motion_json(f));
  const Json document{{"title", c.title},     {"model", name_of(report.model)}, {"pressure_Pa", report.pressure},
                      {"equilibria", states}, {"closed_equilibria", closed},    {"motions", motions}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string asymptotics_text(const Case& c, const AsymptoticsReport& report) {
  std::string out = c.title + "\n  final pressure " + rounded(report.pressure, 8) + " Pa, model " +
                    std::string(name_of(report.model)) + "\n  equilibria:";
  for (const Equilibrium& e : report.equilibria) {
    out += "  R = " + rounded(e.stretch, 10) + (e.stable ? " stable" : " unstable");
  }
  out += "\n";
  for (const ClosedEquilibrium& e : report.closed) {
    out += "    " + e.equation + ": " + attempt_text(e.stretch);
    if (e.exact && e.stretch.estimate) out += ", off by " + rounded(e.stretch.estimate->value - *e.exact, 2);
    out += "\n";
  }
  for (const MotionForecast& f : report.motions) out += motion_text(f);
  return out;
}

}  // namespace turgor
