#pragma once
// The pressure relief valve by Boost.Odeint.

#include "valve.hpp"

namespace turgor::bench {

/// Records of one valve: Dormand-Prince 5 with dense output; Fehlberg 7(8), events found by shorter steps.
void valve_by_dopri5(double q, const ValveTask& task, std::span<double> records);
void valve_by_fehlberg78(double q, const ValveTask& task, std::span<double> records);

}  // namespace turgor::bench
