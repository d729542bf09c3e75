#include "turgor/run/fem_fields.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

InvalidInput unfit(const fs::path& file, std::string problem, std::string advice = "compute the run again") {
  return {"--fem", "\"" + file.string() + "\"", std::move(problem), std::move(advice)};
}

/// Calls a reader of files, and puts what it throws under the option that names the folder.
template <class Read>
auto read_from(const fs::path& file, const Read& read) {
  try {
    return read(file);
  } catch (const InvalidInput& error) {
    const Issue& issue = error.issues().front();
    throw unfit(file, issue.problem, issue.advice);
  }
}

/// Three components for each point.
std::vector<double> vectors(const VtuGrid& grid, const std::string& name, const fs::path& file) {
  const auto found = std::ranges::find(grid.data, name, &PointData::name);
  if (found == grid.data.end() || found->components != 3) throw unfit(file, "has no vectors \"" + name + "\"");
  return found->values;
}

using Place = std::array<double, 2>;
using Edge = std::array<std::size_t, 3>;  ///< a corner, the middle, the other corner

/// The edges that one cell alone has, by their middles.
std::map<std::size_t, Edge> boundary(const VtuGrid& grid) {
  std::map<std::size_t, Edge> edges;
  for (const auto& cell : grid.biquadratic) {
    const auto node = [&](std::size_t k) { return static_cast<std::size_t>(cell[k]); };
    for (std::size_t k = 0; k < 4; ++k) {
      const Edge edge{node(k), node(k + 4), node((k + 1) % 4)};
      if (!edges.emplace(edge[1], edge).second) edges.erase(edge[1]);
    }
  }
  return edges;
}

/// The nodes of the membrane from the pole to the rim: the boundary that at t = 0 lies above the orifice and off the
/// axis.
std::vector<std::size_t> membrane_nodes(const VtuGrid& grid, const std::vector<Place>& start, const fs::path& file) {
  constexpr double rounding = 1e-9;  // of the balloon's height
  const double height = std::ranges::max(start, {}, [](const Place& p) { return p[1]; })[1];
  const auto is_small = [&](double length) { return length <= rounding * height; };
  std::map<std::size_t, std::vector<Edge>> at;  // by corner
  std::size_t edges = 0;
  for (const auto& [middle, edge] : boundary(grid)) {
    if (is_small(start[middle][0]) || is_small(start[middle][1])) continue;
    at[edge[0]].push_back(edge);
    at[edge[2]].push_back({edge[2], edge[1], edge[0]});
    ++edges;
  }
  if (edges == 0) throw unfit(file, "has no wall");
  const auto pole = std::ranges::find_if(at, [&](const auto& corner) { return is_small(start[corner.first][0]); });
  const auto broken = [&] { return unfit(file, "has a wall that is not one line from the axis to the orifice"); };
  if (pole == at.end()) throw broken();
  std::vector<std::size_t> nodes{pole->first};
  for (; edges > 0; --edges) {
    const std::vector<Edge>& here = at[nodes.back()];
    const auto next = std::ranges::find_if(
        here, [&](const Edge& edge) { return nodes.size() == 1 || edge[1] != nodes[nodes.size() - 2]; });
    if (next == here.end()) throw broken();
    nodes.insert(nodes.end(), {(*next)[1], (*next)[2]});
  }
  return nodes;
}

}  // namespace

FemFields::FemFields(fs::path folder) : folder_(std::move(folder)) {
  const fs::path file = folder_ / "fields.pvd";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw unfit(folder_, "has no fields.pvd", "name a run of `turgor fem`");
  series_ = read_from(file, read_pvd);
  if (series_.empty()) throw unfit(file, "lists no fields", "compute the run with fem.fields greater than 0");
  for (std::size_t i = 1; i < series_.size(); ++i) {
    if (series_[i].time > series_[i - 1].time) continue;
    throw unfit(file, "t = " + shortest(series_[i].time) + " s does not come after the field before");
  }
}

FemField FemFields::read(std::size_t i) const {
  const fs::path file = folder_ / series_[i].file;
  FemField field{series_[i].time, read_from(file, read_vtu), {}, {}, {}};
  if (field.grid.biquadratic.empty() || !field.grid.quadrilaterals.empty()) {
    throw unfit(file, "has not cells of nine points alone");
  }
  field.velocity = vectors(field.grid, "velocity", file);
  const std::vector<double> displacement = vectors(field.grid, "displacement", file);
  std::vector<Place> start;
  for (std::size_t k = 0; k < displacement.size(); k += 3) {
    if (field.grid.points[k] < 0) throw unfit(file, "has points on the far side of the axis");
    start.push_back({field.grid.points[k] - displacement[k], field.grid.points[k + 1] - displacement[k + 1]});
  }
  for (const std::size_t node : membrane_nodes(field.grid, start, file)) {
    field.membrane.push_back({field.grid.points[3 * node], field.grid.points[3 * node + 1]});
    field.membrane_at_start.push_back(start[node]);
  }
  return field;
}

}  // namespace turgor
