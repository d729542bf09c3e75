#pragma once
// Motion under piecewise constant pressure by quadrature: no time stepping, an oracle for simulate().

#include "turgor/integrate/simulate.hpp"

namespace turgor {

/// Same arguments, regimes, events and result as simulate(), but exact up to quadrature and rounding.
///
/// While P is constant, the doubled kinetic energy k = M_s (dR/dT)^2 obeys an equation that is linear in k(R),
///
///     dk/dR = (M_s' + 2 Q_s)/M_s k + 2 (a P - E),
///
/// so that k is an integral (docs/theory.md, section 2.4) and T = int dR/sqrt(k/M_s). Whatever options.rtol says, end
/// points of steps carry errors of quadrature below 1e-13 (double) of their step's extent. The rounding of the force
/// a P - E remains: next to an equilibrium it moves times by about a tenth of epsilon over the amplitude of the motion.
/// Between end points, polynomials of degree 7 agree with the quadrature to a tenth of options.rtol and options.atol,
/// and to 1.6e-10 of the step's extent at least, as far as rounding allows. Statistics count panels as steps and
/// evaluations of the coefficients as rate evaluations.
///
/// As simulate(), never throws for trouble on the way.
/// @throws InvalidInput as simulate() does, and as require_piecewise_constant()
template <class T>
[[nodiscard]] Trajectory<T> simulate_by_quadrature(const Oscillator<T>& oscillator, const T& start_time,
                                                   const T& stretch, const T& rate, const T& end_time,
                                                   const SimulationOptions<T>& options);

/// @param program     gauge pressure against time
/// @param start, end  times between which the pressure must be constant from knot to knot, in units of `clock` [s]
/// @throws InvalidInput for solve.method, naming the first piece of the program that is not constant
template <class T>
void require_piecewise_constant(const PressureProgram<T>& program, const T& start, const T& end, const T& clock);

extern template Trajectory<double> simulate_by_quadrature(const Oscillator<double>&, const double&, const double&,
                                                          const double&, const double&,
                                                          const SimulationOptions<double>&);
extern template Trajectory<long double> simulate_by_quadrature(const Oscillator<long double>&, const long double&,
                                                               const long double&, const long double&,
                                                               const long double&,
                                                               const SimulationOptions<long double>&);
extern template void require_piecewise_constant(const PressureProgram<double>&, const double&, const double&,
                                                const double&);
extern template void require_piecewise_constant(const PressureProgram<long double>&, const long double&,
                                                const long double&, const long double&);

}  // namespace turgor
