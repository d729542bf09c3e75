#include "turgor/flow/meridional_flow.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/orifice.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;

struct ValueAndSlope {
  double value;
  double slope;
};

/// The cubic on [0, 1] with these values and slopes at its ends.
struct Cubic {
  double first, last;
  double first_slope, last_slope;

  double operator()(double t) const {
    const double length = last - first;
    return first + t * (first_slope +
                        t * (3 * length - 2 * first_slope - last_slope + t * (first_slope + last_slope - 2 * length)));
  }
};

/// Where an increasing concave function, 0 at 0, has a value: Newton's method from the left never passes it.
double solve_concave(double value, const std::function<ValueAndSlope(double)>& f) {
  double x = 0;
  constexpr int most = 200;
  for (int i = 0; i < most; ++i) {
    const auto [here, slope] = f(x);
    const double step = (value - here) / slope;
    x += step;
    if (std::abs(step) <= 1e-14 * x) break;
  }
  return x;
}

/// Index of a node against height on the axis: half of the nodes spread evenly, half evenly in the logarithm beyond the
/// orifice's radius.
ValueAndSlope axis_index(double height, double top, double kappa) {
  const double scale = std::log1p(top / kappa);
  return {std::log1p(height / kappa) / (2 * scale) + height / (2 * top),
          1 / (2 * scale * (kappa + height)) + 1 / (2 * top)};
}

/// Index of a node against tau: half of the nodes spread evenly along the wall, half evenly in the logarithm of the
/// distance from the rim.
ValueAndSlope arc_index(double tau, double greatest, double wall_sigma) {
  const double angle = std::atan(greatest / wall_sigma);
  const double t = tau / wall_sigma;
  return {std::atan(t) / (2 * angle) + tau / (2 * greatest),
          1 / (2 * angle * wall_sigma * (1 + t * t)) + 1 / (2 * greatest)};
}

/// Real index of a value between increasing nodes.
double fractional_index(const std::vector<double>& nodes, double value) {
  const auto above = std::ranges::upper_bound(nodes, value);
  if (above == nodes.begin()) return 0;
  if (above == nodes.end()) return static_cast<double>(nodes.size() - 1);
  const double before = *(above - 1);
  return static_cast<double>(above - nodes.begin() - 1) + (value - before) / (*above - before);
}

}  // namespace

MeridionalMesh::MeridionalMesh(double kappa, int cells) : kappa_(kappa) {
  if (!(kappa > 0 && kappa < 1)) {
    throw InvalidInput("kappa", shortest(kappa), "the orifice must be smaller than the balloon",
                       "kappa = r_ch/r lies between 0 and 1");
  }
  constexpr int fewest = 4;
  constexpr int most = 10'000;
  if (cells < fewest || cells > most) {
    throw InvalidInput("resolution", std::to_string(cells), "out of range", "allowed are 4 to 10000 cells");
  }
  const double top = 2 - cap_depth(kappa);
  const double wall_sigma = std::asin(kappa);
  const double greatest_tau = std::log(2 / rim_gap);
  for (int i = 0; i <= cells; ++i) {
    const double share = static_cast<double>(i) / cells;
    const double height = solve_concave(1 - share, [&](double z) { return axis_index(z, top, kappa); });
    sigma_.push_back(2 * std::atan2(kappa, height));
    const auto index = [&](double tau) { return arc_index(tau, greatest_tau, wall_sigma); };
    tau_.push_back(solve_concave(share, index));
    tau_step_.push_back(1 / (cells * index(tau_.back()).slope));
  }
  sigma_.front() = wall_sigma;
}

MeridionalPoint MeridionalMesh::point(double sigma, double tau) const {
  const double half = std::sin(sigma / 2);
  const double half_tau = std::sinh(tau / 2);
  const double denominator = 2 * (half_tau * half_tau + half * half);  // cosh tau - cos sigma
  const double height = sigma == pi ? 0 : kappa_ * std::sin(sigma) / denominator;
  return {kappa_ * std::sinh(tau) / denominator, height};
}

MeridionalMesh::Place MeridionalMesh::place(const MeridionalPoint& point) const {
  const double z2 = point.height * point.height;
  const double near2 = std::pow(point.distance - kappa_, 2) + z2;
  const double far2 = std::pow(point.distance + kappa_, 2) + z2;
  const double sigma = std::atan2(2 * kappa_ * point.height, point.distance * point.distance + z2 - kappa_ * kappa_);
  return {fractional_index(sigma_, sigma), fractional_index(tau_, std::log(far2 / near2) / 2)};
}

MeridionalFlow::MeridionalFlow(const PotentialFlow& flow, int cells)
    : mesh_(flow.kappa(), cells),
      centre_speed_(1 / (1 - flow.eps())),
      total_stream_(flow.kappa() * flow.kappa() / 2 * channel_speed(flow.eps())) {
  constexpr double inside = 1e-14;  // keeps rounding from pushing nodes of the orifice's plane out of the balloon
  const std::size_t size = mesh_.size();
  nodes_.resize(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      Node& node = nodes_[i * size + j];
      node.point = mesh_.node(i, j);
      const double height = std::max(node.point.height, inside) - (1 - flow.eps());
      node.polar = {std::min(1.0, std::hypot(node.point.distance, height)), std::atan2(node.point.distance, height)};
      if (i == 0) {
        node.polar.radius = 1;
        node.field = flow.on_wall(flow.wall_angle() - node.polar.theta);
      } else {
        node.field = flow.at(node.polar);
      }
      const double sine = std::sin(node.polar.theta);
      const double cosine = std::cos(node.polar.theta);
      node.across = j == 0 ? 0 : node.field.radial * sine + node.field.tangential * cosine;
      node.along = node.field.radial * cosine - node.field.tangential * sine;
    }
    integrate_row(i);
  }
}

/// dpsi/dj along a row: 2 pi of it crosses the row towards the wall.
double MeridionalFlow::flux(std::size_t row, std::size_t column) const {
  if (column == 0) return 0;
  const Node& node = this->node(row, column);
  const double sigma = mesh_.sigma()[row];
  const double tau = mesh_.tau()[column];
  const double half = std::sin(sigma / 2);
  const double half_tau = std::sinh(tau / 2);
  const double denominator = 2 * (half_tau * half_tau + half * half);
  const double normal_across = std::sinh(tau) * std::sin(sigma) / denominator;
  const double normal_along = (1 - std::cos(sigma) * std::cosh(tau)) / denominator;
  const double length = node.point.distance / std::sinh(tau) * mesh_.tau_step()[column];
  return node.point.distance * length * (node.across * normal_across + (node.along + centre_speed_) * normal_along);
}

/// Integrals between nodes of the cubics through their four nearest neighbours; the flux is odd about the axis.
void MeridionalFlow::integrate_row(std::size_t row) {
  const std::size_t last = mesh_.cells();
  Node* nodes = &nodes_[row * mesh_.size()];
  double before = -flux(row, 1);
  double left = 0;
  double right = flux(row, 1);
  double sum = 0;
  for (std::size_t j = 0; j < last; ++j) {
    const double after = j + 2 <= last ? flux(row, j + 2) : 0;
    sum += j + 1 < last ? (13 * (left + right) - before - after) / 24
                        : (9 * right + 19 * left - 5 * before + flux(row, last - 3)) / 24;
    nodes[j + 1].stream_function = sum;
    before = left;
    left = right;
    right = after;
  }
}

std::vector<MeridionalPoint> MeridionalFlow::stream_line(double share) const {
  const double wanted = share * total_stream_;
  std::vector<MeridionalPoint> line;
  for (std::size_t i = 0; i < mesh_.size(); ++i) {
    std::size_t j = 0;
    while (j + 1 < mesh_.cells() && node(i, j + 1).stream_function < wanted) ++j;
    const Cubic stream{node(i, j).stream_function, node(i, j + 1).stream_function, flux(i, j), flux(i, j + 1)};
    const Cubic tau{mesh_.tau()[j], mesh_.tau()[j + 1], mesh_.tau_step()[j], mesh_.tau_step()[j + 1]};
    double low = 0;
    double high = 1;
    constexpr int halvings = 30;
    for (int k = 0; k < halvings; ++k) {
      const double middle = (low + high) / 2;
      (stream(middle) < wanted ? low : high) = middle;
    }
    line.push_back(mesh_.point(mesh_.sigma()[i], tau(low)));
  }
  return line;
}

}  // namespace turgor
