#pragma once
// Any of the materials, and the catalogue that says what each is called and which constants it takes.
// A new material is one header beside this one, one alternative in Material and one entry in catalogue().

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "turgor/material/arruda_boyce.hpp"
#include "turgor/material/biaxial.hpp"
#include "turgor/material/fung.hpp"
#include "turgor/material/gent.hpp"
#include "turgor/material/gent_gent.hpp"
#include "turgor/material/mooney_rivlin.hpp"
#include "turgor/material/neo_hookean.hpp"
#include "turgor/material/ogden.hpp"
#include "turgor/material/tabulated.hpp"
#include "turgor/material/yeoh.hpp"

namespace turgor {

/// One of the known hyperelastic materials; T is the type of its constants.
template <class T>
using Material = std::variant<MooneyRivlin<T>, NeoHookean<T>, Yeoh<T>, Gent<T>, GentGent<T>, Ogden<T>, Fung<T>,
                              ArrudaBoyce<T>, Tabulated<T>>;

/// Strain energy density W [J/m^3] at stretch lambda > 0, with dW/dlambda and d2W/dlambda2 [Pa].
/// Infinite, never NaN, at or beyond stretch_limit(material) and where a material locks in compression.
template <class T, class S>
[[nodiscard]] Jet<S> strain_energy(const Material<T>& material, const S& lambda) {
  return std::visit([&](const auto& solid) { return solid.energy(lambda); }, material);
}

/// Says that a table of equal biaxial stretch does not tell what happens at two different stretches.
/// @throws InvalidInput for material.model, always
[[noreturn]] void refuse_two_stretches();

/// Strain energy density W [J/m^3] at principal stretches l1, l2 > 0 of an incompressible sheet, with its derivatives
/// [Pa]. Infinite, never NaN, where the material has locked (I1 - 3 >= jm) and where a number is out of double's range.
/// @throws InvalidInput for a table, see refuse_two_stretches
template <class T, class S>
[[nodiscard]] BiaxialJet<S> strain_energy(const Material<T>& material, const S& l1, const S& l2) {
  return std::visit(
      [&](const auto& solid) {
        if constexpr (requires { solid.energy(l1, l2); }) {
          return infinite_unless_finite(solid.energy(l1, l2));
        } else if constexpr (!requires(S j) { solid.of_first(j); }) {
          refuse_two_stretches();
          return BiaxialJet<S>{};
        } else {
          const BiaxialJet<S> i1 = first_invariant_minus_3(l1, l2);
          const BiaxialJet<S> first = of_invariant(solid.of_first(i1.value), i1);
          if constexpr (requires { solid.of_second(i1.value); }) {
            const BiaxialJet<S> i2 = second_invariant_minus_3(l1, l2);
            return infinite_unless_finite(first + of_invariant(solid.of_second(i2.value), i2));
          } else {
            return infinite_unless_finite(first);
          }
        }
      },
      material);
}

/// Shear modulus at small strain [Pa]: W'' = 12 mu at lambda = 1, in equal biaxial stretch.
template <class T>
[[nodiscard]] T shear_modulus(const Material<T>& material) {
  return strain_energy(material, T(1)).second / 12;
}

/// Bending stiffness D = E d^3/(12 (1 - nu^2)) [N m] of a thin sheet of an incompressible material: E = 3 mu and nu =
/// 1/2 make it mu d^3/3. The energy of changes k1, k2 of its principal curvatures is D/2 (k1^2 + k1 k2 + k2^2) per
/// area.
/// @param thickness  d [m], > 0
template <class T>
[[nodiscard]] T bending_stiffness(const Material<T>& material, const T& thickness) {
  return shear_modulus(material) * thickness * thickness * thickness / 3;
}

/// Stretch at which the material locks [1]; +infinity when it never does.
template <class T>
[[nodiscard]] T stretch_limit(const Material<T>& material) {
  return std::visit(
      [](const auto& solid) -> T {
        if constexpr (requires { solid.stretch_limit(); }) {
          return solid.stretch_limit();
        } else {
          return std::numeric_limits<T>::infinity();
        }
      },
      material);
}

/// Stretches between which a material is known: 0 and +infinity, but those of its first and last point for a table.
template <class T>
struct KnownStretches {
  T least;
  T greatest;
};
template <class T>
[[nodiscard]] KnownStretches<T> known_stretches(const Material<T>& material) {
  const auto* given = std::get_if<Tabulated<T>>(&material);
  if (given == nullptr) return {T(0), std::numeric_limits<T>::infinity()};
  return {given->tables[0]->least_stretch(), given->tables[0]->greatest_stretch()};
}

/// No elastomer stretches this far (natural rubber breaks near 8): beyond it a balloon counts as running away, and no
/// equilibria are sought there.
inline constexpr double largest_stretch = 100.0;

/// One constant of a material, as a case file names it.
struct MaterialConstant {
  std::string_view key;
  std::string_view unit;  ///< SI unit, "1" when dimensionless
  bool is_list = false;   ///< a list of values, one per term
  bool positive = false;  ///< must be > 0 (each value)
  std::string_view meaning;
};

/// One entry of the catalogue of materials.
struct MaterialEntry {
  std::string_view name;    ///< as in `model = "..."`
  std::string_view energy;  ///< strain energy density in words of algebra
  std::string_view reference;
  std::vector<MaterialConstant> constants;
};

/// All materials in the order of Material's alternatives.
[[nodiscard]] const std::vector<MaterialEntry>& catalogue();

/// The constants of a material by key, in SI units.
using MaterialValues = std::map<std::string, std::vector<double>, std::less<>>;

/// Builds a material from its name and constants.
/// @throws InvalidInput naming every constant that is missing, not finite, out of range, or that makes the
///         unstretched material unstable (d2W/dlambda2 <= 0 at lambda = 1).
[[nodiscard]] Material<double> make_material(std::string_view name, const MaterialValues& values);

}  // namespace turgor
