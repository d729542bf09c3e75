#include "material.hpp"
#include "parts.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

void declare_balloon(Schema& schema) {
  using enum ValueKind;
  schema.add({.path = "title", .kind = text, .meaning = "shown in pictures and summaries"});

  schema.describe("balloon", "the unstretched balloon");
  schema.add({.path = "balloon.radius", .unit = "m", .range = positive, .required = true, .meaning = "radius r0"});
  schema.add(
      {.path = "balloon.thickness", .unit = "m", .range = positive, .required = true, .meaning = "wall thickness d0"});
  schema.add({.path = "balloon.density",
              .unit = "kg/m^3",
              .range = positive,
              .required = true,
              .meaning = "density of the wall"});

  declare_material(schema);

  schema.describe("fluid", "the liquid");
  schema.add({.path = "fluid.density", .unit = "kg/m^3", .range = positive, .required = true, .meaning = "density"});
  schema.add({.path = "fluid.viscosity",
              .unit = "Pa s",
              .range = positive,
              .required = true,
              .meaning =
                  "dynamic viscosity; the model is inviscid, for which this judges whether that holds; `turgor fem` is "
                  "not"});

  schema.describe("inlet", "orifice and channel");
  schema.add({.path = "inlet.orifice_radius",
              .unit = "m",
              .range = positive,
              .required = true,
              .meaning = "radius r_ch of orifice and channel; less than the balloon's"});
  schema.add({.path = "inlet.channel_length",
              .unit = "m",
              .range = not_negative,
              .fallback = "0 m",
              .meaning = "length L_ch of the channel; 0 for a bare orifice"});
  schema.add({.path = "inlet.wall",
              .kind = text,
              .choices = {"no-slip", "slip"},
              .fallback = "no-slip",
              .meaning = "for `turgor fem`: whether the liquid sticks to the channel's wall"});
  schema.add({.path = "inlet.tangential",
              .kind = text,
              .choices = {"free", "zero"},
              .fallback = "free",
              .meaning = "for `turgor fem`: the radial velocity at the inlet plane, free of shear or held at zero"});
  schema.add({.path = "inlet.pressure",
              .kind = text,
              .choices = {"static", "total"},
              .fallback = "static",
              .meaning =
                  "for `turgor fem`: what the pressure program is of entering liquid, the static pressure at the "
                  "inlet plane (the paper's), or the total one, rho U^2/2 of the mean velocity U more, as from a "
                  "vessel at rest; leaving liquid has the static one in both"});
  schema.add({.path = "inlet.inflow_penalty",
              .kind = number,
              .range = not_negative,
              .fallback = "0.5",
              .meaning =
                  "for `turgor fem`: beta of the traction beta rho U (u_n - U) that keeps inflow of mean velocity U "
                  "even; the mean traction stays that of the pressure"});
}

void read_balloon(Reader& reader, Case& c) {
  const auto title = reader.text("title");
  c.title = title ? *title : c.file.empty() ? "balloon" : c.file.stem().string();
  reader.resolve("title", [&] { return toml_string(c.title); });
  Parameters<double>& p = c.parameters;
  const auto radius = reader.number("balloon.radius");
  const auto thickness = reader.number("balloon.thickness");
  p.radius = radius.value_or(1);
  p.thickness = thickness.value_or(1);
  p.solid_density = reader.number("balloon.density").value_or(1);
  read_material(reader, c);
  p.fluid_density = reader.number("fluid.density").value_or(1);
  p.fluid_viscosity = reader.number("fluid.viscosity").value_or(1);
  const auto orifice = reader.number("inlet.orifice_radius");
  p.orifice_radius = orifice.value_or(1);
  p.channel_length = reader.number("inlet.channel_length").value_or(0);
  c.inlet = {reader.text("inlet.wall") == "slip", reader.text("inlet.tangential") != "zero",
             reader.text("inlet.pressure") == "total", reader.number("inlet.inflow_penalty").value_or(0)};
  if (radius && thickness && *thickness >= *radius) {
    reader.complain("balloon.thickness", "the wall is as thick as the balloon",
                    "must be less than balloon.radius, and much less for a membrane");
  }
  if (radius && orifice && *orifice >= *radius) {
    reader.complain(
        "inlet.orifice_radius", "the orifice is larger than the balloon",
        "must be less than balloon.radius = " + shortest(*radius) + " m; the model wants a tenth of it or less");
  }
}

}  // namespace turgor
