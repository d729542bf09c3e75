#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/flow/force_table.hpp"
#include "turgor/flow/orifice.hpp"
#include "turgor/run/force_study.hpp"

namespace turgor {

namespace {

/// The table where it reaches, the flow itself where it does not.
ForceCoefficients exact_coefficients(double kappa, const OutflowProfile& profile) {
  if (kappa < ForceTable::least_kappa) {
    throw InvalidInput("kappa", shortest(kappa), "out of range",
                       "allowed are " + shortest(ForceTable::least_kappa) + " (2^-17) to 1");
  }
  if (profile.is_uniform() && kappa <= ForceTable::greatest_kappa) return ForceTable::uniform().coefficients(kappa);
  return force_coefficients(PotentialFlow(kappa, profile));
}

using Field = std::pair<std::string, double>;

/// Every number of a row by its name.
std::vector<Field> fields_of(const CoefficientRow& row) {
  std::vector<Field> fields{{"kappa", row.kappa}, {"epsilon", row.eps}, {"g1", row.exact.g1}, {"g2", row.exact.g2},
                            {"g3", row.exact.g3}, {"g4", row.exact.g4}, {"g5", row.exact.g5}};
  const auto add = [&](const std::string& name, double value, double exact) {
    fields.emplace_back(name, value);
    fields.emplace_back(name + "_error", value / exact - 1);
  };
  add("g1_leading", row.paper.g1, row.exact.g1);
  add("g2_leading", row.paper.g2, row.exact.g2);
  add("g3_fit", row.paper.g3, row.exact.g3);
  add("g4_leading", row.paper.g4, row.exact.g4);
  add("g5_fit", row.paper.g5, row.exact.g5);
  add("g3_close", row.close.g3, row.exact.g3);
  add("g5_close", row.close.g5, row.exact.g5);
  if (row.truncated) {
    add("g3_truncated", row.truncated->g3, row.exact.g3);
    add("g5_truncated", row.truncated->g5, row.exact.g5);
    add("g5_truncated_without_integral", row.truncated->g5_without_integral, row.exact.g5);
  }
  return fields;
}

std::string cell(const std::string& text) {
  constexpr std::size_t width = 13;
  return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
}

}  // namespace

std::vector<CoefficientRow> coefficient_table(const std::vector<double>& kappas, const OutflowProfile& profile,
                                              int harmonics) {
  std::vector<CoefficientRow> rows;
  for (const double kappa : kappas) {
    const double eps = cap_depth(kappa);
    CoefficientRow row{kappa, eps, exact_coefficients(kappa, profile), paper_fits(eps), close_fits(kappa), {}};
    if (harmonics > 0) {
      row.truncated = truncated_force(profile.is_uniform() ? uniform_harmonics(kappa, harmonics)
                                                           : profile_harmonics(kappa, profile, harmonics));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string coefficients_csv(const std::vector<CoefficientRow>& rows) {
  std::string out;
  for (const auto& [name, value] : fields_of(rows.front())) out += (out.empty() ? "" : ",") + name + " [1]";
  out += "\n";
  for (const CoefficientRow& row : rows) {
    for (const auto& [name, value] : fields_of(row)) out += shortest(value) + ",";
    out.back() = '\n';
  }
  return out;
}

std::string coefficients_json(const std::vector<CoefficientRow>& rows) {
  nlohmann::ordered_json document = nlohmann::ordered_json::array();
  for (const CoefficientRow& row : rows) {
    nlohmann::ordered_json object;
    for (const auto& [name, value] : fields_of(row)) object[name] = value;
    document.push_back(std::move(object));
  }
  return document.dump(2) + "\n";
}

std::string coefficients_text(const std::vector<CoefficientRow>& rows) {
  std::string out;
  for (const char* name : {"kappa", "eps", "g1", "g2", "g3", "g4", "g5"}) out += cell(name);
  out += "\n";
  for (const CoefficientRow& row : rows) {
    const ForceCoefficients& g = row.exact;
    for (const double value : {row.kappa, row.eps, g.g1, g.g2, g.g3, g.g4, g.g5}) out += cell(rounded(value, 7));
    out += "\n";
  }
  out += "\nerrors in %: the paper's (2.9), (2.10), and closer fits" +
         std::string(rows.front().truncated ? "; truncated sums, g5 with and without the integral" : "") + "\n";
  for (const char* name : {"kappa", "g1", "g2", "g3", "g4", "g5", "g3 closer", "g5 closer"}) out += cell(name);
  if (rows.front().truncated) out += cell("g3 trunc.") + cell("g5 trunc.") + cell("without");
  out += "\n";
  for (const CoefficientRow& row : rows) {
    out += cell(rounded(row.kappa, 5));
    for (const auto& [name, value] : fields_of(row)) {
      if (name.ends_with("_error")) out += cell(rounded(100 * value, 3));
    }
    out += "\n";
  }
  return out;
}

}  // namespace turgor
