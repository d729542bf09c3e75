#include "turgor/fem/flow_solver.hpp"

#include "turgor/base/errors.hpp"

namespace turgor {

std::unique_ptr<FlowProblem> make_flow_problem(const Case& c) {
  throw ComputationFailed("this build has no solver for \"" + c.title + "\"");
}

}  // namespace turgor
