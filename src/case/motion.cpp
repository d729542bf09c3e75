#include <cmath>

#include "parts.hpp"
#include "segments.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {
const SegmentKeys segment_keys{.start = "motion.start",
                               .list = "motion.velocity",
                               .unit = "m/s",
                               .quantity = "velocity",
                               .example = "2 cm/s",
                               .steps = false};
}  // namespace

void declare_motion(Schema& schema) {
  schema.describe("motion", "dictated radius, in place of [pressure] and [initial]; for `turgor force`");
  schema.add({.path = "motion.radius",
              .unit = "m",
              .range = positive,
              .required = true,
              .meaning = "radius r at t = 0; dr/dt follows from the segments of velocity"});
  declare_segments(schema, segment_keys);
  schema.add({.path = "motion.inlet_pressure",
              .unit = "Pa",
              .fallback = "0 Pa",
              .meaning = "constant gauge pressure at the inlet; 0 leaves the non-static force"});
}

void read_motion(Reader& reader, Case& c) {
  c.motion.reset();
  const Node* table = reader.node("motion");
  if (table == nullptr || table->as<Node::Table>() == nullptr) return;  // the latter said by check_unknown
  for (const char* other : {"pressure", "initial"}) {
    if (reader.node(other) != nullptr) {
      reader.complain(other, "given together with [motion], which dictates the radius from t = 0 on",
                      "leave out either [motion], or [pressure] and [initial]; motion.inlet_pressure is the pressure "
                      "under a dictated motion");
    }
  }
  if (reader.node("expect") != nullptr) {
    reader.complain("expect", "given together with [motion]", "only runs have quantities of interest");
  }
  const auto radius = reader.number("motion.radius");
  const auto velocity = read_segments(reader, segment_keys);
  c.pressure = constant_pressure(reader.number("motion.inlet_pressure").value_or(0));
  if (!radius || !velocity) return;
  if (!std::isfinite(velocity->end())) {
    reader.complain("motion.velocity", "the segments never end", "the sum of their durations must be a finite number");
    return;
  }
  c.motion.emplace(*radius, *velocity);
}

void check_motion(Reader& reader, const Case& c) {
  if (!c.motion || !reader.issues().empty()) return;
  const PrescribedMotion<double>& motion = *c.motion;
  const Parameters<double>& p = c.parameters;
  const RadiusRange<double> range = range_of(motion, c.solve.t_end);
  const std::string orifice = "must stay above inlet.orifice_radius = " + shortest(p.orifice_radius) + " m";
  const double largest = largest_stretch * p.radius;
  if (motion.at(0).radius <= p.orifice_radius) {
    reader.complain("motion.radius", "the balloon is no larger than its orifice", orifice);
  } else if (const auto t = first_time_not_above(motion, p.orifice_radius, c.solve.t_end)) {
    reader.complain("motion.velocity",
                    "the radius falls to that of the orifice at t = " + rounded(*t, 6) + " s, and to " +
                        rounded(range.least, 6) + " m at t = " + rounded(range.least_time, 6) + " s",
                    orifice + " up to solve.t_end = " + shortest(c.solve.t_end) + " s");
  } else if (!(range.greatest <= largest)) {
    reader.complain(
        "motion.velocity",
        "the radius grows to " + rounded(range.greatest, 6) + " m at t = " + rounded(range.greatest_time, 6) + " s",
        "must stay below " + shortest(largest_stretch) + " times balloon.radius = " + shortest(largest) +
            " m up to solve.t_end = " + shortest(c.solve.t_end) + " s");
  } else if (const StretchLimits<double> limits = closure_limits(p);
             !(range.least >= limits.least * p.radius && range.greatest <= limits.greatest * p.radius)) {
    reader.complain("motion.velocity",
                    "r_ch/r goes from " + rounded(p.orifice_radius / range.greatest, 6) + " to " +
                        rounded(p.orifice_radius / range.least, 6) + ", beyond the range of model.closure = \"" +
                        std::string(name_of(p.closure)) + "\"",
                    "must stay between 2^-17 and 0.75 up to solve.t_end");
  }
}

}  // namespace turgor
