#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "turgor/base/text.hpp"
#include "turgor/run/force_study.hpp"

namespace turgor {

namespace {

ProfileFactors paper_factors(double kappa, const OutflowProfile& profile, int harmonics) {
  const TruncatedForce uniform = truncated_force(uniform_harmonics(kappa, harmonics));
  const TruncatedForce with = truncated_force(profile_harmonics(kappa, profile, harmonics));
  return {with.g3 / uniform.g3, with.first_term / uniform.first_term};
}

nlohmann::ordered_json factors_json(const ProfileFactors& factors) {
  const ProfileConstants constants = closure_constants(factors);
  return {{"inertial_factor", factors.inertial},
          {"centripetal_factor", factors.centripetal},
          {"inertial_constant", constants.inertial},
          {"centripetal_constant", constants.centripetal}};
}

std::string columns(const std::vector<std::string>& texts) {
  std::string out = " ";
  for (const std::string& text : texts) {
    constexpr std::size_t width = 14;
    out += std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
  }
  return out + "\n";
}

}  // namespace

ProfileConstants closure_constants(const ProfileFactors& factors) {
  return {9 * std::numbers::sqrt2 / 2 * factors.inertial, 1.5 * factors.centripetal};
}

ProfileStudy study_profile(OutflowProfile profile, const std::vector<double>& kappas, int harmonics) {
  ProfileStudy study{std::move(profile), harmonics, {}, {0, 0}, {0, 0}};
  const std::vector<CoefficientRow> uniform = coefficient_table(kappas, OutflowProfile::uniform(), 0);
  const std::vector<CoefficientRow> with = coefficient_table(kappas, study.profile, 0);
  const auto count = static_cast<double>(kappas.size());
  for (std::size_t i = 0; i < kappas.size(); ++i) {
    const ForceCoefficients& g = with[i].exact;
    const ProfileRow row{kappas[i],
                         {g.g3 / uniform[i].exact.g3, g.g5 / uniform[i].exact.g5},
                         paper_factors(kappas[i], study.profile, harmonics)};
    study.exact.inertial += row.exact.inertial / count;
    study.exact.centripetal += row.exact.centripetal / count;
    study.paper.inertial += row.paper.inertial / count;
    study.paper.centripetal += row.paper.centripetal / count;
    study.rows.push_back(row);
  }
  return study;
}

std::string profile_csv(const ProfileStudy& study) {
  std::string out = "kappa [1],inertial [1],centripetal [1],inertial_paper [1],centripetal_paper [1]\n";
  for (const ProfileRow& row : study.rows) {
    out += shortest(row.kappa) + "," + shortest(row.exact.inertial) + "," + shortest(row.exact.centripetal) + "," +
           shortest(row.paper.inertial) + "," + shortest(row.paper.centripetal) + "\n";
  }
  return out;
}

std::string profile_json(const ProfileStudy& study) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ProfileRow& row : study.rows) {
    rows.push_back({{"kappa", row.kappa},
                    {"inertial_factor", row.exact.inertial},
                    {"centripetal_factor", row.exact.centripetal},
                    {"inertial_factor_paper", row.paper.inertial},
                    {"centripetal_factor_paper", row.paper.centripetal}});
  }
  const nlohmann::ordered_json document{{"normalisation", study.profile.normalisation()},
                                        {"momentum_factor", study.profile.momentum_factor()},
                                        {"harmonics", study.harmonics},
                                        {"exact", factors_json(study.exact)},
                                        {"paper", factors_json(study.paper)},
                                        {"factors", rows}};
  return document.dump(2) + "\n";
}

std::string profile_text(const ProfileStudy& study) {
  std::string out = "velocities times " + rounded(study.profile.normalisation(), 7) + ", momentum factor " +
                    rounded(study.profile.momentum_factor(), 7) + "\n";
  out += columns({"kappa", "inertial", "centripetal", "inertial*", "centripetal*"});
  for (const ProfileRow& row : study.rows) {
    out += columns({rounded(row.kappa, 6), rounded(row.exact.inertial, 6), rounded(row.exact.centripetal, 6),
                    rounded(row.paper.inertial, 6), rounded(row.paper.centripetal, 6)});
  }
  out += columns({"mean", rounded(study.exact.inertial, 6), rounded(study.exact.centripetal, 6),
                  rounded(study.paper.inertial, 6), rounded(study.paper.centripetal, 6)});
  const ProfileConstants exact = closure_constants(study.exact);
  const ProfileConstants paper = closure_constants(study.paper);
  out += columns({"constant", rounded(exact.inertial, 6), rounded(exact.centripetal, 6), rounded(paper.inertial, 6),
                  rounded(paper.centripetal, 6)});
  return out + "  * the paper's algorithm with " + std::to_string(study.harmonics) +
         " harmonics; constants stand where (2.15) has 223/32 and 75/32\n";
}

}  // namespace turgor
