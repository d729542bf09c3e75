#pragma once
// Many members of a sweep at once: what is asked of each, and what comes back.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "turgor/base/errors.hpp"
#include "turgor/case/case.hpp"
#include "turgor/ensemble/ensemble.hpp"

namespace turgor {

/// What is asked of every member.
struct MemberQuestions {
  std::vector<std::size_t> quantities;  ///< indices in quantity_names()
  std::uint64_t event_times = 0;        ///< keep so many first events
};

/// What became of one member.
struct MemberResult {
  std::optional<Outcome> outcome;  ///< nothing when it could not start
  std::string message;             ///< why it is not complete, without numbers of this member; empty when it is
  Model model{};
  std::vector<double> values;               ///< of the asked quantities; NaN where the run does not have one
  std::vector<RegimeEvent<double>> events;  ///< the first ones; times in s
};

/// What is wrong with a member, without its numbers: the same text for all members that fail alike.
[[nodiscard]] std::string reason_of(const InvalidInput& error);

/// Runs cases on the calling thread. A result depends on its own case only, never on its neighbours, up to the order of
/// the span, which a caller keeps the same for the same bits.
[[nodiscard]] std::vector<MemberResult> run_members(std::span<const Case> cases, const MemberQuestions& asked);

/// The instructions that run_members() uses, for the record: results of different ones differ in the last bits.
[[nodiscard]] std::string_view member_instructions();

}  // namespace turgor
