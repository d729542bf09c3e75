// Runs: arrays that look into the C++ rows, dense output, pickling.

#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <mutex>

#include "errors.hpp"
#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/run/directory.hpp"
#include "turgor/run/report.hpp"
#include "turgor/view/pictures.hpp"

namespace turgor::python {

namespace py = pybind11;

namespace {

/// A result with its case and, once somebody asks, its rows.
class Run {
 public:
  Run(SharedCase c, RunResult result, double seconds)
      : case_(std::move(c)), result_(std::move(result)), seconds_(seconds) {}

  [[nodiscard]] const Case& input() const { return *case_; }
  [[nodiscard]] const RunResult& result() const { return result_; }
  [[nodiscard]] const Trajectory<double>& trajectory() const { return *result_.trajectory; }
  /// Time that run_case() took [s].
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] const std::vector<TrajectoryRow>& rows() const {
    std::call_once(made_, [this] { rows_ = trajectory_rows(*case_, result_); });
    return rows_;
  }

 private:
  SharedCase case_;
  RunResult result_;
  double seconds_;
  mutable std::once_flag made_;
  mutable std::vector<TrajectoryRow> rows_;
};

/// One number of every element of a vector, without a copy; `owner` keeps the vector alive.
template <class Number, class Element>
py::array column(const std::vector<Element>& elements, const Number* first, const py::object& owner) {
  py::array_t<Number> view({elements.size()}, {sizeof(Element)}, first, owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

const PhysicalState& part(const TrajectoryRow& row, double PhysicalState::* /*number*/) { return row.state; }
const Energies& part(const TrajectoryRow& row, double Energies::* /*number*/) { return row.energies; }

/// The run, its rows made.
const Run& with_rows(const py::object& self) {
  const Run& run = self.cast<const Run&>();
  const py::gil_scoped_release unlocked;
  (void)run.rows();
  return run;
}

template <class Part>
void bind_column(py::class_<Run, std::shared_ptr<Run>>& type, const char* name, double Part::* number) {
  type.def_property_readonly(name, [number](const py::object& self) {
    const auto& rows = with_rows(self).rows();
    return column(rows, &(part(rows.front(), number).*number), self);
  });
}

/// R, dR/dt [1/s], r [m], volume [m^3], flow rate [m^3/s], regime at times within the run.
Array states(const Run& run, const Array& times) {
  const auto& oscillator = *run.result().oscillator;
  const double clock = oscillator.scales().time;
  const double end = run.trajectory().last.time * clock;
  const bool stays = run.trajectory().outcome == Outcome::at_rest;
  const auto n = times.size();
  for (py::ssize_t i = 0; i < n; ++i) {
    const double t = times.data()[i];
    if (t >= 0 && (t <= end * (1 + 1e-15) || (stays && std::isfinite(t)))) continue;
    throw InvalidInput("t", shortest(t), "is not a time of this run",
                       "allowed is 0 to " + shortest(end) + " s, where the run ended");
  }
  Array out(std::vector<py::ssize_t>{6, n});
  double* to = out.mutable_data();
  const py::gil_scoped_release unlocked;
  for (py::ssize_t i = 0; i < n; ++i) {
    const PhysicalState s = physical_state(oscillator, run.trajectory(), times.data()[i] / clock);
    const std::array<double, 6> values{s.stretch, s.stretch_rate, s.radius,
                                       s.volume,  s.flow_rate,    static_cast<double>(s.regime)};
    for (std::size_t k = 0; k < values.size(); ++k) to[static_cast<py::ssize_t>(k) * n + i] = values[k];
  }
  return out;
}

std::shared_ptr<Run> run(const std::shared_ptr<Case>& c, py::object progress) {
  require_free_motion(*c);
  Interruption interruption(std::move(progress));
  const py::gil_scoped_release unlocked;
  const auto start = std::chrono::steady_clock::now();
  RunResult result = run_case(*c, [&](double time) {
    interruption.reach(time);
    return true;
  });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return std::make_shared<Run>(c, std::move(result), took.count());
}

/// Writes the run directory of `turgor run`; returns what went wrong with pictures.
std::string save(const Run& run, const std::string& folder, bool force, bool pictures) {
  RunDirectory directory(folder, run.input(), force);
  directory.write(run.input(), run.result());
  return pictures && run.input().output.pictures ? draw_pictures(run.input(), run.result(), folder) : "";
}

py::dict quantities(const Run& run) {
  py::dict all;
  for (const Quantity& q : run.result().quantities) {
    all[py::str(q.name)] = py::make_tuple(q.value ? *q.value : std::nan(""), q.unit);
  }
  return all;
}

py::list warnings(const Run& run) {
  py::list all;
  for (const Warning& w : run.result().warnings) all.append(py::make_tuple(w.name, w.text));
  return all;
}

py::list expectations(const Run& run) {
  py::list all;
  for (const ExpectationResult& e : run.result().expectations) {
    all.append(py::make_tuple(e.expected.quantity, e.expected.value, e.expected.tolerance, e.found, e.met));
  }
  return all;
}

py::dict statistics(const Run& run) {
  const IntegratorStatistics& s = run.trajectory().statistics;
  py::dict all;
  all["steps"] = s.steps;
  all["rejected"] = s.rejected;
  all["rate_evaluations"] = s.rate_evaluations;
  all["linearizations"] = s.linearizations;
  all["factorizations"] = s.factorizations;
  all["event_refinements"] = s.event_refinements;
  return all;
}

template <class Part>
py::bytes bytes_of(const Part* first, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Part>);
  return {reinterpret_cast<const char*>(first), count * sizeof(Part)};  // NOLINT: bytes are what pickles hold
}

template <class Part>
std::vector<Part> parts_of(const py::bytes& bytes) {
  const std::string_view view(bytes);
  if (view.size() % sizeof(Part) != 0) throw InvalidInput("pickle", "", "is of another build of turgor", "run again");
  std::vector<Part> parts(view.size() / sizeof(Part));
  if (!parts.empty()) std::memcpy(parts.data(), view.data(), view.size());
  return parts;
}

/// What a run is made of but its case, for pickles.
py::tuple state_of(const Run& run) {
  const Trajectory<double>& t = run.trajectory();
  const ModelChoice& m = run.result().choice;
  return py::make_tuple(static_cast<int>(m.model), m.automatic, m.least_stretch, m.greatest_stretch,
                        bytes_of(t.steps.data(), t.steps.size()), bytes_of(t.events.data(), t.events.size()),
                        bytes_of(&t.last, 1), static_cast<int>(t.outcome), t.message, bytes_of(&t.statistics, 1),
                        run.result().integration_seconds, run.seconds());
}

std::shared_ptr<Run> restore(const std::shared_ptr<Case>& c, const py::tuple& state) {
  const ModelChoice choice{static_cast<Model>(state[0].cast<int>()),
                           state[1].cast<bool>(),
                           state[2].cast<double>(),
                           state[3].cast<double>(),
                           {}};
  Trajectory<double> t;
  t.steps = parts_of<TrajectoryStep<double>>(state[4]);
  t.events = parts_of<RegimeEvent<double>>(state[5]);
  t.last = parts_of<Point<double>>(state[6]).at(0);
  t.outcome = static_cast<Outcome>(state[7].cast<int>());
  t.message = state[8].cast<std::string>();
  t.statistics = parts_of<IntegratorStatistics>(state[9]).at(0);
  return std::make_shared<Run>(c, restored_run(*c, choice, std::move(t), state[10].cast<double>()),
                               state[11].cast<double>());
}

void bind_rows(py::class_<Run, std::shared_ptr<Run>>& type) {
  bind_column(type, "t", &PhysicalState::time);
  bind_column(type, "stretch", &PhysicalState::stretch);
  bind_column(type, "rate", &PhysicalState::stretch_rate);
  bind_column(type, "radius", &PhysicalState::radius);
  bind_column(type, "pressure", &PhysicalState::gauge_pressure);
  bind_column(type, "volume", &PhysicalState::volume);
  bind_column(type, "flow_rate", &PhysicalState::flow_rate);
  bind_column(type, "kinetic", &Energies::kinetic);
  bind_column(type, "elastic", &Energies::elastic);
  bind_column(type, "inlet_work", &Energies::inlet_work);
  bind_column(type, "dissipated", &Energies::dissipated);
  type.def_property_readonly("regime", [](const py::object& self) {
    static_assert(sizeof(Regime) == sizeof(int));
    const auto& rows = with_rows(self).rows();
    return column(rows, reinterpret_cast<const int*>(&rows.front().state.regime), self);  // NOLINT: its values
  });
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<Run, std::shared_ptr<Run>> type(module, "Run");
  bind_rows(type);
  type.def_property_readonly("status", [](const Run& r) { return r.result().status(); })
      .def_property_readonly("outcome", [](const Run& r) { return std::string(name_of(r.trajectory().outcome)); })
      .def_property_readonly("message", [](const Run& r) { return r.trajectory().message; })
      .def_property_readonly("model", [](const Run& r) { return std::string(name_of(r.result().choice.model)); })
      .def_property_readonly(
          "end_time", [](const Run& r) { return r.trajectory().last.time * r.result().oscillator->scales().time; })
      .def_property_readonly("seconds", &Run::seconds)
      .def("states", &states)
      .def("quantities", &quantities)
      .def("warnings", &warnings)
      .def("expectations", &expectations)
      .def("statistics", &statistics)
      .def("events_csv", [](const Run& r) { return events_csv(r.input(), r.result()); })
      .def("trajectory_csv", [](const Run& r) { return trajectory_csv(r.input(), r.result()); })
      .def("json", [](const Run& r) { return run_json(r.input(), r.result()); })
      .def("summary", [](const Run& r, bool verbose) { return summary(r.input(), r.result(), verbose); })
      .def("save", &save, py::call_guard<py::gil_scoped_release>())
      .def("state", &state_of);
  type.def_property_readonly("events", [](const Run& r) {
    const auto& events = r.trajectory().events;
    const double clock = r.result().oscillator->scales().time;
    Array out(std::vector<py::ssize_t>{4, static_cast<py::ssize_t>(events.size())});
    auto to = out.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < to.shape(1); ++i) {
      const auto& e = events[static_cast<std::size_t>(i)];
      to(0, i) = e.time * clock;
      to(1, i) = e.stretch;
      to(2, i) = static_cast<double>(e.before);
      to(3, i) = static_cast<double>(e.after);
    }
    return out;
  });
  module.def("run", &run, py::arg("case"), py::arg("progress"));
  module.def("restore", &restore);
}

}  // namespace turgor::python
