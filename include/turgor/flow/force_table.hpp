#pragma once
// g3 and g5 of (2.8), tabulated once against kappa = r_ch/r.

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include "turgor/flow/force_coefficients.hpp"

namespace turgor {

/// h3 = kappa g3/(16 pi) and h5 = kappa^4 g5/(32 pi) with their derivatives with respect to kappa. For uniform outflow
/// both tend to 1 as kappa -> 0, so that the liquid's terms of (2.22) become 2 h3 and 4 h5 (r0/r_ch)^3.
template <class T>
struct ForceFactors {
  T inertial, inertial_slope;
  T centripetal, centripetal_slope;
};

/// h3 and h5 for one outflow profile, or given as functions: Chebyshev series on binades of kappa.
class ForceTable {
 public:
  static constexpr int first_binade = -17;
  static constexpr double least_kappa = 0x1p-17;
  static constexpr double greatest_kappa = 0.75;

  static constexpr std::size_t terms = 20;
  using Series = ChebyshevSeries<terms>;
  struct Piece {
    Series inertial;
    Series centripetal;
  };
  /// One for each binade; the last is half a binade, up to greatest_kappa.
  static constexpr std::size_t pieces = -first_binade;

  /// Uniform outflow, from a table in the library: within 1e-12 of (2.8), dropped integral included.
  [[nodiscard]] static const ForceTable& uniform();

  /// Any profile, within 1e-9 of (2.8). A piece is computed when it is first asked for, which takes about 0.1 s; safe
  /// from several threads.
  explicit ForceTable(OutflowProfile profile);

  using Factor = std::function<double(double kappa)>;
  /// h3 and h5 that come from elsewhere, within 1e-14 when they are analytic for kappa > 0.
  ForceTable(const Factor& inertial, const Factor& centripetal);

  /// @return not a number outside [least_kappa, greatest_kappa]
  template <class T>
  [[nodiscard]] ForceFactors<T> at(const T& kappa) const;

  /// g1...g5 at kappa, by the table.
  /// @throws InvalidInput outside [least_kappa, greatest_kappa]
  [[nodiscard]] ForceCoefficients coefficients(double kappa) const;

  /// Both series of one binade, from the flow itself.
  [[nodiscard]] static Piece compute(const OutflowProfile& profile, std::size_t piece, double tolerance);

  /// Uniform for a table of given functions, which has none.
  [[nodiscard]] const OutflowProfile& profile() const { return profile_; }

 private:
  struct Uniform {};
  explicit ForceTable(Uniform unused);

  void fill(const std::function<Piece(std::size_t index)>& piece);
  [[nodiscard]] const Piece& piece(std::size_t index) const;

  struct Slot {
    std::once_flag made;
    Piece piece;
  };
  OutflowProfile profile_;
  std::shared_ptr<std::array<Slot, pieces>> slots_;  ///< shared with copies
};

template <class T>
ForceFactors<T> ForceTable::at(const T& kappa) const {
  const auto rounded = static_cast<double>(kappa);
  if (!(rounded >= least_kappa && rounded <= greatest_kappa)) {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN();
    return {nan, nan, nan, nan};
  }
  const Piece& series = piece(static_cast<std::size_t>(std::ilogb(rounded) - first_binade));
  const auto inertial = series.inertial.at(kappa);
  const auto centripetal = series.centripetal.at(kappa);
  return {inertial.value, inertial.slope, centripetal.value, centripetal.slope};
}

}  // namespace turgor
