#include "turgor/fem/session.hpp"

#include <deal.II/base/config.h>
#include <deal.II/base/multithread_info.h>
#include <dmumps_c.h>
#include <petscsys.h>

#include <array>
#include <cstdlib>

#include "turgor/base/errors.hpp"

namespace turgor {

namespace {
std::string with_points(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}
}  // namespace

FemSession::FemSession() {
  static std::array<std::string, 3> words{"turgor-fem", "-skip_petscrc", "-no_signal_handler"};
  static std::array<char*, 4> pointers{words[0].data(), words[1].data(), words[2].data(), nullptr};
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);  // one process alone needs no daemon beside it
  int count = static_cast<int>(words.size());
  char** arguments = pointers.data();
  if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0) throw ComputationFailed("PETSc cannot be started");
  PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);  // errors become exceptions, without its own report
  dealii::MultithreadInfo::set_thread_limit(1);             // sums in the same order in every run
}

FemSession::~FemSession() { PetscFinalize(); }

std::vector<std::pair<std::string, std::string>> fem_versions() {
  return {{"deal.II", DEAL_II_PACKAGE_VERSION},
          {"PETSc", with_points(PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"MUMPS", MUMPS_VERSION}};
}

}  // namespace turgor
