// Writes src/flow/uniform_force_table.hpp: g3 and g5 of (2.8) for uniform outflow, computed from the flow itself.

#include <cstdio>

#include "turgor/flow/force_table.hpp"

namespace {

void print(const turgor::ForceTable::Series& series) {
  std::printf("        {");
  for (std::size_t k = 0; k < turgor::ForceTable::terms; ++k) {
    std::printf("%s%.17g", k == 0 ? "" : ", ", series.coefficient[k]);
  }
  std::printf("}");
}

}  // namespace

int main() {
  using turgor::ForceTable;
  std::printf(
      "#pragma once\n"
      "// Made by tools/make_force_table.cpp (./dev tables); not to be edited. Chebyshev coefficients of h3 and h5 of\n"
      "// ForceTable for uniform outflow, one pair for each binade of kappa.\n\n"
      "#include <array>\n\n"
      "namespace turgor {\n\n"
      "struct UniformForcePiece {\n"
      "  std::array<double, %zu> inertial;\n"
      "  std::array<double, %zu> centripetal;\n"
      "};\n\n"
      "// clang-format off\n"
      "inline constexpr std::array<UniformForcePiece, %zu> uniform_force_table{{\n",
      ForceTable::terms, ForceTable::terms, ForceTable::pieces);
  for (std::size_t i = 0; i < ForceTable::pieces; ++i) {
    constexpr double tolerance = 1e-15;
    const auto piece = ForceTable::compute(turgor::OutflowProfile::uniform(), i, tolerance);
    std::printf("    {\n");
    print(piece.inertial);
    std::printf(",\n");
    print(piece.centripetal);
    std::printf("\n    },\n");
  }
  std::printf("}};\n// clang-format on\n\n}  // namespace turgor\n");
}
