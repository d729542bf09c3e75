#include "turgor/fem/orifice_profile.hpp"

#include <algorithm>
#include <utility>

namespace turgor {

OrificeProfile::OrificeProfile(const FlowSpace& space, double orifice_radius) {
  std::vector<std::pair<double, std::size_t>> found;
  for (int i = 0; i < space.node_count(); ++i) {
    const auto [r, z] = space.nodes()[static_cast<std::size_t>(i)];
    if (z == 0 && r <= orifice_radius) found.emplace_back(r, static_cast<std::size_t>(space.velocity(i, 1)));
  }
  std::ranges::sort(found);
  for (const auto& [r, unknown] : found) {
    upsilon_.push_back(r / orifice_radius);
    axial_.push_back(unknown);
  }
  upsilon_.back() = 1;
  sums_.assign(axial_.size(), 0.0);
}

/// Quadratic through the edges' three nodes, 2 int f Upsilon dUpsilon: exact for what the elements can be.
void OrificeProfile::add(const std::vector<double>& solution, double weight) {
  double mean = 0;
  for (std::size_t i = 0; i + 2 < axial_.size(); i += 2) {
    const double h = (upsilon_[i + 2] - upsilon_[i]) / 6;
    mean += 2 * h *
            (upsilon_[i] * solution[axial_[i]] + 4 * upsilon_[i + 1] * solution[axial_[i + 1]] +
             upsilon_[i + 2] * solution[axial_[i + 2]]);
  }
  if (mean == 0) return;
  for (std::size_t i = 0; i < axial_.size(); ++i) sums_[i] += weight * solution[axial_[i]] / mean;
  weight_ += weight;
}

std::vector<OutflowPoint> OrificeProfile::mean() const {
  std::vector<OutflowPoint> points;
  if (weight_ == 0) return points;
  for (std::size_t i = 0; i < sums_.size(); ++i) points.push_back({upsilon_[i], sums_[i] / weight_});
  return points;
}

std::vector<double> OrificeProfile::sums() const {
  std::vector<double> all = sums_;
  all.push_back(weight_);
  return all;
}

void OrificeProfile::restore(const std::vector<double>& sums) {
  weight_ = sums.back();
  std::copy(sums.begin(), sums.end() - 1, sums_.begin());
}

}  // namespace turgor
