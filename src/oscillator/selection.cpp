#include "turgor/oscillator/selection.hpp"

#include <algorithm>
#include <limits>

namespace turgor {

namespace {

/// Greatest of dropped(R)/kept(R) at the two ends of the range: every ratio here is a power law in R, hence monotone.
template <class Dropped, class Kept>
void compare(std::vector<DroppedTerm>& terms, const std::string& name, double least, double greatest,
             const Dropped& dropped, const Kept& kept) {
  if (dropped(least) == 0) return;
  const auto ratio = [&](double R) {
    return kept(R) > 0 ? dropped(R) / kept(R) : std::numeric_limits<double>::infinity();
  };
  terms.push_back({name, std::max(ratio(least), ratio(greatest))});
}

}  // namespace

std::vector<DroppedTerm> dropped_terms(Model model, const Groups<double>& g, double least, double greatest) {
  const auto solid = [&](double) { return g.a0; };
  const auto channel = [&](double R) { return g.b * power<4>(R); };
  const auto liquid = [&](double R) { return g.m * power<4>(R); };
  const auto channel_centripetal = [&](double R) { return 2 * g.b * power<3>(R); };
  const auto liquid_centripetal = [&](double R) { return g.n * power<6>(R); };

  std::vector<DroppedTerm> terms;
  const auto add = [&](const char* name, const auto& dropped, const auto& kept) {
    compare(terms, name, least, greatest, dropped, kept);
  };
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
  return terms;
}

Model simplest_model(const Groups<double>& g, double least, double greatest, double tolerance) {
  for (const Model model : {Model::orifice, Model::long_channel}) {
    if ((model == Model::orifice) != (g.b == 0)) continue;
    const std::vector<DroppedTerm> terms = dropped_terms(model, g, least, greatest);
    if (std::ranges::all_of(terms, [&](const DroppedTerm& t) { return t.ratio < tolerance; })) return model;
  }
  return Model::full;
}

}  // namespace turgor
