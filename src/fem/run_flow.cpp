#include "turgor/fem/run_flow.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/report.hpp"
#include "turgor/view/field_picture.hpp"

namespace turgor {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<double> field_times(const Case& c) {
  std::vector<double> times = c.fem.field_times;
  const auto last = static_cast<double>(std::max(c.fem.fields - 1, 1L));
  for (long i = 0; i < c.fem.fields; ++i) {
    const bool end = i + 1 == c.fem.fields;
    times.push_back(end ? c.solve.t_end : c.solve.t_end * static_cast<double>(i) / last);
  }
  return times;
}

/// Where the program of the motion, or of the pressure, changes.
std::vector<double> knots(const Case& c) {
  std::vector<double> times;
  if (c.motion) {
    for (const auto& interval : c.motion->intervals(c.solve.t_end)) times.push_back(interval.end);
  } else {
    for (const double t : c.pressure.knots()) {
      if (t > 0 && t < c.solve.t_end) times.push_back(t);
    }
  }
  return times;
}

}  // namespace

std::vector<FlowStop> flow_stops(const Case& c) {
  // Rows first: of times that are one, a row's is kept as requested.
  std::vector<FlowStop> all;
  for (const double t : requested_times(c.solve)) all.push_back({t, true, false});
  for (const double t : field_times(c)) all.push_back({t, false, true});
  for (const double t : knots(c)) all.push_back({t, false, false});
  const double same = 1e-12 * c.solve.t_end;
  std::vector<FlowStop> stops;
  for (const FlowStop& stop : all) {
    const auto next = std::ranges::lower_bound(stops, stop.time - same, {}, &FlowStop::time);
    if (next == stops.end() || next->time > stop.time + same) {
      stops.insert(next, stop);
    } else {
      next->row = next->row || stop.row;
      next->field = next->field || stop.field;
    }
  }
  return stops;
}

namespace {

class FlowRun {
 public:
  FlowRun(const Case& c, FlowProblem& problem, FlowRunFolder& folder, const FlowRunOptions& options)
      : case_(c), problem_(problem), folder_(folder), options_(options) {
    if (!folder.warning().empty()) result_.warnings.push_back({"checkpoint", folder.warning()});
    if (const std::optional<Checkpoint>& start = folder.start()) {
      result_.steps = start->step;
      spent_before_ = start->wall_seconds;
    }
  }

  FlowRunResult run() {
    try {
      if (const std::optional<Checkpoint>& start = folder_.start()) load(*start);
      advance();
    } catch (const std::exception& error) {  // deal.II and PETSc throw exceptions of their own
      fail(error.what());
    }
    result_.size = problem_.size();
    result_.time = problem_.time();
    const FlowRow last = problem_.row();
    result_.radius = last.radius;
    result_.rate = last.rate;
    result_.wall_seconds = spent();
    if (const auto points = problem_.outflow(); !points.empty()) folder_.write_profile(points);
    std::ranges::copy(problem_.warnings(), std::back_inserter(result_.warnings));
    folder_.finish(flow_run_json(case_, result_, options_), result_.status == "complete");
    return std::move(result_);
  }

 private:
  void advance() {
    const std::vector<FlowStop> stops = flow_stops(case_);
    if (!folder_.start()) begin(stops.front());
    for (const FlowStop& stop : stops) {
      while (problem_.time() < stop.time) {
        step(stop.time);
        if (problem_.time() == stop.time) write(stop);
        if (!goes_on()) return;
      }
    }
    result_.status = "complete";
  }

  /// What a new run has at t = 0, and a checkpoint to go on from if it is killed before the next.
  void begin(const FlowStop& first) {
    if (first.time == 0) write(first);
    save();
  }

  void step(double t_stop) {
    const auto start = Clock::now();
    const double before = problem_.time();
    if (result_.steps >= case_.fem.max_steps) {
      throw ComputationFailed("fem.max_steps = " + std::to_string(case_.fem.max_steps) + " steps are taken");
    }
    state_is_whole_ = true;
    SolverRow row = problem_.step(t_stop);
    state_is_whole_ = false;
    if (!(problem_.time() > before && problem_.time() <= t_stop)) {
      throw ComputationFailed("a step towards t = " + shortest(t_stop) + " s led to " + shortest(problem_.time()) +
                              " s");
    }
    row.step = ++result_.steps;
    row.wall_seconds = seconds_since(start);
    folder_.append(row);
    count(row);
  }

  void count(const SolverRow& row) {
    result_.nonlinear_iterations += row.nonlinear_iterations;
    result_.linear_iterations += row.linear_iterations;
    result_.factorisations += row.factorisations;
  }

  void write(const FlowStop& stop) {
    if (stop.row) folder_.append(problem_.row());
    if (stop.field) add_field();
  }

  void add_field() {
    const VtuGrid field = problem_.fields();
    const std::string name = folder_.add_field(problem_.time(), field);
    if (!options_.pictures || !pictures_work_) return;
    const FlowRow state = problem_.row();
    const std::string subtitle = "t = " + rounded(problem_.time(), 5) + " s, r = " + rounded(state.radius, 5) +
                                 " m, dr/dt = " + rounded(state.rate, 4) + " m/s";
    const std::string problem =
        draw_field(field, {case_.title, subtitle, case_.parameters.orifice_radius, case_.output.length_unit},
                   folder_.path() / "fields", name);
    if (problem.empty()) return;
    pictures_work_ = false;  // once is enough
    result_.warnings.push_back({"pictures", problem});
  }

  /// After a step: keeps a checkpoint when one is due; false when the run was interrupted.
  bool goes_on() {
    const bool wanted = !options_.progress || options_.progress(problem_.time());
    const bool in_time = spent() - spent_before_ < options_.max_wall_seconds;
    const bool at_end = problem_.time() >= case_.solve.t_end;
    if (at_end || (wanted && in_time)) {
      if (!at_end && seconds_since(last_save_) >= case_.fem.checkpoint_every) save();
      return true;
    }
    save();
    result_.status = "interrupted";
    result_.message = (wanted ? "--max-wall-time is over" : "interrupted") + std::string(" at t = ") +
                      rounded(problem_.time(), 8) + " s after " + std::to_string(result_.steps) +
                      " steps; go on with --resume";
    return false;
  }

  void load(const Checkpoint& checkpoint) {
    problem_.load(checkpoint);
    const std::vector<double>& work = array_of(checkpoint, work_name, 3);
    result_.nonlinear_iterations = std::lround(work[0]);
    result_.linear_iterations = std::lround(work[1]);
    result_.factorisations = std::lround(work[2]);
  }

  void save() {
    Checkpoint checkpoint;
    problem_.save(checkpoint);
    checkpoint.arrays[work_name] = {static_cast<double>(result_.nonlinear_iterations),
                                    static_cast<double>(result_.linear_iterations),
                                    static_cast<double>(result_.factorisations)};
    checkpoint.step = result_.steps;
    checkpoint.time = problem_.time();
    checkpoint.wall_seconds = spent();
    folder_.save(std::move(checkpoint));
    last_save_ = Clock::now();
  }

  /// Says where it ended. The last accepted state is kept, as a checkpoint and as a field, if its rows are written.
  void fail(const std::string& reason) {
    result_.status = "failed";
    const FlowRow state = problem_.row();
    result_.message = "stopped at t = " + rounded(problem_.time(), 8) + " s (r = " + rounded(state.radius, 6) +
                      " m, dr/dt = " + rounded(state.rate, 4) + " m/s) after " + std::to_string(result_.steps) +
                      " steps: " + reason;
    if (!state_is_whole_) return;
    try {
      save();
      add_field();
    } catch (const std::exception& error) {
      result_.warnings.push_back({"last-state", std::string("the last state could not be kept: ") + error.what()});
    }
  }

  static constexpr const char* work_name = "work";

  [[nodiscard]] double spent() const { return spent_before_ + seconds_since(begin_); }

  const Case& case_;
  FlowProblem& problem_;
  FlowRunFolder& folder_;
  const FlowRunOptions& options_;
  FlowRunResult result_{};
  double spent_before_ = 0;  ///< before a resumption
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_save_ = begin_;
  bool pictures_work_ = true;
  bool state_is_whole_ = false;  ///< during a step: whatever it began with is written
};

}  // namespace

FlowRunResult run_flow(const Case& c, FlowProblem& problem, FlowRunFolder& folder, const FlowRunOptions& options) {
  return FlowRun(c, problem, folder, options).run();
}

}  // namespace turgor
