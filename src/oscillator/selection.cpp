#include "turgor/oscillator/selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace turgor {

namespace {

/// The terms of (2.22) over 1/K at one stretch.
struct Terms {
  double solid, channel, liquid, channel_centripetal, liquid_centripetal;
};

class Comparison {
 public:
  Comparison(const Parameters<double>& p, double least, double greatest) {
    const ForceTable* table = force_table(p);
    const Groups<double> g = groups(p, {p.radius, 1.0, 1.0});  // scales cancel
    const ClosureConstants<double> closure = constants<double>(p.closure);
    const double m = closure.inertial;
    const double n = closure.centripetal * power<3>(p.radius / p.orifice_radius);
    // The ratios of the fits are power laws in R, hence greatest at an end; factors between bend them a little.
    const int parts = table == nullptr ? 1 : 16;
    for (int i = 0; i <= parts; ++i) {
      const double R = i == parts ? greatest : least * std::pow(greatest / least, static_cast<double>(i) / parts);
      const auto [c, l] = closure_factors(p, table, R);
      terms_.push_back({g.a0, g.b * c.inertial * power<4>(R), m * l.inertial * power<4>(R),
                        2 * g.b * c.centripetal * power<3>(R), n * l.centripetal * power<6>(R)});
    }
  }

  /// Greatest of dropped/kept over the range, unless it is zero.
  void add(const char* name, double Terms::* dropped, double Terms::* kept) {
    if (terms_.front().*dropped == 0) return;
    double greatest = 0;
    for (const Terms& at : terms_) {
      greatest = std::max(greatest, at.*kept > 0 ? at.*dropped / at.*kept : std::numeric_limits<double>::infinity());
    }
    found_.push_back({name, greatest});
  }
  [[nodiscard]] std::vector<DroppedTerm> found() && { return std::move(found_); }

 private:
  std::vector<Terms> terms_;
  std::vector<DroppedTerm> found_;
};

}  // namespace

std::vector<DroppedTerm> dropped_terms(Model model, const Parameters<double>& p, double least, double greatest) {
  Comparison terms(p, least, greatest);
  const auto add = [&](const char* name, double Terms::* dropped, double Terms::* kept) {
    terms.add(name, dropped, kept);
  };
  const auto solid = &Terms::solid;
  const auto channel = &Terms::channel;
  const auto liquid = &Terms::liquid;
  const auto channel_centripetal = &Terms::channel_centripetal;
  const auto liquid_centripetal = &Terms::liquid_centripetal;
  if (model == Model::orifice) {
    add("channel inertia / solid inertia, inflating", channel, solid);
    add("channel centripetal / solid inertia, inflating", channel_centripetal, solid);
    add("solid inertia / balloon liquid inertia, deflating", solid, liquid);
    add("channel inertia / balloon liquid inertia, deflating", channel, liquid);
    add("channel centripetal / balloon liquid centripetal, deflating", channel_centripetal, liquid_centripetal);
  } else if (model == Model::long_channel) {
    add("solid inertia / channel inertia, inflating", solid, channel);
    add("solid inertia / channel inertia, deflating", solid, channel);
    add("balloon liquid inertia / channel inertia, deflating", liquid, channel);
    add("channel centripetal / balloon liquid centripetal, deflating", channel_centripetal, liquid_centripetal);
  }
  return std::move(terms).found();
}

Model simplest_model(const Parameters<double>& p, double least, double greatest, double tolerance) {
  for (const Model model : {Model::orifice, Model::long_channel}) {
    if ((model == Model::orifice) != (p.channel_length == 0)) continue;
    const std::vector<DroppedTerm> terms = dropped_terms(model, p, least, greatest);
    if (std::ranges::all_of(terms, [&](const DroppedTerm& t) { return t.ratio < tolerance; })) return model;
  }
  return Model::full;
}

}  // namespace turgor
