#pragma once
// Balloons that several tests use.

#include "turgor/oscillator/oscillator.hpp"

namespace turgor::test {

/// The water balloon of section 2.5, SI units.
template <class T = double>
[[nodiscard]] Parameters<T> paper_balloon(const T& orifice_radius, const T& channel_length) {
  return {T(3) / 10,         T(3) / 1000,    T(1000),        T(1000),
          T(894) / 1000000,  orifice_radius, channel_length, MooneyRivlin<T>{T(1500000), T(150000)},
          Closure::corrected};
}

/// The same with a closure; `profile` gets a table of its own.
template <class T>
[[nodiscard]] Parameters<T> with_closure(Parameters<T> p, Closure closure) {
  p.closure = closure;
  static const auto rounded_profile = std::make_shared<const ForceTable>(OutflowProfile::polynomial({1.25, 0, -0.5}));
  if (closure == Closure::profile) p.outflow = rounded_profile;
  return p;
}

/// p_typ = 1 Pa, t_typ = 1 s.
template <class T>
[[nodiscard]] Scales<T> si_scales(const Parameters<T>& p) {
  return {p.radius, T(1), T(1)};
}

/// Up, hold and down again with smooth ramps; times in s, as the reference file names them.
template <class T>
[[nodiscard]] PressureProgram<T> up_hold_down(const T& p_max, const T& t1, const T& t2, const T& t3) {
  return SegmentList<T>(T(0))
      .ramp(p_max, t1, RampShape::smooth)
      .hold(t2 - t1)
      .ramp(T(0), t3 - t2, RampShape::smooth)
      .build();
}

}  // namespace turgor::test
