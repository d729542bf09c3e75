// Sparse systems by MUMPS, and by GMRES with factors of an earlier matrix.

#include "turgor/fem/linear_solver.hpp"

#include <gtest/gtest.h>
#include <petscsys.h>

#include <cmath>

#include "../support/fem.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {
namespace {

constexpr int size = 400;

/// Rows with the diagonal, its neighbours and a far column.
SparsePattern pattern() {
  SparsePattern p;
  p.row_start.push_back(0);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      if (std::abs(i - j) <= 1 || j == (i + size / 2) % size) p.columns.push_back(j);
    }
    p.row_start.push_back(static_cast<int>(p.columns.size()));
  }
  return p;
}

/// An unsymmetric matrix without zeros on the diagonal; `turn` changes all of it.
void fill(LinearSolver& solver, double turn) {
  for (std::size_t k = 0; k < solver.values().size(); ++k)
    solver.values()[k] = std::sin(1.0 + 3.7 * static_cast<double>(k) + turn);
  for (int i = 0; i < size; ++i) solver.values()[static_cast<std::size_t>(solver.pattern().find(i, i))] += 3;
}

double residual(LinearSolver& solver, const std::vector<double>& b, const std::vector<double>& x) {
  double off = 0;
  double all = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    double row = b[i];
    for (int k = solver.pattern().row_start[i]; k < solver.pattern().row_start[i + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      row -= solver.values()[at] * x[static_cast<std::size_t>(solver.pattern().columns[at])];
    }
    off += row * row;
    all += b[i] * b[i];
  }
  return std::sqrt(off / all);
}

std::vector<double> right_hand_side() {
  std::vector<double> b;
  for (int i = 0; i < size; ++i) b.push_back(std::cos(0.3 * i));
  return b;
}

TEST(LinearSolver, SolvesAndKeepsItsFactorsWhileTheyServe) {
  LinearSolver solver(pattern());
  const std::vector<double> b = right_hand_side();
  std::vector<double> x;
  fill(solver, 0);
  const LinearReport first = solver.solve(b, x, 1e-10);
  EXPECT_EQ(first.factorizations, 1);
  EXPECT_LE(first.iterations, 2);
  EXPECT_LT(residual(solver, b, x), 2e-10);
  fill(solver, 0.01);
  const LinearReport second = solver.solve(b, x, 1e-10);
  EXPECT_EQ(second.factorizations, 0);
  EXPECT_GT(second.iterations, 1);
  EXPECT_LT(residual(solver, b, x), 2e-10);
  EXPECT_NEAR(second.residual, residual(solver, b, x), 1e-12);
  solver.discard_factors();
  EXPECT_EQ(solver.solve(b, x, 1e-10).factorizations, 1);
}

TEST(LinearSolver, FactorizesAnewWhenTheMatrixIsAnotherOne) {
  LinearSolver solver(pattern());
  const std::vector<double> b = right_hand_side();
  std::vector<double> x;
  fill(solver, 0);
  (void)solver.solve(b, x, 1e-10);
  fill(solver, 2);
  (void)solver.solve(b, x, 1e-10);  // slow, or with new factors already
  fill(solver, 2);
  EXPECT_LE(solver.solve(b, x, 1e-10).iterations, 2);
  EXPECT_LT(residual(solver, b, x), 2e-10);
}

TEST(LinearSolver, SaysWhenThereIsNoSolution) {
  LinearSolver solver(pattern());
  std::vector<double> x;
  EXPECT_THROW((void)solver.solve(right_hand_side(), x, 1e-10), ComputationFailed);  // the zero matrix
  fill(solver, 0);
  EXPECT_LT(solver.solve(right_hand_side(), x, 1e-10).residual, 1e-10);  // and goes on
  EXPECT_THROW((void)solver.solve(std::vector<double>(size, std::nan("")), x, 1e-10), ComputationFailed);
}

/// The five-point Laplacian of a square with `side` points each way.
LinearSolver laplacian(int side) {
  SparsePattern p;
  p.row_start.push_back(0);
  for (int i = 0; i < side * side; ++i) {
    for (const int j : {i - side, i % side > 0 ? i - 1 : -1, i, i % side + 1 < side ? i + 1 : -1, i + side}) {
      if (j >= 0 && j < side * side) p.columns.push_back(j);
    }
    p.row_start.push_back(static_cast<int>(p.columns.size()));
  }
  return LinearSolver(std::move(p));
}

TEST(LinearSolver, AnotherPackageFactorizesWhereMumpsCannot) {
  // one megabyte for the factors of 40000 rows, which take about ten
  ASSERT_EQ(PetscOptionsSetValue(nullptr, "-mat_mumps_icntl_23", "1"), 0);
  constexpr int side = 200;
  LinearSolver solver = laplacian(side);
  const auto& pattern = solver.pattern();
  for (std::size_t i = 0; i < side * side; ++i) {
    for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      solver.values()[at] = static_cast<std::size_t>(pattern.columns[at]) == i ? 4 : -1;
    }
  }
  const std::vector<double> b(side * side, 1.0);
  std::vector<double> x;
  (void)solver.solve(b, x, 1e-10);
  ASSERT_EQ(PetscOptionsClearValue(nullptr, "-mat_mumps_icntl_23"), 0);
  EXPECT_EQ(solver.failures(), 1);
  EXPECT_LT(residual(solver, b, x), 2e-10);
  EXPECT_EQ(solver.solve(b, x, 1e-10).factorizations, 0);  // whose factors are kept as well
  solver.discard_factors();
  (void)solver.solve(b, x, 1e-10);  // MUMPS is asked again, and can
  EXPECT_EQ(solver.failures(), 1);
  EXPECT_LT(residual(solver, b, x), 2e-10);
}

TEST(LinearSolver, NothingComesOutOfNothing) {
  LinearSolver solver(pattern());
  std::vector<double> x;
  fill(solver, 0);
  EXPECT_EQ(solver.solve(std::vector<double>(size, 0.0), x, 1e-10).iterations, 0);
  EXPECT_EQ(x, std::vector<double>(size, 0.0));
}

}  // namespace
}  // namespace turgor
