#include "turgor/membrane/equilibrium.hpp"

#include <Eigen/SparseLU>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "balance.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

using Eigen::Index;
using Eigen::SparseMatrix;
using Eigen::VectorXd;

constexpr double full_circle = 2 * std::numbers::pi;

enum class Held { pressure, volume };

double held_value(const MembraneState& state, Held held) {
  return held == Held::pressure ? state.pressure : state.volume;
}

/// Newton's matrix for the free places and the pressure: the balance of forces and what is held.
SparseMatrix<double> bordered(const Balance& balance, const MembraneForm& volume, Held held) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<int>(balance.force.size());
  for (Index j = 0; j < balance.tangent.outerSize(); ++j) {
    for (SparseMatrix<double>::InnerIterator it(balance.tangent, j); it; ++it) {
      entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(it.col()), it.value());
    }
  }
  for (int i = 0; i < n; ++i) {
    const double push = volume.gradient(balance.unknowns[static_cast<std::size_t>(i)]);
    entries.emplace_back(i, n, -push);
    if (held == Held::volume) entries.emplace_back(n, i, full_circle * push);
  }
  if (held == Held::pressure) entries.emplace_back(n, n, 1.0);
  SparseMatrix<double> matrix(n + 1, n + 1);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The state near a guess at which pressure or volume has a value; nothing where Newton's method does not find one, or
/// finds one that is far away.
std::optional<MembraneState> newton(const Membrane& membrane, const MembraneState& guess, Held held, double value) {
  constexpr int most_iterations = 12;
  constexpr double farthest = 0.1;    // of the radius: more is another well, or a step too long
  constexpr double tolerance = 1e-8;  // of the radius; the error left is its square
  VectorXd places = guess.places;
  double pressure = guess.pressure;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const MembraneForm volume = membrane.volume(places);
    const Balance balance = balance_of(membrane, places, pressure, volume);
    const auto n = static_cast<Index>(balance.unknowns.size());
    VectorXd defect(n + 1);
    defect << balance.force, (held == Held::pressure ? pressure : full_circle * volume.value) - value;
    const Eigen::SparseLU<SparseMatrix<double>> solver(bordered(balance, volume, held));
    if (solver.info() != Eigen::Success) return std::nullopt;
    const VectorXd change = solver.solve(defect);
    if (!change.allFinite()) return std::nullopt;
    places(balance.unknowns) -= change.head(n);
    pressure -= change(n);
    if ((places - guess.places).cwiseAbs().maxCoeff() > farthest * guess.radius) return std::nullopt;
    if (change.head(n).cwiseAbs().maxCoeff() < tolerance * guess.radius) return state_at(membrane, places, pressure);
  }
  return std::nullopt;
}

/// Goes from a state to a value of what is held, in steps as long as they succeed.
/// @param accepts  whether a state may be one of the way
/// @return the last state, which is the wanted one unless steps became shorter than `least`
MembraneState march(const Membrane& membrane, const MembraneState& start, Held held, double target, double least,
                    const std::function<bool(const MembraneState&)>& accepts) {
  MembraneState last = start;
  double step = target - held_value(start, held);
  while (step != 0) {
    const double left = target - held_value(last, held);
    const bool arrives = std::abs(step) >= std::abs(left);
    const double value = arrives ? target : held_value(last, held) + step;
    std::optional<MembraneState> next;
    try {
      next = newton(membrane, last, held, value);
      if (next && !accepts(*next)) next.reset();
    } catch (const ComputationFailed&) {  // a guess that no membrane can take, or a neutral state
      next.reset();
    }
    if (next) {
      last = *next;
      if (arrives) break;
      step *= 2;
    } else {
      step = value - held_value(last, held);
      step /= 2;
      if (std::abs(step) < least) break;
    }
  }
  return last;
}

std::string state_text(const MembraneState& state) {
  return "a gauge pressure of " + rounded(state.pressure, 8) + " Pa, radius " + rounded(state.radius, 8) +
         " m, volume " + rounded(state.volume, 8) + " m^3";
}

}  // namespace

MembraneState slack_state(const Membrane& membrane) { return state_at(membrane, membrane.reference(), 0); }

MembraneState hold_pressure(const Membrane& membrane, const MembraneState& start, double pressure) {
  if (!std::isfinite(pressure)) throw InvalidInput("pressure", shortest(pressure), "must be finite");
  const double least = 1e-7 * (std::abs(pressure) + std::abs(start.pressure));
  const MembraneState end = march(membrane, start, Held::pressure, pressure, least, [&](const MembraneState& state) {
    return unstable_modes(membrane, state).at_pressure == 0;
  });
  if (std::abs(end.pressure - pressure) <= least) return end;
  throw ComputationFailed("no stable state of rest is within reach at a gauge pressure of " + shortest(pressure) +
                          " Pa; the last one is at " + state_text(end) +
                          (pressure > 0
                               ? ". Beyond a limit point the membrane bursts or jumps; control the volume to go on"
                               : ". Under suction the membrane buckles"));
}

MembraneState hold_volume(const Membrane& membrane, const MembraneState& start, double volume) {
  if (!(volume > 0) || !std::isfinite(volume)) {
    throw InvalidInput("volume", shortest(volume) + " m^3", "must be positive and finite");
  }
  const double least = 1e-9 * (volume + start.volume);
  const MembraneState end =
      march(membrane, start, Held::volume, volume, least, [](const MembraneState&) { return true; });
  if (std::abs(end.volume - volume) <= least) return end;
  throw ComputationFailed("no state of rest is found at a volume of " + rounded(volume, 8) +
                          " m^3; the last one is at " + state_text(end));
}

}  // namespace turgor
