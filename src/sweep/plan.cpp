#include "turgor/sweep/plan.hpp"

#include <math.h>  // NOLINT: Boost 1.74 calls isnan without naming its namespace

#include <Random123/philox.h>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

Node node_of(const Axis& axis, double value) {
  if (axis.unit == "1") return Node{value, "", 0};
  return Node{Node::Quantity{value, axis.unit}, "", 0};
}

double between(const AxisRange& range, double share) {
  if (range.logarithmic) return range.from * std::pow(range.to / range.from, share);
  return range.from + (range.to - range.from) * share;
}

/// What random bits are used for; part of the counter, so that no bits are used twice.
enum class Purpose : std::uint64_t { shuffle, jitter, shift };

/// Random bits that follow from seed, axis, purpose and a number: the counter-based generator Philox.
std::uint64_t random_bits(std::uint64_t seed, std::size_t axis, Purpose purpose, std::uint64_t number) {
  const std::uint64_t stream = 4 * static_cast<std::uint64_t>(axis) + static_cast<std::uint64_t>(purpose);
  return r123::Philox2x64()(r123::Philox2x64::ctr_type{{number, stream}}, r123::Philox2x64::key_type{{seed}})[0];
}

/// The middle of one of 2^52 equal parts of (0, 1): never an end, and exact.
double unit_from(std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 12) + 0.5, -52); }

/// A permutation of 0..size - 1: Fisher and Yates' shuffle, from the last element down.
std::vector<std::uint32_t> permutation(std::uint64_t size, std::uint64_t seed, std::size_t axis) {
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0U);
  for (std::uint64_t i = size; i > 1; --i) {
    const double u = unit_from(random_bits(seed, axis, Purpose::shuffle, i));
    std::swap(order[i - 1], order[static_cast<std::size_t>(u * static_cast<double>(i))]);
  }
  return order;
}

}  // namespace

std::vector<Node> grid_values(const Axis& axis) {
  if (const auto* list = std::get_if<AxisValues>(&axis.form)) return list->values;
  const auto& range = std::get<AxisRange>(axis.form);
  std::vector<Node> values;
  values.reserve(range.count);
  for (std::uint64_t k = 0; k < range.count; ++k) {
    const bool last = k > 0 && k + 1 == range.count;
    const double share = k == 0 ? 0 : static_cast<double>(k) / static_cast<double>(range.count - 1);
    values.push_back(node_of(axis, last ? range.to : between(range, share)));
  }
  return values;
}

double quantile_of(const Axis& axis, double u) {
  if (const auto* normal = std::get_if<NormalAxis>(&axis.form)) {
    return quantile(boost::math::normal(normal->mean, normal->sigma), u);
  }
  if (const auto* lognormal = std::get_if<LognormalAxis>(&axis.form)) {
    return quantile(boost::math::lognormal(std::log(lognormal->median), lognormal->sigma), u);
  }
  return between(std::get<AxisRange>(axis.form), u);
}

SweepPlan::SweepPlan(SweepSettings settings) : settings_(std::move(settings)) {
  const std::size_t axes = settings_.axes.size();
  if (settings_.sampler == Sampler::grid) {
    for (const Axis& axis : settings_.axes) grid_.push_back(grid_values(axis));
  } else if (settings_.sampler == Sampler::sobol) {
    sobol_.emplace(axes);
  } else {
    constexpr double most = 250e6;
    const double numbers = static_cast<double>(settings_.members) * static_cast<double>(axes);
    if (numbers > most) {
      throw InvalidInput("sweep.members", std::to_string(settings_.members),
                         "a latin hypercube keeps a permutation for each axis in memory, which would be " +
                             rounded(4e-9 * numbers) + " GB",
                         "reduce members, or use sampler = \"sobol\", which keeps nothing");
    }
    Permutations strata;
    for (std::size_t a = 0; a < axes; ++a) strata.push_back(permutation(settings_.members, settings_.seed, a));
    strata_ = std::make_shared<const Permutations>(std::move(strata));
  }
}

std::vector<std::uint64_t> SweepPlan::indices(std::uint64_t member) const {
  std::vector<std::uint64_t> at(grid_.size());
  for (std::size_t a = grid_.size(); a-- > 0;) {
    at[a] = member % grid_[a].size();
    member /= grid_[a].size();
  }
  return at;
}

std::vector<Node> SweepPlan::values(std::uint64_t member) {
  std::vector<Node> values;
  values.reserve(settings_.axes.size());
  if (settings_.sampler == Sampler::grid) {
    const auto at = indices(member);
    for (std::size_t a = 0; a < at.size(); ++a) values.push_back(grid_[a][at[a]]);
    return values;
  }
  const std::vector<double> u = point(member);
  for (std::size_t a = 0; a < u.size(); ++a) {
    values.push_back(node_of(settings_.axes[a], quantile_of(settings_.axes[a], u[a])));
  }
  return values;
}

std::vector<double> SweepPlan::point(std::uint64_t member) {
  std::vector<double> u(settings_.axes.size());
  if (sobol_) sobol_->seed(member);
  for (std::size_t a = 0; a < u.size(); ++a) {
    if (sobol_) {
      const std::uint64_t shift = settings_.seed == 0 ? 0 : random_bits(settings_.seed, a, Purpose::shift, 0);
      u[a] = unit_from((*sobol_)() ^ shift);
    } else {
      const double jitter = unit_from(random_bits(settings_.seed, a, Purpose::jitter, member));
      u[a] = ((*strata_)[a][member] + jitter) / static_cast<double>(settings_.members);
    }
  }
  return u;
}

}  // namespace turgor
