// A gnuplot script that draws the mesh of a balloon: whole, around its orifice, at its rim, and at twice the radius.

#include <array>
#include <iostream>
#include <string>

#include "turgor/mesh/balloon_mesh.hpp"
#include "turgor/mesh/toroidal_motion.hpp"

namespace {

struct Window {
  std::string title;
  std::string across;  ///< ranges as gnuplot writes them [cm]
  std::string along;
  std::string data;
};

void print_cells(const turgor::BalloonMesh& mesh, const turgor::ToroidalMotion& motion, double radius) {
  for (const auto& cell : mesh.cells) {
    for (const std::size_t i : {0U, 1U, 2U, 3U, 0U}) {
      const auto [r, z] = motion.position(mesh.points[cell[i]], radius);
      std::cout << 100 * r << ' ' << 100 * z << '\n';
    }
    std::cout << '\n';
  }
}

}  // namespace

int main() {
  const double radius = 0.3;
  const turgor::MeshRequest request{0.03, 0.3, radius, 0.0005, 0.002, 0.008};
  const turgor::BalloonMesh mesh = turgor::balloon_mesh(request);
  const turgor::ToroidalMotion motion(request.orifice_radius, radius);
  std::cout << "$reference << end\n";
  print_cells(mesh, motion, radius);
  std::cout << "end\n$double << end\n";
  print_cells(mesh, motion, 2 * radius);
  std::cout << "end\nset terminal pngcairo size 1500,700 font 'sans,11'\nset multiplot layout 1,4\nset size ratio -1\n"
               "unset key\nset xlabel 'r [cm]'\nset ylabel 'z [cm]'\n";
  const std::array<Window, 4> windows{{{"whole", "[0:31]", "[-5:61]", "$reference"},
                                       {"orifice", "[0:7]", "[-4:11]", "$reference"},
                                       {"rim", "[2.5:3.5]", "[-0.8:1.3]", "$reference"},
                                       {"at twice the radius", "[0:62]", "[-5:125]", "$double"}}};
  for (const Window& w : windows) {
    std::cout << "set title '" << w.title << "'\nplot " << w.across << w.along << ' ' << w.data
              << " with lines linewidth 0.5 linecolor rgb '#305080'\n";
  }
}
