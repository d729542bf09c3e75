// The flow inside a deflating balloon at one instant, at any points.

#include <pybind11/stl.h>

#include <cmath>

#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/profile.hpp"
#include "turgor/run/flow_report.hpp"

namespace turgor::python {

namespace py = pybind11;

namespace {

/// A snapshot with its case.
class Flow {
 public:
  Flow(SharedCase c, const FlowInstant& instant, OutflowProfile profile)
      : case_(std::move(c)), snapshot_(*case_, instant, std::move(profile)) {}

  [[nodiscard]] const Case& input() const { return *case_; }
  [[nodiscard]] const FlowSnapshot& snapshot() const { return snapshot_; }

 private:
  SharedCase case_;
  FlowSnapshot snapshot_;
};

/// v_r, v_z [m/s] seen from the balloon's centre, gauge pressure [Pa], potential [m^2/s] at points (r, z) [m], z from
/// the centre, the orifice at negative z. Not a number outside the balloon and on the rim.
Array fields(const Flow& flow, const Array& r, const Array& z) {
  if (r.size() != z.size()) {
    throw InvalidInput("z", std::to_string(z.size()) + " values",
                       "has not as many values as r, " + std::to_string(r.size()), "give one z for each r");
  }
  const auto n = r.size();
  Array out(std::vector<py::ssize_t>{4, n});
  double* to = out.mutable_data();
  const double* radial = r.data();
  const double* axial = z.data();
  const py::gil_scoped_release unlocked;
  const FlowSnapshot& snapshot = flow.snapshot();
  const double radius = snapshot.state().radius;
  const double speed = snapshot.state().radial_rate;
  for (py::ssize_t i = 0; i < n; ++i) {
    const auto put = [&](double vr, double vz, double p, double potential) {
      to[i] = vr, to[n + i] = vz, to[2 * n + i] = p, to[3 * n + i] = potential;
    };
    const FlowPoint point{std::hypot(radial[i], axial[i]) / radius, std::atan2(radial[i], axial[i])};
    try {
      const FlowField f = snapshot.flow().at(point);
      const double sine = std::sin(point.theta);
      const double cosine = std::cos(point.theta);
      put(speed * (f.radial * sine + f.tangential * cosine), speed * (f.radial * cosine - f.tangential * sine),
          snapshot.pressure(point, f), speed * radius * f.potential);
    } catch (const InvalidInput&) {
      put(std::nan(""), std::nan(""), std::nan(""), std::nan(""));
    }
  }
  return out;
}

/// The columns of wall.csv.
Array wall(const Flow& flow) {
  std::vector<WallPoint> points;
  {
    const py::gil_scoped_release unlocked;
    points = wall_points(flow.snapshot());
  }
  Array out(std::vector<py::ssize_t>{6, static_cast<py::ssize_t>(points.size())});
  auto to = out.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < to.shape(1); ++i) {
    const WallPoint& p = points[static_cast<std::size_t>(i)];
    const std::array<double, 6> values{p.theta, p.way, p.distance, p.height, p.pressure, p.velocity};
    for (std::size_t k = 0; k < values.size(); ++k) to(static_cast<py::ssize_t>(k), i) = values[k];
  }
  return out;
}

std::shared_ptr<Flow> flow_at(const std::shared_ptr<Case>& c, double stretch, double rate, double time,
                              std::optional<double> acceleration, std::optional<double> pressure,
                              const std::string& profile) {
  return std::make_shared<Flow>(c, FlowInstant{stretch, rate, time, acceleration, pressure},
                                profile.empty() ? OutflowProfile::uniform() : read_profile(profile));
}

}  // namespace

void bind_flow(py::module_& module) {
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  py::class_<Flow, std::shared_ptr<Flow>>(module, "Flow")
      .def("fields", &fields)
      .def("wall", &wall)
      .def(
          "summary", [](const Flow& f) { return flow_summary(f.input(), f.snapshot()); }, unlocked)
      .def(
          "json",
          [](const Flow& f, int resolution) {
            return flow_json(f.input(), f.snapshot(), MeridionalFlow(f.snapshot().flow(), resolution));
          },
          unlocked)
      .def(
          "vtu",
          [](const Flow& f, int resolution) {
            return flow_vtu(f.snapshot(), MeridionalFlow(f.snapshot().flow(), resolution));
          },
          unlocked);
  module.def("flow", &flow_at, unlocked);
}

}  // namespace turgor::python
