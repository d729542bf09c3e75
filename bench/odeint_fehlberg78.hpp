#pragma once
// Boost.Odeint's explicit pair of highest order, dressed as one of its steppers with dense output.

#include <boost/numeric/odeint/util/bind.hpp>
#include <boost/numeric/odeint/util/unwrap_reference.hpp>
// the two above must come first
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <stdexcept>
#include <utility>

namespace turgor::bench {

/// Fehlberg 7(8), controlled. It has no dense output: a state inside a step is found by a shorter step.
template <class Vector, class System>
class OdeintFehlberg78 {
 public:
  using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<Vector>;

  OdeintFehlberg78(const System& system, double tolerance)
      : system_(system), controlled_(boost::numeric::odeint::make_controlled(tolerance, tolerance, Stepper())) {}

  void initialize(const Vector& y, double t, double h) {
    end_ = y;
    to_ = t;
    size_ = h;
  }
  std::pair<double, double> do_step(const System& /*the one it has*/) {
    begin_ = end_;
    from_ = to_;
    constexpr int too_many = 100;
    for (int tries = 0; controlled_.try_step(system_, end_, to_, size_) == boost::numeric::odeint::fail; ++tries) {
      if (tries > too_many) throw std::runtime_error("odeint finds no step");
    }
    return {from_, to_};
  }
  [[nodiscard]] double current_time_step() const { return size_; }
  void calc_state(double t, Vector& y) {
    if (t == to_) {
      y = end_;
    } else {
      plain_.do_step(system_, begin_, from_, y, t - from_);
    }
  }

 private:
  System system_;
  boost::numeric::odeint::controlled_runge_kutta<Stepper> controlled_;
  Stepper plain_;
  Vector begin_{};
  Vector end_{};
  double from_ = 0;
  double to_ = 0;
  double size_ = 0;
};

}  // namespace turgor::bench
