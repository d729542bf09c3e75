#include "turgor/sweep/members.hpp"

#include "turgor/base/errors.hpp"
#include "turgor/oscillator/selection.hpp"
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
    case Outcome::closure_end: return "R left the range of model.closure";
    case Outcome::max_steps: return "more steps than solve.max_steps";
    default: return {};
  }
}

MemberResult result_of(const Oscillator<double>& oscillator, const MemberSummary& summary,
                       std::span<const TrajectoryStep<double>> steps, const MemberQuestions& asked) {
  MemberResult result{summary.outcome, reason_of(summary.outcome), oscillator.model(), {}, {}};
  for (const auto& value : evaluate_quantities(oscillator, summary, steps, asked.quantities)) {
    result.values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  const double clock = oscillator.scales().time;
  for (const auto& event : summary.first_events) {
    result.events.push_back({event.time * clock, event.stretch, event.before, event.after});
  }
  return result;
}

/// A case that lanes cannot take.
MemberResult run_alone(const Case& c, const MemberQuestions& asked, const SummaryOptions& wanted) {
  const RunResult run = run_motion(c);
  return result_of(*run.oscillator, summary_of(run, wanted), run.trajectory->steps, asked);
}

/// Members in lanes, and where their results go.
struct Group {
  std::vector<Member> members;
  std::vector<std::size_t> places;

  void add(const Case& c, Model model, std::size_t place) {
    Member member = make_member(c, model);
    check_start(member.oscillator, 0.0, member.stretch, member.rate, member.end_time, member.options);
    members.push_back(std::move(member));
    places.push_back(place);
  }
  [[nodiscard]] std::vector<MemberSummary> run(const SummaryOptions& wanted) const {
    std::vector<MemberSummary> summaries(members.size());
    integrate_ensemble(members, wanted, summaries);
    return summaries;
  }
};

}  // namespace

std::string reason_of(const InvalidInput& error) {
  const Issue& first = error.issues().front();
  return first.key.empty() ? first.problem : first.key + ": " + first.problem;
}

std::vector<MemberResult> run_members(std::span<const Case> cases, const MemberQuestions& asked) {
  SummaryOptions wanted = needed_for(asked.quantities);
  wanted.events = asked.event_times;
  std::vector<MemberResult> results(cases.size());
  Group group;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    try {
      if (cases[i].solve.method == Method::quadrature) {
        results[i] = run_alone(cases[i], asked, wanted);
      } else {
        group.add(cases[i], cases[i].model.value_or(Model::full), i);
      }
    } catch (const InvalidInput& error) {
      results[i] = {std::nullopt, reason_of(error), Model::full, {}, {}};
    }
  }
  while (!group.members.empty()) {
    const std::vector<MemberSummary> summaries = group.run(wanted);
    Group again;  // the full model has shown which stretches a run visits; a simpler one may be good enough there
    for (std::size_t k = 0; k < summaries.size(); ++k) {
      const Case& c = cases[group.places[k]];
      const MemberSummary& summary = summaries[k];
      const Oscillator<double>& oscillator = group.members[k].oscillator;
      if (!c.model && oscillator.model() == Model::full && is_complete(summary.outcome)) {
        const Model model =
            simplest_model(oscillator.parameters(), summary.least_stretch, summary.greatest_stretch, c.auto_tolerance);
        if (model != Model::full) {
          again.add(c, model, group.places[k]);
          continue;
        }
      }
      results[group.places[k]] = result_of(oscillator, summary, summary.steps, asked);
    }
    group = std::move(again);
  }
  return results;
}

std::string_view member_instructions() { return name_of(best_instruction_set()); }

}  // namespace turgor
