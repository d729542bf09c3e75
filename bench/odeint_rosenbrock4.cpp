#include "odeint_rosenbrock4.hpp"

#include <boost/numeric/odeint.hpp>

namespace turgor::bench {

namespace odeint = boost::numeric::odeint;

struct OdeintRosenbrock4::Stepper {
  odeint::rosenbrock4_dense_output<odeint::rosenbrock4_controller<odeint::rosenbrock4<double>>> dense;
  boost::numeric::ublas::vector<double> at;
};

OdeintRosenbrock4::OdeintRosenbrock4(double tolerance)
    : stepper_(new Stepper{odeint::make_dense_output(tolerance, tolerance, odeint::rosenbrock4<double>()),
                           boost::numeric::ublas::vector<double>(2)}) {}
OdeintRosenbrock4::~OdeintRosenbrock4() = default;

void OdeintRosenbrock4::initialize(const Vector& y, double t, double dt) {
  stepper_->at[0] = y[0];
  stepper_->at[1] = y[1];
  stepper_->dense.initialize(stepper_->at, t, dt);
}

std::pair<double, double> OdeintRosenbrock4::do_step(const StiffSystem& system) {
  const auto rates = [&](const auto& y, auto& out, double t) {
    const Vector r = system.rate({y[0], y[1]}, t);
    out[0] = r[0];
    out[1] = r[1];
  };
  const auto jacobian = [&](const auto& y, auto& matrix, double t, auto& in_time) {
    const auto [j, f] = system.linearize({y[0], y[1]}, t);
    matrix(0, 0) = j[0];
    matrix(0, 1) = j[1];
    matrix(1, 0) = j[2];
    matrix(1, 1) = j[3];
    in_time[0] = f[0];
    in_time[1] = f[1];
  };
  return stepper_->dense.do_step(std::make_pair(rates, jacobian));
}

void OdeintRosenbrock4::calc_state(double t, Vector& y) {
  stepper_->dense.calc_state(t, stepper_->at);
  y = {stepper_->at[0], stepper_->at[1]};
}

}  // namespace turgor::bench
