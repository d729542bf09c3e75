#include "turgor/material/tabulated.hpp"

#include <Eigen/SparseLU>
#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace {

constexpr const char* stretch_key = "material.table.stretch";
constexpr const char* stress_key = "material.table.stress";

std::string key_of(const char* list, std::size_t index) { return list + ("[" + std::to_string(index) + "]"); }

template <class T>
std::string text_of(const T& number) {
  return shortest(static_cast<double>(number));
}

template <class T>
void check(const std::vector<T>& stretch, const std::vector<T>& stress) {
  constexpr std::size_t least = 4;
  if (stretch.size() != stress.size()) {
    throw InvalidInput(stress_key, "",
                       "has " + std::to_string(stress.size()) + " values where material.table.stretch has " +
                           std::to_string(stretch.size()),
                       "give one stress for each stretch");
  }
  if (stretch.size() < least) {
    throw InvalidInput(stretch_key, "", "has " + std::to_string(stretch.size()) + " points",
                       "a cubic needs at least four");
  }
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    if (!std::isfinite(stretch[i]) || !(stretch[i] > T(0))) {
      throw InvalidInput(key_of(stretch_key, i), text_of(stretch[i]), "is no stretch",
                         "must be > 0, 1 when unstretched");
    }
    if (!std::isfinite(stress[i])) {
      throw InvalidInput(key_of(stress_key, i), text_of(stress[i]), "not a finite number");
    }
    if (i > 0 && !(stretch[i] > stretch[i - 1])) {
      throw InvalidInput(key_of(stretch_key, i), text_of(stretch[i]),
                         "is not above " + text_of(stretch[i - 1]) + ", the stretch before",
                         "stretches must increase strictly: sort the points, and average those of the same stretch");
    }
  }
}

/// The index of stretch 1, after checking that the wall is unstretched there.
template <class T>
std::size_t unstretched(const std::vector<T>& stretch, const std::vector<T>& stress) {
  const auto one = static_cast<std::size_t>(std::ranges::find(stretch, T(1)) - stretch.begin());
  if (one == stretch.size()) {
    throw InvalidInput(stretch_key, "", "has no point at stretch 1, where the wall is unstretched",
                       "add it, with stress 0; a stretch is a length over the unstretched one, not a strain");
  }
  if (stress[one] != T(0)) {
    throw InvalidInput(key_of(stress_key, one), text_of(stress[one]) + " Pa",
                       "is the stress at stretch 1, which must be 0",
                       "subtract from all stresses what the measurement began with, or measure stretches from where "
                       "the stress is 0");
  }
  if (one + 1 == stretch.size()) {
    throw InvalidInput(stretch_key, "", "ends at stretch 1", "balloons need the stress above it");
  }
  return one;
}

/// Second derivatives of the spline at its points.
template <class T>
std::vector<T> curvatures(const std::vector<T>& x, const std::vector<T>& y) {
  const std::size_t n = x.size();
  std::vector<Eigen::Triplet<T, Eigen::Index>> entries;
  Eigen::Matrix<T, Eigen::Dynamic, 1> right = Eigen::Matrix<T, Eigen::Dynamic, 1>::Zero(static_cast<Eigen::Index>(n));
  const auto add = [&](std::size_t row, std::size_t column, const T& value) {
    entries.emplace_back(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column), value);
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const T before = x[i] - x[i - 1];
    const T after = x[i + 1] - x[i];
    const T both = x[i + 1] - x[i - 1];
    // The slope is continuous ...
    add(i, i - 1, before / both);
    add(i, i, T(2));
    add(i, i + 1, after / both);
    right(static_cast<Eigen::Index>(i)) = 6 * ((y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before) / both;
    // ... and so is the third derivative at the last points but one.
    for (const std::size_t row : {std::size_t{0}, n - 1}) {
      if (i != (row == 0 ? 1 : n - 2)) continue;
      add(row, i - 1, after / both);
      add(row, i, T(-1));
      add(row, i + 1, before / both);
    }
  }
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::SparseMatrix<T> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<T>> solver(matrix);
  const Eigen::Matrix<T, Eigen::Dynamic, 1> solution = solver.solve(right);
  return {solution.begin(), solution.end()};
}

}  // namespace

template <class T>
StressTable<T>::StressTable(std::vector<T> stretch, const std::vector<T>& stress) : stretch_(std::move(stretch)) {
  check(stretch_, stress);
  const std::size_t one = unstretched(stretch_, stress);
  const std::vector<T> second = curvatures(stretch_, stress);
  const std::size_t last = stretch_.size() - 1;
  std::vector<T> slope(last + 1);
  std::vector<T> third(last);  // a sixth of it
  std::vector<T> energy(last + 1, T(0));
  for (std::size_t i = 0; i < last; ++i) {
    const T h = stretch_[i + 1] - stretch_[i];
    const T rise = (stress[i + 1] - stress[i]) / h;
    slope[i] = rise - h * (2 * second[i] + second[i + 1]) / 6;
    slope[i + 1] = rise + h * (second[i] + 2 * second[i + 1]) / 6;
    third[i] = (second[i + 1] - second[i]) / (6 * h);
    energy[i + 1] = energy[i] + h * ((stress[i] + stress[i + 1]) / 2 - h * h * (second[i] + second[i + 1]) / 24);
  }
  const T at_rest = energy[one];
  const auto piece = [&](std::size_t i, const T& half_second, const T& sixth_third) {
    return Piece{stretch_[i], energy[i] - at_rest, {stress[i], slope[i], half_second, sixth_third}};
  };
  pieces_.push_back(piece(0, T(0), T(0)));
  for (std::size_t i = 0; i < last; ++i) {
    const std::size_t about = i < one ? i + 1 : i;
    pieces_.push_back(piece(about, second[about] / 2, third[i]));
  }
  pieces_.push_back(piece(last, T(0), T(0)));
  for (const Piece& p : pieces_) {
    if (std::isfinite(p.energy + p.stress[0] + p.stress[1] + p.stress[2] + p.stress[3])) continue;
    throw InvalidInput(stress_key, "", "changes more than numbers can hold near stretch " + text_of(p.about),
                       "move its points apart");
  }
}

template class StressTable<double>;
template class StressTable<long double>;

}  // namespace turgor
