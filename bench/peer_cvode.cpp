#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <stdexcept>

#include "peers.hpp"

namespace turgor::bench {

namespace {

using Flow = PeerFlow;

int rate(realtype t, N_Vector y, N_Vector rates, void* data) {
  const auto& flow = **static_cast<const Flow**>(data);
  const Flow::State result = flow.rate(t, {NV_Ith_S(y, 0), NV_Ith_S(y, 1)});
  NV_Ith_S(rates, 0) = result[0];
  NV_Ith_S(rates, 1) = result[1];
  return std::isfinite(result[1]) ? 0 : 1;
}

int jacobian(realtype t, N_Vector y, N_Vector /*rates*/, SUNMatrix matrix, void* data, N_Vector /*a*/, N_Vector /*b*/,
             N_Vector /*c*/) {
  const auto& flow = **static_cast<const Flow**>(data);
  const auto at = flow.linearize(t, {NV_Ith_S(y, 0), NV_Ith_S(y, 1)});
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) SM_ELEMENT_D(matrix, i, j) = at.jacobian(i, j);
  }
  return 0;
}

int rate_of_stretch(realtype /*t*/, N_Vector y, realtype* value, void* /*data*/) {
  *value = NV_Ith_S(y, 1);
  return 0;
}

void check(int code) {
  if (code < 0) throw std::runtime_error("CVODE fails with code " + std::to_string(code));
}

/// CVODE's objects for one run.
class Cvode {
 public:
  Cvode(int method, double tolerance) {
    check(SUNContext_Create(nullptr, &context_));
    y_ = N_VNew_Serial(2, context_);
    matrix_ = SUNDenseMatrix(2, 2, context_);
    solver_ = SUNLinSol_Dense(y_, matrix_, context_);
    memory_ = CVodeCreate(method, context_);
    check(CVodeInit(memory_, rate, 0.0, y_));
    check(CVodeSStolerances(memory_, tolerance, tolerance));
    check(CVodeSetUserData(memory_, static_cast<void*>(&flow_)));
    check(CVodeSetLinearSolver(memory_, solver_, matrix_));
    check(CVodeSetJacFn(memory_, jacobian));
    check(CVodeRootInit(memory_, 1, rate_of_stretch));
    check(CVodeSetNoInactiveRootWarn(memory_));
    check(CVodeSetMaxNumSteps(memory_, 10'000'000));
  }
  ~Cvode() {
    CVodeFree(&memory_);
    SUNLinSolFree(solver_);
    SUNMatDestroy(matrix_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;

  void advance(const Stretch& stretch, State& state, std::vector<double>& values) {
    const Flow flow(stretch.problem.oscillator, stretch.pressure, stretch.regime);
    flow_ = &flow;
    NV_Ith_S(y_, 0) = state.stretch;
    NV_Ith_S(y_, 1) = state.rate;
    check(CVodeReInit(memory_, state.time, y_));
    check(CVodeSetStopTime(memory_, stretch.target));
    const auto& times = stretch.problem.times;
    while (state.time < stretch.target) {
      const double next =
          values.size() < times.size() ? std::min(times[values.size()], stretch.target) : stretch.target;
      const int code = CVode(memory_, next, y_, &state.time, CV_NORMAL);
      check(code);
      state.stretch = NV_Ith_S(y_, 0);
      state.rate = NV_Ith_S(y_, 1);
      if (values.size() < times.size() && state.time == times[values.size()]) values.push_back(state.stretch);
      if (code == CV_ROOT_RETURN) {
        state.rate = 0;
        return;
      }
    }
  }

 private:
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  void* memory_ = nullptr;
  const Flow* flow_ = nullptr;
};

std::vector<double> run(const Problem& problem, int method, double tolerance) {
  Cvode cvode(method, tolerance);
  std::vector<double> values;
  walk(problem, [&](const Stretch& stretch, State& state) { cvode.advance(stretch, state, values); });
  return values;
}

}  // namespace

std::vector<double> by_cvode_bdf(const Problem& problem, double tolerance) { return run(problem, CV_BDF, tolerance); }
std::vector<double> by_cvode_adams(const Problem& problem, double tolerance) {
  return run(problem, CV_ADAMS, tolerance);
}

}  // namespace turgor::bench
