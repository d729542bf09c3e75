#include "turgor/material/material.hpp"

#include <cmath>

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

const std::vector<MaterialEntry>& catalogue() {
  static const std::vector<MaterialEntry> entries{
      {"mooney-rivlin",
       "s1 (I1 - 3) + s2 (I2 - 3)",
       "Mooney (1940) J. Appl. Phys. 11, 582; Rivlin (1948); eq. (2.18)",
       {{"s1", "Pa", false, false, "first constant"}, {"s2", "Pa", false, false, "second constant"}}},
      {"neo-hookean",
       "(mu/2) (I1 - 3)",
       "Treloar (1943) Trans. Faraday Soc. 39, 241",
       {{"mu", "Pa", false, true, "shear modulus"}}},
      {"yeoh",
       "c1 (I1 - 3) + c2 (I1 - 3)^2 + c3 (I1 - 3)^3",
       "Yeoh (1993) Rubber Chem. Technol. 66, 754",
       {{"c1", "Pa", false, true, "first constant, half the shear modulus"},
        {"c2", "Pa", false, false, "second constant"},
        {"c3", "Pa", false, false, "third constant"}}},
      {"gent",
       "-(mu jm/2) ln(1 - (I1 - 3)/jm)",
       "Gent (1996) Rubber Chem. Technol. 69, 59",
       {{"mu", "Pa", false, true, "shear modulus"}, {"jm", "1", false, true, "largest I1 - 3"}}},
      {"gent-gent",
       "-(mu jm/2) ln(1 - (I1 - 3)/jm) + c2 ln(I2/3)",
       "Pucci & Saccomandi (2002) Rubber Chem. Technol. 75, 839; Mangan & Destrade (2015)",
       {{"mu", "Pa", false, true, "first constant"},
        {"jm", "1", false, true, "largest I1 - 3"},
        {"c2", "Pa", false, false, "second constant"}}},
      {"ogden",
       "sum_p (mu_p/alpha_p) (2 lambda^alpha_p + lambda^(-2 alpha_p) - 3)",
       "Ogden (1972) Proc. R. Soc. Lond. A 326, 565",
       {{"mu", "Pa", true, false, "moduli, one per term"}, {"alpha", "1", true, false, "exponents, one per term"}}},
      {"fung",
       "(mu/2b) (exp(b (I1 - 3)) - 1)",
       "Fung (1967) Am. J. Physiol. 213, 1532; Demiray (1972) J. Biomech. 5, 309",
       {{"mu", "Pa", false, true, "shear modulus at small strain"}, {"b", "1", false, true, "stiffening exponent"}}},
      {"arruda-boyce",
       "mu sum_i C_i lambda_m^(2-2i) (I1^i - 3^i), five terms",
       "Arruda & Boyce (1993) J. Mech. Phys. Solids 41, 389",
       {{"mu", "Pa", false, true, "coefficient of the series"},
        {"lambda_m", "1", false, true, "locking stretch of a chain"}}},
      {"table",
       "2 int_1^lambda s, s(lambda) a cubic spline through the points",
       "points of the nominal stress s in equal biaxial stretch, given or in a CSV file",
       {{"table.stretch", "1", true, true, "stretches of the points, increasing, one of them 1"},
        {"table.stress", "Pa", true, false,
         "force per unstretched area there in equal biaxial stretch, 0 at stretch 1"}}},
  };
  return entries;
}

namespace {

std::string key_of(const MaterialConstant& constant) { return "material." + std::string(constant.key); }

/// The values of one constant, after checking that they are there and in range.
void check(const MaterialConstant& constant, const MaterialValues& values, std::vector<Issue>& issues) {
  const auto found = values.find(constant.key);
  if (found == values.end() || found->second.empty()) {
    issues.push_back({key_of(constant), "", "missing", std::string(constant.meaning), {}, 0});
    return;
  }
  if (!constant.is_list && found->second.size() != 1) {
    issues.push_back({key_of(constant), "", "takes one value", "", {}, 0});
  }
  for (const double value : found->second) {
    if (!std::isfinite(value)) {
      issues.push_back({key_of(constant), shortest(value), "not a finite number", "", {}, 0});
    } else if (constant.positive && !(value > 0)) {
      issues.push_back({key_of(constant), shortest(value), "must be positive", "", {}, 0});
    }
  }
}

void check_ogden(const std::vector<double>& mu, const std::vector<double>& alpha, std::vector<Issue>& issues) {
  if (mu.size() != alpha.size()) {
    issues.push_back(
        {"material.alpha",
         "",
         "has " + std::to_string(alpha.size()) + " values where material.mu has " + std::to_string(mu.size()),
         "give one of each per term",
         {},
         0});
    return;
  }
  for (std::size_t p = 0; p < mu.size(); ++p) {
    if (!(mu[p] * alpha[p] > 0)) {
      issues.push_back({"material.mu",
                        shortest(mu[p]) + " Pa with alpha = " + shortest(alpha[p]),
                        "a term with mu alpha <= 0 makes the material unstable",
                        "give both constants of a term the same sign, neither zero",
                        {},
                        0});
    }
  }
}

Material<double> build(std::string_view name, const MaterialValues& values) {
  const auto one = [&](std::string_view key) { return values.find(key)->second.front(); };
  const auto many = [&](std::string_view key) { return values.find(key)->second; };
  if (name == "mooney-rivlin") return MooneyRivlin<double>{one("s1"), one("s2")};
  if (name == "neo-hookean") return NeoHookean<double>{one("mu")};
  if (name == "yeoh") return Yeoh<double>{one("c1"), one("c2"), one("c3")};
  if (name == "gent") return Gent<double>{one("mu"), one("jm")};
  if (name == "gent-gent") return GentGent<double>{one("mu"), one("jm"), one("c2")};
  if (name == "ogden") return Ogden<double>{many("mu"), many("alpha")};
  if (name == "fung") return Fung<double>{one("mu"), one("b")};
  if (name == "table") return tabulated(many("table.stretch"), many("table.stress"));
  return ArrudaBoyce<double>{one("mu"), one("lambda_m")};
}

}  // namespace

void refuse_two_stretches() {
  throw InvalidInput("material.model", "table",
                     "a table of equal biaxial stretch does not tell the stresses of a wall that stretches differently "
                     "in two directions, as it does by finite elements",
                     "fit one of the other materials to it; `turgor materials` lists them");
}

Material<double> make_material(std::string_view name, const MaterialValues& values) {
  const MaterialEntry* entry = nullptr;
  std::string names;
  for (const auto& candidate : catalogue()) {
    if (candidate.name == name) entry = &candidate;
    names += (names.empty() ? "" : ", ") + std::string(candidate.name);
  }
  if (entry == nullptr)
    throw InvalidInput("material.model", std::string(name), "no such material", "known are " + names);

  std::vector<Issue> issues;
  for (const auto& constant : entry->constants) check(constant, values, issues);
  if (issues.empty() && name == "ogden") check_ogden(values.find("mu")->second, values.find("alpha")->second, issues);
  if (!issues.empty()) throw InvalidInput(std::move(issues));

  Material<double> material = build(name, values);
  const double stiffness = strain_energy(material, 1.0).second;
  if (!(stiffness > 0)) {
    throw InvalidInput(
        "material", std::string(name),
        "these constants make the unstretched material unstable (d2W/dlambda2 = " + shortest(stiffness) +
            " Pa at lambda = 1)",
        name == "table" ? "the stress must rise through stretch 1" : "the small-strain shear modulus must be positive");
  }
  return material;
}

}  // namespace turgor
