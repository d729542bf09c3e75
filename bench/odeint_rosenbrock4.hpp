#pragma once
// Boost.Odeint's Rosenbrock stepper behind a wall: its uBLAS (Boost 1.74) does not compile as C++20.

#include <array>
#include <functional>
#include <memory>
#include <utility>

namespace turgor::bench {

/// The functions of a system of two equations.
struct StiffSystem {
  using Vector = std::array<double, 2>;
  std::function<Vector(const Vector& y, double t)> rate;
  /// df/dy row by row, and df/dt
  std::function<std::pair<std::array<double, 4>, Vector>(const Vector& y, double t)> linearize;
};

/// rosenbrock4 with its controller and dense output.
class OdeintRosenbrock4 {
 public:
  using Vector = std::array<double, 2>;
  explicit OdeintRosenbrock4(double tolerance);
  ~OdeintRosenbrock4();
  OdeintRosenbrock4(const OdeintRosenbrock4&) = delete;
  OdeintRosenbrock4& operator=(const OdeintRosenbrock4&) = delete;

  void initialize(const Vector& y, double t, double dt);
  std::pair<double, double> do_step(const StiffSystem& system);
  void calc_state(double t, Vector& y);

 private:
  struct Stepper;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace turgor::bench
