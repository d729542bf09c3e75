#pragma once
// Balloons whose wall is elastic, and their small oscillations; for tests and for verification/coupled_studies.cpp.

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "../support/coarse_balloon.hpp"
#include "turgor/fem/coupled_flow.hpp"
#include "turgor/fem/elastic_wall.hpp"
#include "turgor/fem/flow_cell.hpp"
#include "turgor/membrane/equilibrium.hpp"

namespace turgor {

/// Text of a case.
/// @param segments  of the pressure
/// @param more      further keys of [fem], further tables
/// @param start     stretch
inline std::string balloon(const std::string& segments, const std::string& more = "", const std::string& start = "1") {
  return coarse_balloon(
      "[pressure]\nsegments = " + segments + "\n[initial]\nstretch = " + start + "\n[solve]\nt_end = \"10 s\"\n", more);
}

inline Case case_of(const std::string& text) { return parse_case(text, "test.toml"); }

/// Without pressure, at a stretch.
inline Case stretched(const std::string& stretch, const std::string& more = "") {
  return case_of(balloon(R"([{ hold = "1 s" }])", more, stretch));
}

inline BalloonMesh mesh_of(const Case& c) {
  return balloon_mesh({.orifice_radius = c.parameters.orifice_radius,
                       .channel_length = 0,
                       .radius = c.parameters.radius,
                       .rim = c.fem.h_rim,
                       .orifice = c.fem.h_orifice,
                       .wall = c.fem.h_wall});
}

/// Kinetic energy of potential flow, p = 0 in the orifice, as a mass of the wall's nodes: rho B' L^-1 B with the
/// Laplacian L and the flux B of the wall's velocity.
/// @param places  of all nodes
inline Eigen::MatrixXd added_mass(const FlowSpace& space, const std::vector<double>& places,
                                  const std::vector<int>& wall, double density) {
  const auto place = [&](int node, std::size_t c) { return places[2 * static_cast<std::size_t>(node) + c]; };
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& cell : space.cells()) {
    NodalVector<double> x{};
    for (std::size_t i = 0; i < velocity_nodes; ++i) {
      for (std::size_t c = 0; c < 2; ++c) x[c][i] = place(cell.nodes[i], c);
    }
    for (const ShapeValues& shape : space.element().points()) {
      const CellPoint at = cell_point(shape, x);
      for (std::size_t i = 0; i < velocity_nodes; ++i) {
        for (std::size_t j = 0; j < velocity_nodes; ++j) {
          entries.emplace_back(
              cell.nodes[i], cell.nodes[j],
              at.volume * (at.gradient[0][i] * at.gradient[0][j] + at.gradient[1][i] * at.gradient[1][j]));
        }
      }
    }
  }
  for (const int node : space.nodes_on(Side::inlet)) entries.emplace_back(node, node, 1e9);
  Eigen::SparseMatrix<double> laplacian(space.node_count(), space.node_count());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  std::vector<int> number(static_cast<std::size_t>(space.node_count()), -1);
  for (std::size_t k = 0; k < wall.size(); ++k) number[static_cast<std::size_t>(wall[k])] = static_cast<int>(k);
  Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(space.node_count(), static_cast<Eigen::Index>(2 * wall.size()));
  for (const auto& edge : space.edges()) {
    if (edge.side != Side::wall) continue;
    for (const EdgeValues& q : space.element().edge_points()) {
      Point2 along{};
      double radius = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        radius += q.value[k] * place(edge.nodes[k], 0);
        for (std::size_t c = 0; c < 2; ++c) along[c] += q.derivative[k] * place(edge.nodes[k], c);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double w = q.weight * radius * q.value[i] * q.value[k];
          const int at = 2 * number[static_cast<std::size_t>(edge.nodes[k])];
          flux(edge.nodes[i], at) += w * along[1];
          flux(edge.nodes[i], at + 1) -= w * along[0];
        }
      }
    }
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(laplacian);
  return density * flux.transpose() * factors.solve(flux);
}

/// A stretched balloon at rest under its pressure. The liquid has no viscosity: the layer of water in the orifice is 1
/// % of the radius, and of the frequency.
class HeldBalloon {
 public:
  /// @param c  stretched()
  explicit HeldBalloon(Case c) : case_(std::move(c)), mesh_(mesh_of(case_)), space_(mesh_), wall_(space_, case_) {
    case_.parameters.fluid_viscosity = 1e-9;
    const Membrane& membrane = wall_.membrane();
    const double volume = 2 * std::numbers::pi * membrane.volume(wall_.of_wall(wall_.start())).value;
    state_ = hold_volume(membrane, slack_state(membrane), volume);
  }

  /// From rest under a pressure that is greater by a push [Pa] at once.
  [[nodiscard]] Case pushed(double push) const {
    Case c = case_;
    c.pressure = constant_pressure(state_.pressure + push);
    return c;
  }
  /// Small free oscillations, the lowest ones.
  [[nodiscard]] std::vector<ShapeMode> modes(std::size_t count) const {
    return shape_modes(wall_.membrane(), state_,
                       added_mass(space_, wall_.start(), wall_.nodes(), case_.parameters.fluid_density), count);
  }
  [[nodiscard]] const MembraneState& state() const { return state_; }

 private:
  Case case_;
  BalloonMesh mesh_;
  FlowSpace space_;
  ElasticWall wall_;
  MembraneState state_;
};

inline double hertz(const ShapeMode& mode) { return std::sqrt(mode.frequency_squared) / (2 * std::numbers::pi); }

/// The height of the pole over what it is at rest, from each step of a coupled flow.
struct PoleHistory {
  std::vector<double> time;
  std::vector<double> height;
};
/// @param end  [s]
inline PoleHistory ring_down(const Case& c, double end) {
  const auto flow = make_coupled_flow(c);
  const double start = flow->row().top;
  PoleHistory history;
  while (flow->time() < end) {
    (void)flow->step(end);
    history.time.push_back(flow->time());
    history.height.push_back(flow->row().top - start);
  }
  return history;
}

/// Least squares of a history by cosines and sines of two frequencies [Hz] and a constant: what is left of it.
inline double misfit(const PoleHistory& history, double f1, double f2) {
  const auto n = static_cast<Eigen::Index>(history.time.size());
  Eigen::MatrixXd basis(n, 5);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double at = 2 * std::numbers::pi * history.time[static_cast<std::size_t>(i)];
    basis.row(i) << 1, std::cos(f1 * at), std::sin(f1 * at), std::cos(f2 * at), std::sin(f2 * at);
  }
  const Eigen::Map<const Eigen::VectorXd> right(history.height.data(), n);
  return (basis * basis.colPivHouseholderQr().solve(right) - right).norm() / right.norm();
}

/// Two frequencies that fit a history best.
struct FittedModes {
  std::array<double, 2> ratio{1, 1};  ///< to those that were expected, to 1e-4
  double left = 1;                    ///< misfit()
};
/// @param expected  [Hz], off by less than 3 %
inline FittedModes fitted_modes(const PoleHistory& history, const std::array<double, 2>& expected) {
  FittedModes best;
  for (const double step : {3e-3, 5e-4, 1e-4}) {
    const FittedModes about = best;
    for (int i = -10; i <= 10; ++i) {
      for (int j = -10; j <= 10; ++j) {
        const std::array<double, 2> ratio{about.ratio[0] + i * step, about.ratio[1] + j * step};
        const double left = misfit(history, ratio[0] * expected[0], ratio[1] * expected[1]);
        if (left < best.left) best = {ratio, left};
      }
    }
  }
  return best;
}

}  // namespace turgor
