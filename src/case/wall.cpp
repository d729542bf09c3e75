#include "parts.hpp"

namespace turgor {

void declare_wall(Schema& schema) {
  using enum ValueKind;
  schema.describe("wall", "the wall as an elastic membrane, for coupled finite elements; the model has no use for it");
  schema.add({.path = "wall.bending_stiffness",
              .unit = "N m",
              .range = not_negative,
              .choices = {"auto"},
              .fallback = "auto",
              .meaning = "bending stiffness D of the wall; auto: mu d0^3/3, that of its thickness"});
  schema.add({.path = "wall.damping_time",
              .unit = "s",
              .range = not_negative,
              .fallback = "0 s",
              .meaning = "eta of the Kelvin-Voigt damping, stress eta d/dt(dW/dlambda) in addition; 0: none"});
  schema.add({.path = "wall.rim",
              .kind = text,
              .choices = {"hinged", "clamped"},
              .fallback = "hinged",
              .meaning = "whether the wall turns freely where it meets the orifice, or keeps its direction"});
}

void read_wall(Reader& reader, Case& c) {
  const std::string key = "wall.bending_stiffness";
  if (reader.node(key) == nullptr || reader.is_word(key, "auto")) {
    c.wall.bending_stiffness = bending_stiffness(c.parameters.material, c.parameters.thickness);
    reader.resolve(key, [&] { return toml_quantity(c.wall.bending_stiffness, "N m"); });
  } else {
    c.wall.bending_stiffness = reader.number(key).value_or(0);
  }
  c.wall.damping_time = reader.number("wall.damping_time").value_or(0);
  c.wall.clamped = reader.text("wall.rim") == "clamped";
}

}  // namespace turgor
