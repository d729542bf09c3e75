// Balloons in SIMD lanes against the same balloons one by one.

#include "turgor/ensemble/ensemble.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "../support/balloons.hpp"
#include "../support/seed.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/run/energy.hpp"

namespace turgor {
namespace {

using test::between;
using test::paper_balloon;

constexpr std::size_t materials = std::variant_size_v<Material<double>>;
const SummaryOptions everything{true, true, true, 1000};

/// Points of a Mooney-Rivlin solid, so many that the steps hardly feel them, as many as no other member's.
Material<double> random_table(double mu, std::mt19937_64& random) {
  const double share = between(random, 0.02, 0.3);
  const int above = 200 + static_cast<int>(random() % 100);
  std::vector<double> stretch;
  std::vector<double> stress;
  for (int i = -20; i <= above; ++i) {
    const double l = 1 + i * 0.02;
    stretch.push_back(l);
    stress.push_back(i == 0 ? 0.0 : 2 * mu * (l - std::pow(l, -5) + share * (l * l * l - std::pow(l, -3))));
  }
  return tabulated(std::move(stretch), stress);
}

Material<double> random_material(std::size_t kind, std::mt19937_64& random) {
  const double mu = std::exp(between(random, std::log(1e5), std::log(3e6)));
  const auto share = [&](double a, double b) { return mu * between(random, a, b); };
  switch (kind) {
    case 0: return MooneyRivlin<double>{mu, share(0.02, 0.3)};
    case 1: return NeoHookean<double>{mu};
    case 2: return Yeoh<double>{mu, -share(1e-4, 1e-3), share(1e-5, 1e-4)};
    case 3: return Gent<double>{mu, between(random, 10, 100)};
    case 4: return GentGent<double>{mu, between(random, 10, 100), share(0.02, 0.3)};
    case 5:
      if (between(random, 0, 1) < 0.3) return Ogden<double>{{mu}, {between(random, 1.5, 3)}};
      if (between(random, 0, 1) < 0.5) return Ogden<double>{{mu, share(1e-3, 1e-2)}, {1.3, 5.0}};
      return Ogden<double>{{mu, share(1e-3, 1e-2), -share(0.01, 0.03)}, {1.3, 5.0, -2.0}};
    case 6: return Fung<double>{mu, between(random, 0.01, 0.3)};
    case 7: return ArrudaBoyce<double>{mu, between(random, 3, 6)};
    default: return random_table(mu, random);
  }
}

/// In Pa and s, `unit` being the time scale.
PressureProgram<double> random_pressure(int kind, double size, double unit, std::mt19937_64& random) {
  switch (kind) {
    case 0: return constant_pressure(size);
    case 1:
      return test::up_hold_down(size, unit * between(random, 0.5, 5), unit * between(random, 5, 8),
                                unit * between(random, 8, 12));
    case 2: {
      std::vector<double> times{0};
      std::vector<double> pressures{0};
      for (int i = 0; i < 6; ++i) {
        times.push_back(times.back() + unit * between(random, 0.5, 3));
        pressures.push_back(size * between(random, 0, 1));
      }
      return table_pressure(times, pressures, TableInterpolation::cubic);
    }
    default:
      return harmonic_pressure(HarmonicPressure<double>{size / 2, size / 3, between(random, 0.05, 0.3) / unit, 1});
  }
}

/// A balloon of the given kinds, else random, at rest or moving, on natural scales.
Member random_member(std::size_t material, Model model, int pressure, std::mt19937_64& random) {
  Parameters<double> p = paper_balloon<double>(0.3 * between(random, 0.03, 0.1), 0.3 * between(random, 0.3, 2));
  if (model == Model::orifice) p.channel_length = 0;
  p = test::with_closure(p, all_closures.at(random() % all_closures.size()));
  p.thickness = 0.3 * between(random, 0.003, 0.03);
  p.material = random_material(material, random);
  const double stiffness = p.thickness * strain_energy(p.material, 1.0).second / p.radius;
  // Without a channel the balloon jumps to its upper equilibrium, or away, in strokes so fast that the least error in
  // time is a great one in R: such members start, and stay, below the limit point.
  const bool calm = model == Model::orifice;
  const double size = stiffness * between(random, 0.02, calm ? 0.07 : 0.15);
  const auto unit = natural_scales(p, constant_pressure(size), 1.0).time;
  const auto program = random_pressure(pressure, size, unit, random);
  const double end = between(random, 2, 25);
  Member member{Oscillator<double>(model, p, program, natural_scales(p, program, end * unit)),
                between(random, 0.95, calm ? 1.1 : 1.6),
                between(random, 0, 1) < 0.5 ? 0.0 : between(random, -0.1, 0.1),
                end,
                {}};
  member.options.rtol = member.options.atol = std::pow(10.0, -between(random, 7, 10));
  return member;
}

std::vector<Member> random_members(std::mt19937_64& random, int of_each) {
  std::vector<Member> members;
  for (std::size_t material = 0; material < materials; ++material) {
    for (const Model model : {Model::full, Model::orifice, Model::long_channel}) {
      for (int pressure = 0; pressure < 4; ++pressure) {
        for (int i = 0; i < of_each; ++i) members.push_back(random_member(material, model, pressure, random));
      }
    }
  }
  std::shuffle(members.begin(), members.end(), random);
  return members;
}

Trajectory<double> alone(const Member& m) {
  return simulate(m.oscillator, 0.0, m.stretch, m.rate, m.end_time, m.options);
}

std::vector<MemberSummary> integrated(std::span<const Member> members, const SummaryOptions& options,
                                      InstructionSet set) {
  std::vector<MemberSummary> summaries(members.size());
  integrate_ensemble(members, options, summaries, set);
  return summaries;
}

std::string described(const Member& m) {
  return "material " + std::to_string(m.oscillator.parameters().material.index()) + ", model " +
         std::string(name_of(m.oscillator.model())) + ", closure " +
         std::string(name_of(m.oscillator.parameters().closure)) + ", rtol " + std::to_string(m.options.rtol * 1e9) +
         "e-9, R0 " + std::to_string(m.stretch) + ", v0 " + std::to_string(m.rate) + ", end " +
         std::to_string(m.end_time);
}

struct Slack {
  double stretch;
  double rate;
};

class Ensembles : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (GetParam() > best_instruction_set()) GTEST_SKIP() << "this machine has no " << name_of(GetParam());
  }
  [[nodiscard]] std::vector<MemberSummary> integrate(std::span<const Member> members,
                                                     const SummaryOptions& options = everything) const {
    return integrated(members, options, GetParam());
  }
  /// The scalar kernel is simulate() itself. Lanes differ by fused multiplications, and where those tip the scales
  /// between a step and its rejection, by the error of simulate(): ten tolerances, or what a tighter one changes.
  [[nodiscard]] Slack slack(const Member& m, const Trajectory<double>& t) const;
  void compare(const Member& m, const MemberSummary& s) const;
};
INSTANTIATE_TEST_SUITE_P(All, Ensembles,
                         testing::Values(InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512),
                         [](const auto& set) { return std::string(name_of(set.param)); });

Slack Ensembles::slack(const Member& m, const Trajectory<double>& t) const {
  const bool exactly = GetParam() == InstructionSet::scalar;
  // Without a channel inflation is a stroke a hundred times as fast as deflation, from a zero of the rate that is
  // crossed at a glancing angle: errors of time count that much more in R.
  const double glancing = m.oscillator.model() == Model::orifice ? 30 : 1;
  const double least = exactly ? 1e-13 : 10 * glancing * m.options.rtol;
  Slack slack{least, least};
  Member tighter = m;
  tighter.options.rtol = tighter.options.atol = m.options.rtol / 100;
  tighter.options.max_steps = 1'000'000;
  const Trajectory<double> exact = alone(tighter);
  const double share = exactly ? 0 : 5 * glancing;
  for (const auto& step : t.steps) {
    for (const double theta : {0.0, 0.5, 1.0}) {
      const double time = std::min(step.start + theta * step.duration, exact.last.time);
      const Point<double> p = t.at(time);
      const Point<double> q = exact.at(time);
      slack.stretch = std::max({slack.stretch, least * p.stretch, share * std::abs(p.stretch - q.stretch)});
      slack.rate = std::max({slack.rate, least * std::abs(p.rate), share * std::abs(p.rate - q.rate)});
    }
  }
  return slack;
}

/// One summary with the trajectory that simulate() has for it.
void Ensembles::compare(const Member& m, const MemberSummary& s) const {
  SCOPED_TRACE(described(m));
  const Trajectory<double> t = alone(m);
  const auto [near, near_rate] = slack(m, t);
  ASSERT_EQ(s.outcome, t.outcome) << s.message << " / " << t.message;
  EXPECT_EQ(s.message.empty(), t.message.empty());
  EXPECT_EQ(s.last.regime, t.last.regime);
  if (t.outcome == Outcome::reached_end) {
    EXPECT_EQ(s.last.time, m.end_time);
  }
  // The end of a step that went too far is anywhere beyond.
  const bool ran_away = s.outcome == Outcome::runaway && GetParam() != InstructionSet::scalar;
  if (ran_away) {
    EXPECT_GT(s.last.stretch, m.options.runaway_stretch);
    EXPECT_NEAR(s.last.time, t.last.time, 0.1 * t.last.time);
    return;
  }
  // Other ends are events, at times of their own, or the given one.
  const Point<double> there = t.last;
  EXPECT_NEAR(s.last.time, t.last.time, 1e4 * near);
  EXPECT_NEAR(s.last.stretch, there.stretch, near);
  EXPECT_NEAR(s.last.rate, there.rate, near_rate);

  EXPECT_EQ(static_cast<std::size_t>(s.events), t.events.size());
  ASSERT_EQ(s.first_events.size(), t.events.size());
  for (std::size_t i = 0; i < t.events.size(); ++i) {
    EXPECT_NEAR(s.first_events[i].stretch, t.events[i].stretch, near) << "event " << i;
    EXPECT_NEAR(s.first_events[i].time, t.events[i].time, 1e4 * near) << "event " << i;
    EXPECT_EQ(s.first_events[i].before, t.events[i].before);
    EXPECT_EQ(s.first_events[i].after, t.events[i].after);
  }
  if (!t.events.empty()) {
    EXPECT_EQ(s.first_event_time, s.first_events.front().time);
  }

  double greatest = m.stretch;
  double least = m.stretch;
  double flow = 0;
  for (const auto& step : t.steps) {
    greatest = std::max(greatest, step.stretch_at(1));
    least = std::min(least, step.stretch_at(1));
    for (int i = 0; i <= 64; ++i) {
      const double kappa =
          m.oscillator.parameters().orifice_radius / m.oscillator.parameters().radius / step.stretch_at(i / 64.0);
      const double eps = 1 - std::sqrt(1 - kappa * kappa);  // the closure's, section 2.1
      flow = std::max(flow, std::abs(step.rate_at(i / 64.0)) * (2 - eps) / (eps * (1 - eps)));
    }
  }
  EXPECT_NEAR(s.greatest_stretch, greatest, near);
  EXPECT_NEAR(s.least_stretch, least, near);
  EXPECT_NEAR(t.at(s.peak_time).stretch, greatest, near);
  EXPECT_LE(s.greatest_flow, flow * (1 + 1e-3) + 1e3 * near_rate);  // it is sampled at the steps' quarters
  EXPECT_GE(s.greatest_flow, flow * 0.9 - 1e3 * near_rate);

  const EnergyLedger ledger(m.oscillator, t);
  const double unit = m.oscillator.scales().energy();
  double size = std::abs(ledger.at(0).elastic) + ledger.at(0).kinetic;
  for (const auto& step : t.steps) size = std::max(size, std::abs(ledger.at(step.start).inlet_work));
  const Energies last = ledger.at(t.last.time);
  if (s.last.time == t.last.time) {
    EXPECT_NEAR(s.inlet_work, last.inlet_work / unit, 10 * near * (1 + size / unit));
    EXPECT_NEAR(s.dissipated, last.dissipated / unit, 10 * near * (1 + size / unit));
  }
  if (GetParam() == InstructionSet::scalar) {
    EXPECT_NEAR(s.energy_error, ledger.closure_error(), 10 * near);
  } else {  // an error of its own, of the same size
    EXPECT_LE(s.energy_error, 10 * ledger.closure_error() + 100 * near);
  }

  ASSERT_FALSE(s.steps.empty() && !t.steps.empty() && t.steps.front().regime != Regime::rest);
  for (const auto& step : s.steps) {
    const double middle = step.start + step.duration / 2;
    if (middle < t.last.time) {
      EXPECT_NEAR(step.stretch_at(0.5), t.at(middle).stretch, 10 * near);
    }
  }
}

TEST_P(Ensembles, MoveAsEachMemberAlone) {
  std::mt19937_64 random(test::random_seed());
  const auto members = random_members(random, 3);
  const auto summaries = integrate(members);
  for (std::size_t i = 0; i < members.size(); ++i) compare(members[i], summaries[i]);
}

TEST_P(Ensembles, EndAsEachMemberAlone) {
  std::mt19937_64 random(test::random_seed());
  auto members = random_members(random, 5);
  for (std::size_t i = 0; i < members.size(); ++i) {
    auto& m = members[i];
    switch (i % 5) {
      case 0: m.options.max_stretch = m.stretch + between(random, 0.01, 1); break;
      case 1: m.options.runaway_stretch = m.stretch * between(random, 1.05, 2); break;
      case 2: m.options.max_events = 1 + static_cast<long>(i % 4); break;
      case 3: m.options.rest_tol = between(random, 1e-2, 2e-1); break;
      default: m.options.max_steps = 3 + static_cast<long>(i % 20); break;
    }
  }
  std::array<int, 8> outcomes{};
  const auto summaries = integrate(members);
  for (std::size_t i = 0; i < members.size(); ++i) {
    ++outcomes[static_cast<std::size_t>(summaries[i].outcome)];
    auto member = members[i];
    if (i % 5 == 4) {
      EXPECT_LE(summaries[i].steps.size(), static_cast<std::size_t>(member.options.max_steps));
    }
    if (i % 5 == 4 && GetParam() != InstructionSet::scalar) {  // how far so many steps reach hangs on rounding
      if (summaries[i].outcome == Outcome::max_steps) {
        EXPECT_EQ(summaries[i].steps.size(), static_cast<std::size_t>(member.options.max_steps));
        EXPECT_LT(summaries[i].last.time, member.end_time);
        continue;
      }
      member.options.max_steps = 1'000'000;
    }
    compare(member, summaries[i]);
  }
  for (const Outcome outcome : {Outcome::reached_end, Outcome::at_rest, Outcome::max_events, Outcome::burst,
                                Outcome::runaway, Outcome::max_steps}) {
    EXPECT_GT(outcomes[static_cast<std::size_t>(outcome)], 0) << name_of(outcome);
  }
}

// Balloons that are sucked empty end where their orifices are too wide for the closure, each on its own.
TEST_P(Ensembles, EndWhereAnExactClosureDoes) {
  std::mt19937_64 random(test::random_seed());
  std::vector<Member> members;
  for (int i = 0; i < 12; ++i) {
    const bool ends = i % 3 != 0;
    const auto p = test::with_closure(paper_balloon<double>(between(random, 0.17, 0.2), between(random, 0, 0.4)),
                                      Closure::potential);
    const auto program = constant_pressure(ends ? -between(random, 1.5e6, 3e6) : 20e3);
    const auto scales = natural_scales(p, program, 1.0);
    members.push_back({Oscillator<double>(Model::full, p, program, scales), 1.0, 0.0, 5.0, {}});
  }
  const auto summaries = integrate(members);
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_EQ(summaries[i].outcome, i % 3 != 0 ? Outcome::closure_end : Outcome::reached_end) << summaries[i].message;
    if (i % 3 != 0) {
      EXPECT_NE(summaries[i].message.find("R fell to r_ch/(0.75 r0)"), std::string::npos);
    }
    EXPECT_NEAR(summaries[i].least_stretch, alone(members[i]).last.stretch, i % 3 != 0 ? 1e-9 : 1);
    compare(members[i], summaries[i]);
  }
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same_bits(const MemberSummary& a, const MemberSummary& b) {
  const auto numbers = [](const MemberSummary& s) {
    std::vector<double> all{s.last.time,        s.last.stretch, s.last.rate,        s.least_stretch,
                            s.greatest_stretch, s.peak_time,    s.first_event_time, s.inlet_work,
                            s.dissipated,       s.energy_error, s.greatest_flow};
    for (const auto& e : s.first_events) all.insert(all.end(), {e.time, e.stretch});
    for (const auto& step : s.steps) {
      all.insert(all.end(), {step.start, step.duration});
      all.insert(all.end(), step.stretch.begin(), step.stretch.end());
    }
    return all;
  };
  return a.outcome == b.outcome && a.message == b.message && a.events == b.events && a.last.regime == b.last.regime &&
         std::ranges::equal(numbers(a), numbers(b), [](double x, double y) { return same_bits(x, y); });
}

// To the last bit: alone, in another order, and with companions that burst, fail, or rest.
TEST_P(Ensembles, AMemberDoesNotFeelItsCompanions) {
  std::mt19937_64 random(test::random_seed());
  const auto members = random_members(random, 2);
  const auto together = integrate(members);
  auto more = members;
  for (auto& m : random_members(random, 1)) {
    if (between(random, 0, 1) < 0.5) m.options.max_stretch = m.stretch + 0.01;
    if (between(random, 0, 1) < 0.3) m.options.max_steps = 2;
    more.push_back(m);
  }
  std::vector<std::size_t> order(more.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  std::vector<Member> shuffled;
  for (const std::size_t i : order) shuffled.push_back(more[i]);
  const auto elsewhere = integrate(shuffled);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (order[k] >= members.size()) continue;
    const Member& m = members[order[k]];
    EXPECT_TRUE(same_bits(elsewhere[k], together[order[k]])) << described(m);
    EXPECT_TRUE(same_bits(integrate(std::span(&m, 1)).front(), together[order[k]])) << described(m);
  }
}

TEST_P(Ensembles, KeepOnlyWhatIsWanted) {
  std::mt19937_64 random(test::random_seed());
  const auto members = random_members(random, 1);
  const auto whole = integrate(members);
  const auto some = integrate(members, {});
  SummaryOptions two;
  two.events = 2;
  const auto few = integrate(members, two);
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_TRUE(same_bits(some[i].last.stretch, whole[i].last.stretch));
    EXPECT_EQ(some[i].events, whole[i].events);
    EXPECT_EQ(some[i].inlet_work, 0);
    EXPECT_EQ(some[i].greatest_flow, 0);
    EXPECT_TRUE(some[i].steps.empty());
    EXPECT_TRUE(some[i].first_events.empty());
    EXPECT_EQ(few[i].first_events.size(), std::min<std::size_t>(2, whole[i].first_events.size()));
  }
}

// Without pressure a balloon at R = 1 stays where it is, whoever is in the other lanes; so it does until a knot.
TEST_P(Ensembles, MembersMayRestToTheirEnd) {
  std::mt19937_64 random(test::random_seed());
  std::vector<Member> members;
  for (int i = 0; i < 20; ++i) {
    const auto p = paper_balloon<double>(0.03, 0.5);
    const auto scales = natural_scales(p, constant_pressure(36e3), 1.0);
    const auto late = SegmentList<double>(0).hold(3 * scales.time).ramp(10e3, scales.time, RampShape::smooth).build();
    members.push_back({Oscillator<double>(Model::full, p, i % 3 == 2 ? late : constant_pressure(0.0), scales),
                       1.0,
                       0.0,
                       5.0 + i,
                       {}});
    members.push_back(random_member(0, Model::full, 1, random));
  }
  const auto summaries = integrate(members);
  for (std::size_t i = 0; i < members.size(); ++i) {
    compare(members[i], summaries[i]);
    if (i % 2 == 1 || i / 2 % 3 == 2) continue;
    EXPECT_EQ(summaries[i].last.stretch, 1.0);
    EXPECT_EQ(summaries[i].last.time, members[i].end_time);
    EXPECT_EQ(summaries[i].events, 0);
  }
}

TEST_P(Ensembles, MayBeEmpty) {
  std::vector<MemberSummary> none;
  integrate_ensemble({}, everything, none, GetParam());
  EXPECT_TRUE(none.empty());
}

// Nothing is integrated when one of them cannot start.
TEST_P(Ensembles, RefuseAMemberThatCannotStart) {
  std::mt19937_64 random(test::random_seed());
  auto members = random_members(random, 1);
  members[7].stretch = -1;
  std::vector<MemberSummary> summaries(members.size());
  EXPECT_THROW(integrate_ensemble(members, everything, summaries, GetParam()), InvalidInput);
}

TEST(Ensemble, TheBestInstructionSetIsTakenByDefault) {
  std::mt19937_64 random(test::random_seed());
  const auto members = random_members(random, 1);
  std::vector<MemberSummary> summaries(members.size());
  integrate_ensemble(members, everything, summaries);
  const auto best = integrated(members, everything, best_instruction_set());
  for (std::size_t i = 0; i < members.size(); ++i) EXPECT_TRUE(same_bits(summaries[i], best[i]));
}

}  // namespace
}  // namespace turgor
