// Small oscillations of the coupled balloon, against the modes of wall and added mass.

#include <array>
#include <string>

#include "fem/coupled_balloon.hpp"
#include "studies.hpp"

namespace turgor {

namespace {

/// Both lowest frequencies by the eigenproblem.
/// @param bending  D [N m]
std::array<double, 2> frequencies(const std::string& stretch, double fineness, double bending, Rim rim) {
  Case c = stretched(stretch);
  for (double* size : {&c.fem.h_rim, &c.fem.h_orifice, &c.fem.h_wall}) *size /= fineness;
  c.wall.bending_stiffness = bending;
  c.wall.clamped = rim == Rim::clamped;
  const auto modes = HeldBalloon(c).modes(2);
  return {hertz(modes[0]), hertz(modes[1])};
}

/// What a ring-down fits best, over the eigenproblem's frequencies.
FittedModes rung_down(const HeldBalloon& held) {
  const auto modes = held.modes(2);
  // 0.05 Pa move the liquid in the orifice by 0.01 r_ch
  return fitted_modes(ring_down(held.pushed(0.05), 2), {hertz(modes[0]), hertz(modes[1])});
}

/// @param rim  fineness of the mesh at the rim, where the velocity is greatest
HeldBalloon balloon_at(const std::string& stretch, double rim) {
  Case c = stretched(stretch, "time_step = \"5 ms\"\n");
  for (double* size : {&c.fem.h_rim, &c.fem.h_orifice}) *size /= rim;
  return HeldBalloon(c);
}

/// @return of the lower mode, over the eigenproblem's
double print_ring_down(const std::string& stretch) {
  const HeldBalloon held = balloon_at(stretch, 2);
  const auto modes = held.modes(2);
  const FittedModes found = rung_down(held);
  const double x = std::stod(stretch) - 1;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string mode = i == 0 ? "lower" : "upper";
    print("modes", mode + " by the eigenproblem", x, hertz(modes[i]));
    print("modes", mode + " by ring-down", x, found.ratio[i] * hertz(modes[i]));
    print("ring-down over eigenproblem", mode, x, found.ratio[i]);
  }
  print("ring-down", "left of it without both modes", x, found.left);
  return found.ratio[0];
}

/// Of the lower mode, with cells at the rim of twice the size and with those of print_ring_down().
void print_cells_at_rim(const std::string& stretch, double fine) {
  const std::string name = "lower at R = " + stretch;
  const double coarse = rung_down(balloon_at(stretch, 1)).ratio[0];
  print("ring-down by cells at the rim", name, 2, coarse);
  print("ring-down by cells at the rim", name, 1, fine);
  print("ring-down by cells at the rim", name + " extrapolated", 0, 2 * fine - coarse);
}

}  // namespace

void coupled_modes() {
  for (const char* stretch : {"1", "1.05", "1.1"}) print_ring_down(stretch);
  print_cells_at_rim("1.2", print_ring_down("1.2"));
  const double stiffness = stretched("1").wall.bending_stiffness;
  for (const double share : {1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0}) {
    const auto found = frequencies("1", 1, share * stiffness, Rim::hinged);
    print("slack balloon", "lower with a hinged rim", share, found[0]);
    print("slack balloon", "upper with a hinged rim", share, found[1]);
    print("slack balloon", "lower with a clamped rim", share, frequencies("1", 1, share * stiffness, Rim::clamped)[0]);
  }
  std::array<double, 2> slack{};  // without bending, of the last meshes
  for (const double fineness : {0.5, 1.0, 2.0, 4.0}) {
    print("slack balloon by mesh", "lower", 1 / fineness, frequencies("1", fineness, stiffness, Rim::hinged)[0]);
    slack = {slack[1], frequencies("1", fineness, 0, Rim::hinged)[0]};
    print("slack balloon by mesh", "lower without bending", 1 / fineness, slack[1]);
  }
  print("slack balloon by mesh", "lower without bending extrapolated", 0, 2 * slack[1] - slack[0]);
}

}  // namespace turgor
