// How the mesh follows an elastic wall.

#include "turgor/fem/elastic_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupled_balloon.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace turgor {
namespace {

struct Wall {
  Case balloon = stretched("1");
  BalloonMesh mesh = mesh_of(balloon);
  FlowSpace space{mesh};
  ElasticWall wall{space, balloon};

  /// Places of the wall's nodes by a map of places.
  template <class Map>
  [[nodiscard]] Eigen::VectorXd moved(const Map& map) const {
    Eigen::VectorXd places = wall.membrane().reference();
    for (Eigen::Index i = 0; i < places.size(); i += 2) {
      const Point2 x = map(Point2{places[i], places[i + 1]});
      places[i] = x[0];
      places[i + 1] = x[1];
    }
    return places;
  }

  [[nodiscard]] double least_jacobian(const std::vector<double>& places) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& cell : space.cells()) {
      NodalVector<double> x{};
      for (std::size_t i = 0; i < velocity_nodes; ++i) {
        for (std::size_t c = 0; c < 2; ++c) x[c][i] = places[2 * static_cast<std::size_t>(cell.nodes[i]) + c];
      }
      for (const ShapeValues& shape : space.element().points()) least = std::min(least, cell_point(shape, x).jacobian);
    }
    return least;
  }
};

TEST(ElasticWall, ASphereHasTheMeshOfTheSphere) {
  const Wall w;
  const double a = w.balloon.parameters.orifice_radius;
  const ToroidalMotion sphere(a, w.balloon.parameters.radius);
  const auto places = w.wall.mesh(w.moved([&](const Point2& X) { return sphere.position(X, 0.75); }));
  for (std::size_t i = 0; i < w.space.nodes().size(); ++i) {
    const Point2 expected = sphere.position(w.space.nodes()[i], 0.75);
    EXPECT_NEAR(places[2 * i], expected[0], 1e-12);
    EXPECT_NEAR(places[2 * i + 1], expected[1], 1e-12);
  }
}

// By 80 degrees, where a harmonic extension of displacements inverts cells from 45 on, however fine they are. The rest
// of the wall stays.
TEST(ElasticWall, CellsTurnWithTheWallAtTheRim) {
  const Wall w;
  const double a = w.balloon.parameters.orifice_radius;
  const auto places = w.moved([&](const Point2& X) {
    ToroidalCoordinates at = toroidal_coordinates(X, a);
    if (X[1] <= 0) return X;
    const double turn = 80 * std::numbers::pi / 180 * (1 + std::tanh(at.tau - 2)) / 2;
    at.rest -= turn;
    at.sigma += turn;
    return toroidal_place(at, a);
  });
  const double angle = std::atan2(places[3], places[2] - a);  // of the wall's first piece to the orifice's plane
  EXPECT_GT(angle, 70 * std::numbers::pi / 180);
  EXPECT_GT(w.least_jacobian(w.wall.mesh(places)), 0.3 * w.least_jacobian(w.wall.mesh(w.wall.membrane().reference())));
}

TEST(ElasticWall, RefusesAWallThatHasComeDownToTheOrifice) {
  const Wall w;
  const auto flat = w.moved([](const Point2& X) { return Point2{X[0] / 20, X[1] > 0 ? -1e-3 : 0}; });
  EXPECT_THROW((void)w.wall.mesh(flat), ComputationFailed);
}

}  // namespace
}  // namespace turgor
