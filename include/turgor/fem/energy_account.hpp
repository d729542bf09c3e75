#pragma once
// Powers of a flow and what they add up to.

#include <array>
#include <vector>

#include "turgor/fem/flow_balance.hpp"

namespace turgor {

/// Integrals of powers over time by the trapezoidal rule, as accurate as the steps.
class EnergyAccount {
 public:
  enum Kind : std::size_t { viscous, stabilisation, inlet, wall, damping };

  /// @param damping_power  lost in the wall [W]
  void book(const FlowBalance& b, double damping_power, double dt) {
    const std::array<double, 5> now{b.viscous_loss, b.upwind_loss + b.grad_div_loss + b.penalty_loss,
                                    b.inlet_power + b.inlet_kinetic, b.wall_power, damping_power};
    for (std::size_t i = 0; i < now.size(); ++i) works_[i] += dt / 2 * (powers_[i] + now[i]);
    powers_ = now;
  }
  [[nodiscard]] double power(Kind kind) const { return powers_[kind]; }  ///< [W]
  [[nodiscard]] double work(Kind kind) const { return works_[kind]; }    ///< [J]

  /// For checkpoints.
  static constexpr std::size_t numbers = 10;
  [[nodiscard]] std::vector<double> state() const {
    std::vector<double> all(powers_.begin(), powers_.end());
    all.insert(all.end(), works_.begin(), works_.end());
    return all;
  }
  void restore(const std::vector<double>& state) {
    for (std::size_t i = 0; i < powers_.size(); ++i) {
      powers_[i] = state[i];
      works_[i] = state[powers_.size() + i];
    }
  }

 private:
  std::array<double, 5> powers_{};
  std::array<double, 5> works_{};
};

}  // namespace turgor
