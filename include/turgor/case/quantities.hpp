#pragma once
// The numbers that sum up a run, by the names they have in [expect], run.json and on the screen.

#include <string_view>
#include <vector>

namespace turgor {

struct QuantityName {
  std::string_view name;
  std::string_view unit;  ///< SI unit, "1" when dimensionless
  std::string_view meaning;
};

/// All quantities of interest, in the order in which they are shown.
[[nodiscard]] inline const std::vector<QuantityName>& quantity_names() {
  static const std::vector<QuantityName> names{
      {"peak_stretch", "1", "greatest stretch"},
      {"peak_time", "s", "time of the greatest stretch"},
      {"rise_time", "s", "from 10 % to 90 % of the way from the initial stretch to the peak, before the peak"},
      {"fall_time", "s", "from 10 % to 90 % of the way from the peak down to the final stretch"},
      {"final_stretch", "1", "stretch at the end"},
      {"final_rate", "1/s", "dR/dt at the end"},
      {"end_time", "s", "time at which the run ended"},
      {"events", "1", "number of regime changes"},
      {"first_event_time", "s", "time of the first regime change"},
      {"inlet_work", "J", "work done by the inlet pressure"},
      {"dissipated", "J", "energy lost during deflation, carried off by the outflow"},
      {"energy_error", "1",
       "energy balance: kinetic + elastic - work + dissipated - initial, over the largest of them"},
      {"peak_reynolds", "1", "greatest Reynolds number in the orifice"},
      {"final_well", "1",
       "well of the final stretch at the final pressure: 1 + number of unstable equilibria below it (1 small, 2 "
       "large)"},
      {"switched", "1", "1 when the initial stretch lies in another well of the final pressure than the final stretch"},
  };
  return names;
}

}  // namespace turgor
