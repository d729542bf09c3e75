#pragma once
// The libraries behind the finite elements, for as long as a program uses them.

#include <string>
#include <utility>
#include <vector>

namespace turgor {

/// Starts MPI and PETSc for this process alone, and ends them. Everything of PETSc must live within. Signals are left
/// to the program, and its arguments and ~/.petscrc are not read; the variable PETSC_OPTIONS is, for `-log_view` and
/// the like.
class FemSession {
 public:
  /// @throws ComputationFailed when PETSc cannot be started
  FemSession();
  ~FemSession();
  FemSession(const FemSession&) = delete;
  FemSession& operator=(const FemSession&) = delete;
  FemSession(FemSession&&) = delete;
  FemSession& operator=(FemSession&&) = delete;
};

/// Name and version of each library that has a say in the results.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> fem_versions();

}  // namespace turgor
