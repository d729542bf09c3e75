#include "turgor/fem/linear_solver.hpp"

#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "turgor/base/errors.hpp"

namespace turgor {

namespace {

void check(PetscErrorCode code, const char* what) {
  if (code != 0)
    throw ComputationFailed(std::string("PETSc failed to ") + what + " (error " + std::to_string(code) + ")");
}

constexpr int mumps_ordering = 7;
constexpr int approximate_minimum_degree = 0;  // its own choice takes seconds to order these matrices
constexpr int mumps_workspace = 14;
constexpr int workspace_percent = 80;
constexpr int most_iterations = 60;
/// What a factorisation costs, in iterations, of matrices between 1e4 and 1e5 rows.
constexpr double factorization_cost = 10;

}  // namespace

int SparsePattern::find(int row, int column) const {
  const auto begin = columns.begin() + row_start[static_cast<std::size_t>(row)];
  const auto end = columns.begin() + row_start[static_cast<std::size_t>(row) + 1];
  return static_cast<int>(std::lower_bound(begin, end, column) - columns.begin());
}

struct LinearSolver::Petsc {
  Mat matrix = nullptr;
  KSP ksp = nullptr;
  Vec b = nullptr;
  Vec x = nullptr;
  Petsc() = default;
  Petsc(const Petsc&) = delete;
  Petsc& operator=(const Petsc&) = delete;
  Petsc(Petsc&&) = delete;
  Petsc& operator=(Petsc&&) = delete;
  ~Petsc() {
    KSPDestroy(&ksp);
    MatDestroy(&matrix);
    VecDestroy(&b);
    VecDestroy(&x);
  }
};

LinearSolver::LinearSolver(SparsePattern pattern)
    : pattern_(std::move(pattern)), values_(pattern_.columns.size(), 0.0), petsc_(std::make_unique<Petsc>()) {
  const int n = pattern_.size();
  Petsc& p = *petsc_;
  check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, pattern_.row_start.data(), pattern_.columns.data(),
                                  values_.data(), &p.matrix),
        "make a matrix");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, nullptr, &p.b), "make a vector");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, nullptr, &p.x), "make a vector");
  prepare(Package::mumps);
}

void LinearSolver::prepare(Package package) {
  package_ = package;
  Petsc& p = *petsc_;
  KSPDestroy(&p.ksp);
  check(KSPCreate(PETSC_COMM_SELF, &p.ksp), "make a solver");
  check(KSPSetType(p.ksp, KSPGMRES), "choose GMRES");
  check(KSPGMRESSetRestart(p.ksp, most_iterations), "set the restart");
  check(KSPSetPCSide(p.ksp, PC_RIGHT), "precondition from the right");  // so that it sees the true residual
  check(KSPSetInitialGuessNonzero(p.ksp, PETSC_FALSE), "start from zero");
  PC pc = nullptr;
  check(KSPGetPC(p.ksp, &pc), "find the preconditioner");
  check(PCSetType(pc, PCLU), "choose factorisation");
  const bool mumps = package == Package::mumps;
  check(PCFactorSetMatSolverType(pc, mumps ? MATSOLVERMUMPS : MATSOLVERUMFPACK), "choose who factorises");
  check(KSPSetOperators(p.ksp, p.matrix, p.matrix), "set the matrix");
  factorized_ = false;
  if (!mumps) return;
  check(PCFactorSetUpMatSolverType(pc), "prepare MUMPS");
  Mat factors = nullptr;
  check(PCFactorGetMatrix(pc, &factors), "find the factors");
  check(MatMumpsSetIcntl(factors, mumps_ordering, approximate_minimum_degree), "set MUMPS's ordering");
  check(MatMumpsSetIcntl(factors, mumps_workspace, workspace_percent), "set MUMPS's workspace");
}

LinearSolver::~LinearSolver() = default;

void LinearSolver::discard_factors() { factorized_ = false; }

LinearReport LinearSolver::solve(const std::vector<double>& b, std::vector<double>& x, double tolerance) {
  LinearReport report;
  double size = 0;
  for (const double v : b) size += v * v;
  size = std::sqrt(size);
  if (!std::isfinite(size)) throw ComputationFailed("the right-hand side of a linear system is not finite");
  x.assign(b.size(), 0.0);
  if (size == 0) return report;
  const Petsc& p = *petsc_;
  check(MatAssemblyBegin(p.matrix, MAT_FINAL_ASSEMBLY), "take the matrix");
  check(MatAssemblyEnd(p.matrix, MAT_FINAL_ASSEMBLY), "take the matrix");
  const auto solved = [&] {
    const double reached = attempt(b, x, tolerance * size, report);
    report.residual = reached / size;
    return reached <= tolerance * size;
  };
  if (factorized_ && solved()) return report;
  if (package_ != Package::mumps) prepare(Package::mumps);
  if (solved()) return report;
  ++failures_;
  prepare(Package::umfpack);  // also because PETSc remembers factors that failed
  if (solved()) return report;
  throw ComputationFailed(
      "a linear system could not be solved: GMRES with new factorisations by MUMPS and by UMFPACK left a relative "
      "residual of " +
      std::to_string(report.residual));
}

/// With the factors that there are, or with new ones; without success they are good for nothing more.
/// @param residual  wanted, absolute
/// @return what was reached; infinite where a factorisation failed
double LinearSolver::attempt(const std::vector<double>& b, std::vector<double>& x, double residual,
                             LinearReport& report) {
  const Petsc& p = *petsc_;
  const bool fresh = !factorized_;
  check(KSPSetTolerances(p.ksp, 0.0, residual, 1e5, most_iterations), "set the tolerance");
  check(KSPSetReusePreconditioner(p.ksp, fresh ? PETSC_FALSE : PETSC_TRUE), "keep the factors");
  report.factorizations += fresh ? 1 : 0;
  std::ranges::fill(x, 0.0);
  check(VecPlaceArray(p.b, b.data()), "place a vector");
  check(VecPlaceArray(p.x, x.data()), "place a vector");
  const PetscErrorCode code = KSPSolve(p.ksp, p.b, p.x);
  check(VecResetArray(p.b), "take back a vector");
  check(VecResetArray(p.x), "take back a vector");
  KSPConvergedReason reason{};
  PetscInt iterations = 0;
  PetscReal reached = 0;
  check(KSPGetConvergedReason(p.ksp, &reason), "say how it went");
  check(KSPGetIterationNumber(p.ksp, &iterations), "count iterations");
  check(KSPGetResidualNorm(p.ksp, &reached), "say the residual");
  report.iterations += iterations;
  factorized_ = code == 0 && reason > 0;
  if (!factorized_) return code == 0 && reason == KSP_DIVERGED_ITS ? reached : std::numeric_limits<double>::infinity();
  book(iterations, fresh);
  return reached;
}

/// The mean cost of a solution is least where the next one costs as much: then the factors have served.
void LinearSolver::book(int iterations, bool fresh) {
  if (fresh) {
    cost_ = factorization_cost;
    solutions_ = 0;
  }
  cost_ += iterations;
  solutions_ += 1;
  if (iterations > cost_ / solutions_) factorized_ = false;
}

}  // namespace turgor
