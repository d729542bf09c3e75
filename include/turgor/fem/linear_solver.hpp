#pragma once
// Sparse linear systems: GMRES, preconditioned by a factorisation that may be of an earlier matrix.

#include <memory>
#include <vector>

namespace turgor {

/// Rows of a sparse matrix, columns ascending within a row.
struct SparsePattern {
  std::vector<int> row_start;  ///< size + 1 entries
  std::vector<int> columns;
  [[nodiscard]] int size() const { return static_cast<int>(row_start.size()) - 1; }
  /// Where the entry (row, column) is kept.
  /// @pre it is one of the pattern's
  [[nodiscard]] int find(int row, int column) const;
};

/// How a linear system was solved.
struct LinearReport {
  int iterations = 0;
  int factorizations = 0;
  double residual = 0;  ///< |b - A x| / |b|, of the true residual
};

/// A sparse matrix with a pattern that stays, and the solution of systems with it. MUMPS factorises, UMFPACK where
/// MUMPS fails; the factors are kept while the matrix changes, as long as the iterations of GMRES cost less than new
/// ones. Lives within a FemSession.
class LinearSolver {
 public:
  explicit LinearSolver(SparsePattern pattern);
  ~LinearSolver();
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  LinearSolver(LinearSolver&&) = delete;
  LinearSolver& operator=(LinearSolver&&) = delete;

  [[nodiscard]] const SparsePattern& pattern() const { return pattern_; }
  /// Entries of the matrix, in the pattern's order.
  [[nodiscard]] std::vector<double>& values() { return values_; }

  /// Solves A x = b up to |b - A x| <= tolerance |b|.
  /// @throws ComputationFailed when that is not reached with a new factorisation either
  LinearReport solve(const std::vector<double>& b, std::vector<double>& x, double tolerance);

  /// Factorisations by MUMPS that served nothing, so far.
  [[nodiscard]] long failures() const { return failures_; }

  /// The factors are good for few more systems: the next solution begins with new ones.
  void discard_factors();

 private:
  struct Petsc;
  enum class Package { mumps, umfpack };
  void prepare(Package package);
  double attempt(const std::vector<double>& b, std::vector<double>& x, double residual, LinearReport& report);
  void book(int iterations, bool fresh);

  SparsePattern pattern_;
  std::vector<double> values_;
  std::unique_ptr<Petsc> petsc_;
  bool factorized_ = false;
  Package package_ = Package::mumps;
  double cost_ = 0;  ///< of the factors and what was solved with them, in iterations
  int solutions_ = 0;
  long failures_ = 0;
};

}  // namespace turgor
