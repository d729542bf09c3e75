#include "turgor/sweep/members.hpp"

#include "turgor/run/run_case.hpp"

namespace turgor {

namespace {

/// The trajectory's own message has the numbers of this member, which its quantities tell too; one text for all members
/// that fail alike keeps files small.
std::string reason_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::burst: return "the wall bursts at material.max_stretch";
    case Outcome::runaway: return "the balloon runs away: nothing holds it";
    case Outcome::step_failed: return "the step size fell below what the clock resolves";
    case Outcome::max_steps: return "more steps than solve.max_steps";
    default: return {};
  }
}

MemberResult run_member(const Case& c, const MemberQuestions& asked) {
  const RunResult run = run_motion(c);
  MemberResult result{run.trajectory->outcome, reason_of(run.trajectory->outcome), run.choice.model, {}, {}};
  for (const auto& value : evaluate_quantities(run, asked.quantities)) {
    result.values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  const double clock = run.oscillator->scales().time;
  for (const auto& event : run.trajectory->events) {
    if (result.events.size() == asked.event_times) break;
    result.events.push_back({event.time * clock, event.stretch, event.before, event.after});
  }
  return result;
}

}  // namespace

std::vector<MemberResult> run_members(std::span<const Case> cases, const MemberQuestions& asked) {
  std::vector<MemberResult> results;
  results.reserve(cases.size());
  for (const Case& c : cases) results.push_back(run_member(c, asked));
  return results;
}

std::string_view member_instructions() { return "scalar double precision"; }

}  // namespace turgor
