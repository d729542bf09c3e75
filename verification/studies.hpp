#pragma once
// The studies of flow-studies; each prints rows of a table.

#include <cstdio>
#include <string>

namespace turgor {

/// A row of the table; rows of one panel and quantity are a series.
inline void print(const std::string& panel, const std::string& quantity, double x, double value) {
  std::printf("%s,%s,%.12g,%.12g\n", panel.c_str(), quantity.c_str(), x, value);
  std::fflush(stdout);
}

void orifice_inertance();
void coupled_modes();
void coupled_orders();
void elastic_tube();

}  // namespace turgor
