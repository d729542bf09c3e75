#include "turgor/run/portrait_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "parts.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/oscillator/selection.hpp"

namespace turgor {

namespace {

using Json = nlohmann::ordered_json;

PhasePlane plane_of(const Case& c, Model model, double pressure) {
  const PressureProgram<double> program = constant_pressure(pressure);
  const Scales<double> scales = natural_scales(c.parameters, program, 1);
  return {Oscillator<double>(model, c.parameters, program, scales), pressure, c.max_stretch};
}

std::string pascals(double pressure) { return rounded(pressure, 8) + " Pa"; }

void require_equilibrium(const PhasePlane& plane) {
  if (!plane.equilibria().empty()) return;
  const Parameters<double>& p = plane.oscillator().parameters();
  if (plane.force((plane.least_stretch() + plane.greatest_stretch()) / 2) < 0) {
    throw InvalidInput("pressure", pascals(plane.pressure()),
                       "no equilibrium: it squeezes the balloon below R = " + rounded(plane.least_stretch(), 6),
                       "give a higher one; static equilibria are listed by `turgor info`");
  }
  const double locks = stretch_limit(p.material);
  if (std::isfinite(locks) && plane.greatest_stretch() > 0.999 * locks) {
    throw InvalidInput("pressure", pascals(plane.pressure()),
                       "no equilibrium: more than the wall holds before it locks at R = " + rounded(locks, 8),
                       "give a lower one");
  }
}

void require_stretches(const PhasePlane& plane, const WindowWishes& wishes) {
  for (const double R : {wishes.least_stretch, wishes.greatest_stretch}) {
    if (R == 0 || (R >= plane.least_stretch() && R <= plane.greatest_stretch())) continue;
    throw InvalidInput("--stretch-range", shortest(R), "out of range",
                       "allowed are " + shortest(plane.least_stretch()) + " to " + shortest(plane.greatest_stretch()));
  }
}

PhaseWindow window_of(const PhasePlane& plane, WindowWishes wishes) {
  require_stretches(plane, wishes);
  const double clock = plane.oscillator().scales().time;
  wishes.deflation *= clock;
  wishes.inflation *= clock;
  const PhaseWindow window = natural_window(plane, wishes);
  if (window.least_stretch < window.greatest_stretch) return window;
  throw InvalidInput("--stretch-range", rounded(window.least_stretch) + ":" + rounded(window.greatest_stretch),
                     "is empty", "give both ends");
}

/// "comes to rest at R = 1.258201", "runs away".
std::string in_words(const Fate& fate) {
  switch (fate.outcome) {
    case Outcome::at_rest: return "comes to rest at R = " + rounded(fate.stretch, 8);
    case Outcome::runaway: return "runs away";
    case Outcome::burst: return "bursts at R = " + rounded(fate.stretch, 6);
    case Outcome::closure_end: return "shrinks to R = " + rounded(fate.stretch, 6) + ", where the closure ends";
    default: return "is undecided";
  }
}

Json fate_json(const Fate& fate) {
  Json json{{"outcome", name_of(fate.outcome)}};
  if (fate.outcome == Outcome::at_rest) json.update({{"well", fate.well}, {"R", fate.stretch}});
  return json;
}

}  // namespace

PortraitStudy study_portrait(const Case& c, const PortraitQuestion& question) {
  require_free_motion(c);
  const double pressure = question.pressure.value_or(c.pressure(c.solve.t_end));
  PhasePlane plane = plane_of(c, c.model.value_or(Model::full), pressure);
  require_equilibrium(plane);
  PhaseWindow window = window_of(plane, question.window);
  if (!c.model) {
    const Model model = simplest_model(c.parameters, window.least_stretch, window.greatest_stretch, c.auto_tolerance);
    plane = plane_of(c, model, pressure);
    window = window_of(plane, question.window);
  }
  Portrait portrait = make_portrait(plane, window);
  return {!c.model, std::move(plane), std::move(portrait)};
}

std::string portrait_csv(const PortraitStudy& study) {
  std::string out = "curve,kind,R [1],dR/dt [1/s]\n";
  int id = 0;
  for (const KindOfCurve& curve : study.portrait.curves) {
    const std::string beginning = std::to_string(++id) + "," + std::string(name_of(curve.kind)) + ",";
    for (const PhasePoint& p : curve.points) {
      out += beginning;
      append_number(out, p.stretch);
      out += ",";
      append_number(out, p.rate, study.per_second());
      out += "\n";
    }
  }
  return out;
}

std::string portrait_json(const Case& c, const PortraitStudy& study) {
  const Portrait& portrait = study.portrait;
  Json states = Json::array();
  for (const Equilibrium& e : study.plane.equilibria()) states.push_back({{"R", e.stretch}, {"stable", e.stable}});
  Json rests = Json::array();
  for (const RestInterval& interval : portrait.at_rest) {
    Json rest{{"from", interval.stretches.from}, {"to", interval.stretches.to}};
    rest.update(fate_json(interval.fate));
    rests.push_back(std::move(rest));
  }
  Json forbidden = Json::array();
  for (const StretchInterval& interval : portrait.forbidden) forbidden.push_back({interval.from, interval.to});
  Json curves = Json::array();
  for (const KindOfCurve& curve : portrait.curves) {
    curves.push_back({{"curve", curves.size() + 1}, {"kind", name_of(curve.kind)}, {"points", curve.points.size()}});
  }
  const double rate = study.per_second();
  const PhaseWindow& w = portrait.window;
  const Json document{{"turgor", version},
                      {"title", c.title},
                      {"model", name_of(study.plane.oscillator().model())},
                      {"model_chosen_automatically", study.model_chosen},
                      {"pressure_Pa", study.plane.pressure()},
                      {"equilibria", states},
                      {"at_rest", rests},
                      {"slow_deflation_forbidden", forbidden},
                      {"stretch_range", {w.least_stretch, w.greatest_stretch}},
                      {"rate_range_1_per_s", {-w.deflation * rate, w.inflation * rate}},
                      {"curves", curves}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string portrait_text(const Case& c, const PortraitStudy& study) {
  std::string out = c.title + "\n" +
                    summary_line("model", std::string(name_of(study.plane.oscillator().model())) +
                                              (study.model_chosen ? " (chosen automatically)" : "")) +
                    summary_line("pressure", pascals(study.plane.pressure()));
  std::string states;
  for (const Equilibrium& e : study.plane.equilibria()) {
    states += (states.empty() ? "R = " : ", ") + rounded(e.stretch, 10) + (e.stable ? " stable" : " unstable");
  }
  out += summary_line("equilibria", states.empty() ? "none" : states);
  for (const RestInterval& interval : study.portrait.at_rest) {
    out += summary_line("at rest", "R from " + rounded(interval.stretches.from, 8) + " to " +
                                       rounded(interval.stretches.to, 8) + " " + in_words(interval.fate));
  }
  for (const StretchInterval& interval : study.portrait.forbidden) {
    out += summary_line("no slow fall", "R from " + rounded(interval.from, 8) + " to " + rounded(interval.to, 8));
  }
  return out;
}

}  // namespace turgor
