// Inertance of the liquid in a balloon that begins to move, from the mean pressure on its wall.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "fem/known_flows.hpp"
#include "studies.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double acceleration = 1e-9;  // so that nothing is carried along

/// A wall whose points have a given acceleration along their normals, and along which the liquid slides; the mesh stays
/// where it is. Held by a stiffness against the normal part's error.
class SlidingWall final : public FlexibleWall {
 public:
  /// @param rate  acceleration at the places of the nodes, over `acceleration`; counted along the normal
  template <class Rate>
  SlidingWall(const FlowSpace& space, double centre, const Rate& rate)
      : space_(space), nodes_(space.nodes_on(Side::wall)) {
    std::ranges::sort(nodes_, std::ranges::greater{}, [&](int node) {
      const Point2& X = place(node);
      return std::atan2(X[0], X[1] - centre);
    });
    const auto size = static_cast<Eigen::Index>(2 * nodes_.size());
    wanted_.resize(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      wanted_[i] = acceleration * rate(place(nodes_[static_cast<std::size_t>(i / 2)]))[static_cast<std::size_t>(i % 2)];
    }
    stiffness_ = normal_mass(size);
  }

  [[nodiscard]] const std::vector<int>& nodes() const override { return nodes_; }
  [[nodiscard]] std::vector<double> start() const override {
    std::vector<double> all;
    for (const Point2& X : space_.nodes()) all.insert(all.end(), X.begin(), X.end());
    return all;
  }
  [[nodiscard]] Resistance resistance(const Motion& motion) const override {
    return {stiffness_ * (motion.acceleration - wanted_), motion.acceleration_per_velocity * stiffness_};
  }
  [[nodiscard]] std::vector<double> mesh(const Eigen::VectorXd& /*places*/) const override { return start(); }

 private:
  [[nodiscard]] const Point2& place(int node) const { return space_.nodes()[static_cast<std::size_t>(node)]; }

  /// Of a wall that is so heavy that the liquid's pressure, some hundreds times `acceleration`, moves it by 1e-5.
  [[nodiscard]] Eigen::SparseMatrix<double> normal_mass(Eigen::Index size) const {
    constexpr double heavy = 1e7;
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& edge : space_.edges()) {
      if (edge.side != Side::wall) continue;
      for (const EdgeValues& q : space_.element().edge_points()) {
        double radius = 0;
        Point2 along{};
        for (std::size_t k = 0; k < 3; ++k) {
          radius += q.value[k] * place(edge.nodes[k])[0];
          for (std::size_t c = 0; c < 2; ++c) along[c] += q.derivative[k] * place(edge.nodes[k])[c];
        }
        const double length = std::hypot(along[0], along[1]);
        const Point2 normal{along[1] / length, -along[0] / length};
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j) {
            const double mass = heavy * q.weight * radius * length * q.value[i] * q.value[j];
            for (std::size_t c = 0; c < 2; ++c) {
              for (std::size_t d = 0; d < 2; ++d) {
                entries.emplace_back(unknown(edge.nodes[i], c), unknown(edge.nodes[j], d),
                                     mass * normal[c] * normal[d]);
              }
            }
          }
        }
      }
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
  [[nodiscard]] int unknown(int node, std::size_t component) const {
    const auto at = std::ranges::find(nodes_, node) - nodes_.begin();
    return static_cast<int>(2 * at) + static_cast<int>(component);
  }

  const FlowSpace& space_;
  std::vector<int> nodes_;
  Eigen::VectorXd wanted_;
  Eigen::SparseMatrix<double> stiffness_;
};

/// Of a balloon of radius 1 with an orifice kappa, mean pressure on the wall over the rate of the inflow, over
///   1/(4 kappa) + ln(1/(2 kappa))/(4 pi).
/// @param fineness  over the usual one of docs/fem-mesh.md
/// @param slides    the liquid along the wall, or it sticks
double inertance(double kappa, double fineness, bool slides) {
  const BalloonMesh mesh = balloon_mesh({.orifice_radius = kappa,
                                         .channel_length = 0,
                                         .radius = 1,
                                         .rim = kappa / 60 / fineness,
                                         .orifice = kappa / 15 / fineness,
                                         .wall = 1 / 37.5 / fineness});
  const FlowSpace space(mesh);
  const ToroidalMotion motion(kappa, 1);
  const auto rate = [&](const Point2& X) { return motion.rate(X, 1); };
  FlowDefinition flow = still(1e-15);
  flow.tangential_zero = false;
  if (slides) {
    flow.wall = std::make_shared<SlidingWall>(space, mesh.sphere_centre, rate);
  } else {
    flow.wall_velocity = [&](const Point2& X, double t) {
      const Point2 w = rate(X);
      return Point2{acceleration * t * w[0], acceleration * t * w[1]};
    };
  }
  // bdf1 is exact for what grows evenly; a heavy wall costs digits
  FlowSolver solver(space, flow, {.scheme = FemScheme::bdf1, .update_tolerance = 1e-6, .linear_tolerance = 1e-8});
  take_steps(solver, 1, 2);
  const FlowBalance found = flow_balance(solver, [](const Point2&) { return Point2{}; });
  const double pressure = -found.force / found.area;
  return pressure / (found.inflow / solver.time()) / (1 / (4 * kappa) + std::log(1 / (2 * kappa)) / (4 * pi));
}

}  // namespace

void orifice_inertance() {
  for (const double inverse : {5, 10, 20, 30}) {
    print("orifice", "liquid slides along the wall", 1 / inverse, inertance(1 / inverse, 1, true));
  }
  for (const bool slides : {true, false}) {
    const std::string wall = slides ? "slides" : "sticks";
    std::vector<double> found;
    for (const double fineness : {0.25, 0.5, 1.0, 2.0}) {
      found.push_back(inertance(0.1, fineness, slides));
      const double cell = 1 / 60.0 / fineness;
      print("mesh", "liquid " + wall, cell, found.back());
      if (found.size() > 1) {
        print("change by halved cells", "liquid " + wall, 2 * cell, std::abs(found.back() - found[found.size() - 2]));
      }
    }
    print("mesh", "liquid " + wall + " extrapolated", 0.001, 2 * found[3] - found[2]);
  }
}

}  // namespace turgor
