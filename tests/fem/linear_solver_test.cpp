// The libraries themselves: assembly by deal.II, solution by PETSc and MUMPS.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/petsc_vector.h>
#include <deal.II/numerics/vector_tools.h>
#include <gtest/gtest.h>
#include <petscksp.h>

#include "../support/fem.hpp"

namespace turgor {
namespace {

using namespace dealii;

/// u = (y (1 - y), 0), p = 2 (1 - x) on the unit square, viscosity 1.
class Poiseuille : public Function<2> {
 public:
  Poiseuille() : Function<2>(3) {}
  [[nodiscard]] double value(const Point<2>& at, unsigned component) const override {
    if (component == 0) return at[1] * (1 - at[1]);
    return component == 1 ? 0 : 2 * (1 - at[0]);
  }
};

/// Stokes flow by Q2/Q1 elements with the velocity of Poiseuille on all sides, and its pressure in one corner.
class StokesSquare {
 public:
  StokesSquare() : element_(FE_Q<2>(2), 2, FE_Q<2>(1), 1), handler_(mesh_) {
    GridGenerator::hyper_cube(mesh_);
    mesh_.refine_global(3);
    handler_.distribute_dofs(element_);
    const ComponentMask velocity(std::vector<bool>{true, true, false});
    VectorTools::interpolate_boundary_values(handler_, 0, exact_, boundary_, velocity);
    fix_pressure();
    boundary_.close();
    DynamicSparsityPattern pattern(handler_.n_dofs());
    DoFTools::make_sparsity_pattern(handler_, pattern, boundary_, true);
    matrix.reinit(pattern);
    right = PETScWrappers::MPI::Vector(PETSC_COMM_SELF, handler_.n_dofs(), handler_.n_dofs());
    assemble();
  }

  /// Greatest nodal error of velocity and pressure.
  [[nodiscard]] double error(PETScWrappers::MPI::Vector& solution) const {
    boundary_.distribute(solution);
    PETScWrappers::MPI::Vector nodal(solution);
    VectorTools::interpolate(handler_, exact_, nodal);
    nodal -= solution;
    return nodal.linfty_norm();
  }

  PETScWrappers::SparseMatrix matrix;
  PETScWrappers::MPI::Vector right;

 private:
  /// The pressure at the vertex (1, 1) is zero.
  void fix_pressure() {
    for (const auto& cell : handler_.active_cell_iterators()) {
      if (cell->vertex(3).distance(Point<2>(1, 1)) > 1e-12) continue;
      boundary_.add_line(cell->vertex_dof_index(3, 2));
    }
  }

  void assemble() {
    const QGauss<2> rule(3);
    FEValues<2> values(element_, rule, update_values | update_gradients | update_JxW_values);
    const FEValuesExtractors::Vector u(0);
    const FEValuesExtractors::Scalar p(2);
    const unsigned n = element_.n_dofs_per_cell();
    FullMatrix<double> local(n, n);
    const Vector<double> force(n);
    std::vector<types::global_dof_index> dofs(n);
    for (const auto& cell : handler_.active_cell_iterators()) {
      values.reinit(cell);
      local = 0;
      for (const unsigned q : values.quadrature_point_indices()) {
        for (const unsigned i : values.dof_indices()) {
          for (const unsigned j : values.dof_indices()) {
            local(i, j) += (scalar_product(values[u].gradient(i, q), values[u].gradient(j, q)) -
                            values[u].divergence(i, q) * values[p].value(j, q) -
                            values[p].value(i, q) * values[u].divergence(j, q)) *
                           values.JxW(q);
          }
        }
      }
      cell->get_dof_indices(dofs);
      boundary_.distribute_local_to_global(local, force, dofs, matrix, right);
    }
    matrix.compress(VectorOperation::add);
    right.compress(VectorOperation::add);
  }

  Poiseuille exact_;
  Triangulation<2> mesh_;
  FESystem<2> element_;
  DoFHandler<2> handler_;
  AffineConstraints<double> boundary_;
};

void solve_by_mumps(Mat matrix, Vec right, Vec solution) {
  KSP solver = nullptr;
  PC factors = nullptr;
  ASSERT_EQ(KSPCreate(PETSC_COMM_SELF, &solver), 0);
  ASSERT_EQ(KSPSetOperators(solver, matrix, matrix), 0);
  ASSERT_EQ(KSPSetType(solver, KSPPREONLY), 0);
  ASSERT_EQ(KSPGetPC(solver, &factors), 0);
  ASSERT_EQ(PCSetType(factors, PCLU), 0);
  ASSERT_EQ(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS), 0);
  ASSERT_EQ(KSPSolve(solver, right, solution), 0);
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  KSPGetConvergedReason(solver, &reason);
  EXPECT_GT(reason, 0);
  KSPDestroy(&solver);
}

// Quadratic velocity and linear pressure lie in the spaces, so that only rounding is left: the saddle point's condition
// of about 1e4 times 1e-16.
TEST(LinearSolver, MumpsSolvesASaddlePoint) {
  StokesSquare square;
  PETScWrappers::MPI::Vector solution(square.right);
  solve_by_mumps(square.matrix, square.right, solution);
  PETScWrappers::MPI::Vector residual(square.right);
  EXPECT_LT(square.matrix.residual(residual, solution, square.right), 1e-12 * square.right.l2_norm());
  EXPECT_LT(square.error(solution), 1e-11);
}

}  // namespace
}  // namespace turgor
