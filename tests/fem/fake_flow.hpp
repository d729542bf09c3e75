#pragma once
// A flow without liquid: steps of fixed size, and a state whose every bit depends on every step.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <functional>
#include <limits>
#include <sstream>

#include "../support/program.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/fem/run_flow.hpp"

namespace turgor::test {

class FakeFlow : public FlowProblem {
 public:
  /// @param before    called before a step with the number of steps taken since the start of this object
  /// @param warnings  that it has from the start
  explicit FakeFlow(const Case& c, std::function<void(long)> before = {}, std::vector<Warning> warnings = {})
      : case_(c), before_(std::move(before)), warnings_(std::move(warnings)) {}

  [[nodiscard]] FlowSize size() const override { return {1, 2}; }
  [[nodiscard]] double time() const override { return time_; }

  SolverRow step(double t_stop) override {
    if (before_) before_(taken_);
    const double dt = std::min(case_.fem.time_step, t_stop - time_);
    time_ = dt < case_.fem.time_step ? t_stop : std::min(time_ + dt, t_stop);
    state_ = 3.9 * state_ * (1 - state_) * (1 - 0.01 * dt);
    ++taken_;
    stops_.push_back(time_);
    return {0, time_, dt, 0.5, 3, 30, 1, 1e-9, 1, 1e-12};
  }

  [[nodiscard]] FlowRow row() const override {
    const auto motion = dictated_motion(case_).at(time_);
    FlowRow row{};
    row.time = time_;
    row.radius = motion.radius;
    row.rate = motion.rate;
    row.acceleration = motion.acceleration;
    row.force = state_;
    row.force_mode = 2 * state_;
    return row;
  }

  /// The square of side 1 as one curved quadrilateral.
  [[nodiscard]] VtuGrid fields() const override {
    VtuGrid grid;
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {1.0, 0.0},
                               {1.0, 1.0},
                               {0.0, 1.0},
                               {0.5, 0.0},
                               {1.0, 0.5},
                               {0.5, 1.0},
                               {0.0, 0.5},
                               {0.5, 0.5}}) {
      grid.points.insert(grid.points.end(), {x, y, 0});
    }
    grid.biquadratic = {{0, 1, 2, 3, 4, 5, 6, 7, 8}};
    grid.data = {{"pressure", 1, std::vector<double>(9, state_)}, {"velocity", 3, std::vector<double>(27, time_)}};
    return grid;
  }

  void save(Checkpoint& checkpoint) override {
    checkpoint.times = {time_};
    checkpoint.arrays["state"] = {state_};
  }
  void load(const Checkpoint& checkpoint) override {
    time_ = checkpoint.times.at(0);
    state_ = checkpoint.arrays.at("state").at(0);
  }

  [[nodiscard]] std::vector<Warning> warnings() const override { return warnings_; }

  /// Where steps have ended.
  [[nodiscard]] const std::vector<double>& stops() const { return stops_; }
  void spoil() { state_ = std::numeric_limits<double>::quiet_NaN(); }

 private:
  Case case_;
  std::function<void(long)> before_;
  std::vector<Warning> warnings_;
  double time_ = 0;
  double state_ = 0.4;
  long taken_ = 0;
  std::vector<double> stops_;
};

/// A motion of 5 s with knots at 0.5, 1.5, 2, 2.5, ... s, steps of 0.1 s, 11 rows, 3 fields, a checkpoint after every
/// step.
inline Case fake_case(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(),
                   {"solve.samples=11", "fem.time_step=0.1 s", "fem.fields=3", "fem.checkpoint_every=0 s"});
  return read_case(std::filesystem::path(TURGOR_CASES) / "motion-orifice-30mm.toml", overrides);
}

/// The lines of a text.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// solver.csv without its last column, the time that steps took.
inline std::vector<std::string> timeless(const std::filesystem::path& solver_csv) {
  std::vector<std::string> lines = lines_of(contents(solver_csv));
  for (std::string& line : lines) line.resize(line.rfind(','));
  return lines;
}

}  // namespace turgor::test
