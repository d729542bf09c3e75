#pragma once
// The slow manifold (3.21), corrected, and the deflation from rest that follows it: uniform in time.

#include <vector>

#include "turgor/asymptotics/free_motion.hpp"

namespace turgor {

/// (dR/dT)^2 of slow deflation at one stretch, as terms of falling order in 1/C2. Negative sums: there is no slow
/// manifold at this stretch.
struct SlowManifold {
  double leading;     ///< w0 = C1 F/(C2 R^6), the square of (3.21)
  double correction;  ///< w1 = w0'/(2 C2 R^2)
  double next;        ///< w2 = w1'/(2 C2 R^2): the error of the sum of the first two

  /// w0 + w1.
  [[nodiscard]] Estimate corrected() const;
};

/// At R > 0 anywhere in the well.
/// @throws InvalidInput for model.name when the model is the full one
[[nodiscard]] SlowManifold slow_manifold(const FreeMotion& motion, double R);

/// Deflation from rest at R_i to the next rest below R_eq:
///
///     (dR/dT)^2 = w(R) = ws(R) - ws(R_i) exp[-(2/3) C2 (R_i^3 - R^3)],   ws = w0 + w1,   T = int_R^{R_i} dR/sqrt(w)
///
/// The exponential is the inner layer. w satisfies the equation of motion but for w1', of relative order 1/C2^2, at
/// every stretch: R(T) is uniform through the layer, the slow motion for times ~ sqrt(C2), where (3.16) fails, and the
/// turning point. The estimated errors compare with ws = w0 + w1 + w2.
class SlowDeflation {
 public:
  /// @throws InvalidInput for model.name when the model is the full one; for `start` unless it lies between the
  ///         equilibrium and the next unstable one, far enough from both: |w2| < w0/10. Near the equilibrium
  ///         Oscillation does better; near the unstable one there is no slow manifold
  SlowDeflation(const FreeMotion& motion, double start);

  /// (dR/dT)^2, between the turning point and the start.
  [[nodiscard]] double squared_rate(double R) const { return leading_.squared_rate(R); }
  /// R(T) for T >= 0; from transition_time() on, the turning point.
  [[nodiscard]] Estimate at(double T) const;
  /// Stretch below R_eq at which the balloon comes to rest.
  [[nodiscard]] Estimate turning_point() const;
  /// T_d->i.
  [[nodiscard]] Estimate transition_time() const;

  /// R(T) and T_d->i with ws = w0 + w1 + w2, which the errors are measured by.
  [[nodiscard]] double refined_at(double T) const;
  [[nodiscard]] double refined_transition_time() const { return next_.duration(); }

 private:
  /// The motion with a given number of terms of the manifold.
  class Way {
   public:
    Way(const FreeMotion& motion, double start, int terms);
    [[nodiscard]] double squared_rate(double R) const;
    [[nodiscard]] double at(double T) const;
    [[nodiscard]] double turning_point() const { return end_; }
    [[nodiscard]] double duration() const { return duration_; }

   private:
    /// A piece of the way, R = start - s^2 or, past the middle, R = end + s^2.
    struct Piece {
      bool falling;  ///< measured from the start
      double from, to;
      double time;  ///< when it begins
    };
    [[nodiscard]] double manifold(double R) const;
    [[nodiscard]] double slope_to_start(double way) const;  ///< w/(R_i - R)
    [[nodiscard]] double find_turning_point() const;
    void add_pieces(bool falling, double greatest);
    [[nodiscard]] double duration(bool falling, double from, double to) const;

    FreeMotion motion_;
    double C2_;
    double start_;
    int terms_;
    double at_start_;  ///< ws(R_i)
    double end_;
    double duration_ = 0;
    std::vector<Piece> pieces_;
  };

  Way leading_;
  Way next_;
};

}  // namespace turgor
