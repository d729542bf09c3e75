#pragma once
// Free motion from rest through many half-cycles: the approximations of section 3.3 one after the other.

#include <string>
#include <variant>
#include <vector>

#include "turgor/asymptotics/matched_deflation.hpp"
#include "turgor/asymptotics/oscillation.hpp"

namespace turgor {

/// Which approximations are chained.
enum class Chain {
  paper,    ///< (3.16) until (3.17); (3.18) without, (3.19) with a channel until pi/alpha
  uniform,  ///< SlowDeflation until Decay's undershoot; Oscillation of third order for small amplitudes and inflation
};

/// The piecewise solution of section 3.3: half-cycles that follow each other where dR/dT = 0.
class PiecewiseSolution {
 public:
  /// @param start        R_i, at rest; above the equilibrium the balloon deflates first
  /// @param half_cycles  at most this many, at least one
  /// @throws InvalidInput for `start` when it is the equilibrium or outside the well, and as MatchedDeflation or
  ///         SlowDeflation when already the first half-cycle cannot be described; for model.name when it is the full
  ///         one
  PiecewiseSolution(const FreeMotion& motion, double start, int half_cycles, Chain chain);

  struct HalfCycle {
    Regime regime;
    double begin;  ///< T
    Estimate duration;
    double from;  ///< R
    Estimate to;  ///< R
  };
  [[nodiscard]] const std::vector<HalfCycle>& half_cycles() const { return half_cycles_; }
  /// R(T) for 0 <= T <= end_time(); the error adds up those of all half-cycles so far.
  /// @throws InvalidInput for `T` outside
  [[nodiscard]] Estimate at(double T) const;
  [[nodiscard]] double end_time() const;
  /// Why there are fewer half-cycles than asked for; empty when there are not.
  [[nodiscard]] const std::string& ending() const { return ending_; }

 private:
  using Law = std::variant<MatchedDeflation, SlowDeflation, Oscillation>;
  void append(const FreeMotion& motion, double from);
  [[nodiscard]] Law law_of(const FreeMotion& motion, double from) const;
  [[nodiscard]] Estimate stretch(std::size_t index, double T) const;

  bool channel_;
  Chain chain_;
  double equilibrium_;
  std::vector<Law> laws_;
  std::vector<HalfCycle> half_cycles_;
  std::string ending_;
};

}  // namespace turgor
