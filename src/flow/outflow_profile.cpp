#include "turgor/flow/outflow_profile.hpp"

#include <math.h>  // NOLINT: Boost 1.74 calls isnan without naming its namespace

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>

#include "gauss_legendre.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr const char* name = "outflow profile";

double checked(const std::function<double(double)>& f, double upsilon) {
  const double value = f(upsilon);
  if (!std::isfinite(value)) {
    throw InvalidInput(name, shortest(value) + " at Upsilon = " + shortest(upsilon), "is not a finite number");
  }
  return value;
}

void check_table(const std::vector<double>& upsilon, const std::vector<double>& velocity) {
  constexpr std::size_t fewest = 4;
  const std::string sizes =
      std::to_string(upsilon.size()) + " distances and " + std::to_string(velocity.size()) + " velocities";
  if (upsilon.size() != velocity.size()) throw InvalidInput(name, sizes, "the two lists differ in length");
  if (upsilon.size() < fewest) {
    throw InvalidInput(name, std::to_string(upsilon.size()) + " points", "too few",
                       "give at least four, from the axis (Upsilon = 0) to the rim (Upsilon = 1)");
  }
  for (std::size_t i = 0; i < upsilon.size(); ++i) {
    if (!std::isfinite(upsilon[i]) || !std::isfinite(velocity[i])) {
      throw InvalidInput(name, "point " + std::to_string(i + 1), "holds a value that is not a finite number");
    }
    if (i > 0 && !(upsilon[i] > upsilon[i - 1])) {
      throw InvalidInput(name, shortest(upsilon[i]) + " after " + shortest(upsilon[i - 1]),
                         "distances from the axis must increase strictly", "sort the points");
    }
  }
  if (upsilon.front() != 0 || upsilon.back() != 1) {
    throw InvalidInput(name, "points from Upsilon = " + shortest(upsilon.front()) + " to " + shortest(upsilon.back()),
                       "must reach from the axis to the rim", "the first Upsilon is 0, the last 1");
  }
}

}  // namespace

OutflowProfile::OutflowProfile(std::vector<Piece> pieces, bool uniform)
    : pieces_(std::move(pieces)), uniform_(uniform) {
  for (const Piece& piece : pieces_) knots_.push_back(piece.lower);
  knots_.push_back(pieces_.back().upper);
  if (uniform) return;
  const double flux = moment([](double f) { return f; });
  const double size = moment([](double f) { return std::abs(f); });
  constexpr double rounding = 1e-12;
  if (!(std::abs(flux) > rounding * size)) {
    throw InvalidInput(name, "int Upsilon f dUpsilon = " + shortest(flux),
                       "carries no liquid, so that it cannot be "
                       "normalised",
                       "give the axial velocity, positive out of the balloon");
  }
  if (flux < 0) {
    throw InvalidInput(name, "int Upsilon f dUpsilon = " + shortest(flux), "carries liquid into the balloon",
                       "positive velocities point out of it");
  }
  normalisation_ = 0.5 / flux;
  for (Piece& piece : pieces_) {
    for (double& c : piece.coefficient) c *= normalisation_;
  }
}

OutflowProfile OutflowProfile::uniform() {
  return OutflowProfile({Piece::through([](double) { return 1.0; }, 0, 1)}, true);
}

OutflowProfile OutflowProfile::polynomial(const std::vector<double>& coefficients) {
  return function([&](double upsilon) {
    double sum = 0;
    for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * upsilon + coefficients[k];
    return sum;
  });
}

OutflowProfile OutflowProfile::table(const std::vector<double>& upsilon, const std::vector<double>& velocity) {
  check_table(upsilon, velocity);
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = upsilon.size(); i-- > 1;) {
    x.push_back(-upsilon[i]);
    y.push_back(velocity[i]);
  }
  x.insert(x.end(), upsilon.begin(), upsilon.end());
  y.insert(y.end(), velocity.begin(), velocity.end());
  const boost::math::interpolators::pchip<std::vector<double>> spline(std::move(x), std::move(y));
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < upsilon.size(); ++i) {
    pieces.push_back(Piece::through(spline, upsilon[i], upsilon[i + 1]));
  }
  return OutflowProfile(std::move(pieces), false);
}

OutflowProfile OutflowProfile::function(const std::function<double(double)>& f, double tolerance) {
  constexpr double shortest_piece = 1e-9;
  constexpr std::size_t most_pieces = 1000;
  std::vector<Piece> pieces;
  std::vector<double> ends{1};  // of the pieces still to be made, the nearest last
  double start = 0;
  double largest = 0;
  while (!ends.empty()) {
    const Piece piece = Piece::through([&](double upsilon) { return checked(f, upsilon); }, start, ends.back());
    for (const double c : piece.coefficient) largest = std::max(largest, std::abs(c));
    if (piece.tail() > tolerance * largest && ends.back() - start > shortest_piece) {
      if (ends.size() + pieces.size() > most_pieces) {
        throw InvalidInput(name, "", "is not smooth enough: more than a thousand pieces are needed",
                           "give it as a table, or ask for a lower accuracy");
      }
      ends.push_back((start + ends.back()) / 2);
      continue;
    }
    pieces.push_back(piece);
    start = ends.back();
    ends.pop_back();
  }
  return OutflowProfile(std::move(pieces), false);
}

OutflowProfile::ValueAndSlope OutflowProfile::at(double upsilon) const {
  if (uniform_) return {1, 0};
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, upsilon);
  const auto at = pieces_[static_cast<std::size_t>(above - knots_.begin() - 1)].at(upsilon);
  return {at.value, at.slope};
}

template <class Integrand>
double OutflowProfile::moment(const Integrand& integrand) const {
  constexpr int points = 24;  // exact for Upsilon f^2, f of degree 15
  const GaussLegendre& rule = gauss_legendre(points);
  double sum = 0;
  for (const Piece& piece : pieces_) {
    const double length = piece.upper - piece.lower;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double upsilon = piece.lower + length * rule.node[i];
      sum += length * rule.weight[i] * upsilon * integrand(piece.at(upsilon).value);
    }
  }
  return sum;
}

double OutflowProfile::momentum_factor() const {
  return 2 * moment([](double f) { return f * f; });
}

}  // namespace turgor
