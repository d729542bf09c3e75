#include "turgor/flow/force_table.hpp"

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/orifice.hpp"
#include "uniform_force_table.hpp"

namespace turgor {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double profile_tolerance = 1e-10;

double lower_end(std::size_t piece) { return std::ldexp(1.0, ForceTable::first_binade + static_cast<int>(piece)); }
double upper_end(std::size_t piece) { return std::min(2 * lower_end(piece), ForceTable::greatest_kappa); }

}  // namespace

ForceTable::Piece ForceTable::compute(const OutflowProfile& profile, std::size_t piece, double tolerance) {
  const double lower = lower_end(piece);
  const double upper = upper_end(piece);
  std::array<ForceCoefficients, terms> g{};
  for (std::size_t j = 0; j < terms; ++j) {
    g[j] = force_coefficients(PotentialFlow(Series::point(j, lower, upper), profile, tolerance));
  }
  std::size_t j = 0;  // through() asks for its points in this order
  const auto inertial = Series::through([&](double kappa) { return kappa * g[j++].g3 / (16 * pi); }, lower, upper);
  j = 0;
  const auto centripetal =
      Series::through([&](double kappa) { return std::pow(kappa, 4) * g[j++].g5 / (32 * pi); }, lower, upper);
  return {inertial, centripetal};
}

ForceTable::ForceTable(OutflowProfile profile)
    : profile_(std::move(profile)), slots_(std::make_shared<std::array<Slot, pieces>>()) {}

ForceTable::ForceTable(Uniform /*unused*/) : ForceTable(OutflowProfile::uniform()) {
  fill([](std::size_t i) -> Piece {
    const UniformForcePiece& shipped = uniform_force_table[i];
    return {{lower_end(i), upper_end(i), shipped.inertial}, {lower_end(i), upper_end(i), shipped.centripetal}};
  });
}

ForceTable::ForceTable(const Factor& inertial, const Factor& centripetal) : ForceTable(OutflowProfile::uniform()) {
  fill([&](std::size_t i) -> Piece {
    return {Series::through(inertial, lower_end(i), upper_end(i)),
            Series::through(centripetal, lower_end(i), upper_end(i))};
  });
}

void ForceTable::fill(const std::function<Piece(std::size_t index)>& piece) {
  for (std::size_t i = 0; i < pieces; ++i) {
    Slot& slot = (*slots_)[i];
    std::call_once(slot.made, [&] { slot.piece = piece(i); });
  }
}

const ForceTable& ForceTable::uniform() {
  static const ForceTable table{Uniform{}};
  return table;
}

const ForceTable::Piece& ForceTable::piece(std::size_t index) const {
  Slot& slot = (*slots_)[index];
  std::call_once(slot.made, [&] { slot.piece = compute(profile_, index, profile_tolerance); });
  return slot.piece;
}

ForceCoefficients ForceTable::coefficients(double kappa) const {
  if (!(kappa >= least_kappa && kappa <= greatest_kappa)) {
    throw InvalidInput("kappa", shortest(kappa), "is outside the table",
                       "r_ch/r must lie between " + shortest(least_kappa) + " and " + shortest(greatest_kappa));
  }
  const ForceFactors<double> h = at(kappa);
  ForceCoefficients g = channel_coefficients(cap_depth(kappa));
  g.g3 = 16 * pi * h.inertial / kappa;
  g.g5 = 32 * pi * h.centripetal / std::pow(kappa, 4);
  return g;
}

}  // namespace turgor
