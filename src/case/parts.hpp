#pragma once
// The parts a case is made of. Each declares its keys and reads them; later ones may use what earlier ones have read.

#include <span>
#include <string>
#include <vector>

#include "turgor/case/case.hpp"
#include "turgor/case/reader.hpp"

namespace turgor {

void declare_balloon(Schema& schema);  // [balloon] [material] [fluid] [inlet]
void read_balloon(Reader& reader, Case& c);

void declare_wall(Schema& schema);  // [wall]
void read_wall(Reader& reader, Case& c);

void declare_pressure(Schema& schema);  // [pressure]
void read_pressure(Reader& reader, Case& c);

void declare_motion(Schema& schema);  // [motion]
void read_motion(Reader& reader, Case& c);
/// Complains when the radius leaves what a balloon can have before t_end.
void check_motion(Reader& reader, const Case& c);

void declare_solve(Schema& schema);  // [solve]
void read_solve(Reader& reader, Case& c);

void declare_dynamics(Schema& schema);  // [initial] [model] [scales]
void read_dynamics(Reader& reader, Case& c);

void declare_report(Schema& schema);  // [output] [expect]
void read_report(Reader& reader, Case& c);

void declare_fem(Schema& schema);  // [fem]
void read_fem(Reader& reader, Case& c);

void declare_sweep(Schema& schema);  // [sweep]
void read_sweep(Reader& reader, Case& c);

struct Part {
  void (*declare)(Schema&);
  void (*read)(Reader&, Case&);
  std::vector<std::string> tables;
  bool uses_earlier;  ///< reads what earlier parts have put into the case
  bool of_a_member;   ///< the members of a sweep can differ in it
};

/// All parts in reading order.
[[nodiscard]] std::span<const Part> case_parts();

}  // namespace turgor
