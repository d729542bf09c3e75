#include "turgor/case/case.hpp"

#include <fstream>
#include <iterator>

#include "parts.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

std::span<const Part> case_parts() {
  static const std::vector<Part> parts{
      {declare_balloon, read_balloon, {"balloon", "material", "fluid", "inlet"}, false, true},
      {declare_wall, read_wall, {"wall"}, true, false},
      {declare_pressure, read_pressure, {"pressure"}, false, true},
      {declare_motion, read_motion, {"motion"}, false, false},
      {declare_solve, read_solve, {"solve"}, false, true},
      {declare_dynamics, read_dynamics, {"initial", "model", "scales"}, true, true},
      {declare_report, read_report, {"output", "expect"}, false, false},
      {declare_fem, read_fem, {"fem"}, true, false},
      {declare_sweep, read_sweep, {"sweep"}, false, false},
  };
  return parts;
}

const Schema& case_schema() {
  static const Schema schema = [] {
    Schema all;
    for (const Part& part : case_parts()) part.declare(all);
    return all;
  }();
  return schema;
}

Case parse_case(const std::string& text, const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const auto root = std::make_shared<Node>(parse_toml(text, file.string()));
  for (const std::string& assignment : overrides) apply_override(*root, assignment);

  Case c;
  c.file = file;
  c.source = text;
  Reader reader(case_schema(), *root);
  reader.check_unknown();
  for (const Part& part : case_parts()) part.read(reader, c);
  if (!reader.issues().empty()) throw InvalidInput(reader.issues());
  c.resolved = reader.resolved();
  c.tree = root;
  return c;
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code error;
  if (!stream || !std::filesystem::is_regular_file(file, error)) {
    throw InvalidInput("", "", "cannot read the case file " + file.string(), "give the path of a TOML file");
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_case(text, file, overrides);
}

void require_free_motion(const Case& c) {
  if (!c.motion) return;
  throw InvalidInput(
      {{"motion", "", "the case dictates the radius, so that there is no motion to compute",
        "`turgor force` gives the force of the liquid; or replace [motion] by [pressure]", c.file.string(), 0}});
}

const PrescribedMotion<double>& dictated_motion(const Case& c) {
  if (c.motion) return *c.motion;
  throw InvalidInput({{"motion", "", "the case has no [motion] table, which dictates the radius",
                       "replace [pressure], [initial] and [expect] by, for example,\n"
                       "[motion]\n"
                       "radius = \"" +
                           shortest(c.parameters.radius) +
                           " m\"\n"
                           "velocity = [{ to = \"2 cm/s\", over = \"0.5 s\", shape = \"smooth\" }, { to = \"0 cm/s\", "
                           "over = \"0.5 s\", shape = \"smooth\" }]",
                       c.file.string(), 0}});
}

std::string resolved_with(const Case& c, Model model) {
  const std::string automatic = "\nname = \"auto\"\n";
  std::string text = c.resolved;
  const std::size_t at = text.find(automatic, text.find("\n[model]\n"));
  if (at != std::string::npos) text.replace(at, automatic.size(), "\nname = \"" + std::string(name_of(model)) + "\"\n");
  return text;
}

}  // namespace turgor
