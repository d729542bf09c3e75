#include "turgor/figures/figures.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "makers.hpp"
#include "turgor/base/errors.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

struct Entry {
  Figure figure;
  void (*make)(Studio&);
};

const std::vector<Entry>& entries() {
  static const std::string orifice = "orifice-30mm.toml";
  static const std::string channel = "channel-30mm.toml";
  static const std::vector<Entry> all{
      {{"2",
        "The flow inside the balloon",
        "Deflation: the potential flow (2.6) with the pressure (A1), in the whole balloon and around its "
        "opening, at t = 35 s of the case, in the middle of the fall of its pressure. Inflation has no such "
        "flow: a jet enters, and the model takes the pressure as uniform, (2.3). The second picture shows "
        "both on the wall, inflation at t = 5 s; at the rim, where wall and outflow disagree, the potential "
        "flow has a singularity.",
        {channel},
        {"figure-2-streamlines", "figure-2-wall"},
        {"figure-2", "figure-2-wall"}},
       make_flow_figure},
      {{"3",
        "The force of the liquid on a balloon whose radius is dictated",
        "Top: change of the radius, velocity and minus the acceleration, each divided by its greatest size. "
        "Middle: the force without a channel. Bottom: with a channel of 50 cm. Dash-dotted the theoretical "
        "closure (2.12), dashed the corrected one (2.15); while the balloon inflates they agree, and without "
        "a channel are zero. The pressure at the inlet is zero, so that only the liquid's motion acts.",
        {"motion-orifice-5mm.toml", "motion-orifice-10mm.toml", "motion-orifice-20mm.toml", "motion-orifice-30mm.toml",
         "motion-channel-5mm.toml", "motion-channel-10mm.toml", "motion-channel-20mm.toml", "motion-channel-30mm.toml"},
        {"figure-3", "figure-3-peaks"},
        {"figure-3"}},
       make_force_figure},
      {{"4",
        "Balloons without a channel, filled and emptied",
        "R(t) by (2.23) with the corrected closure, and by the complete equation (2.22). All inflate with the "
        "pressure; the smaller the orifice, the slower they deflate. The program of the pressure is one like "
        "the paper's.",
        {"orifice-10mm.toml", "orifice-15mm.toml", "orifice-20mm.toml", orifice},
        {"figure-4"},
        {"figure-4"}},
       make_response_figure},
      {{"5",
        "The jet of a fast inflation, and the balloon that it stretches",
        "By finite elements, without damping of the wall: the wall, dashed where it was at the start, streamlines and "
        "speed. The pressure comes faster than the balloon can follow; the jet through the orifice stretches it at the "
        "pole, and the wall swings back. Among the panels are the one in which the balloon is longest for its width "
        "and, after it, the one in which its liquid lies highest for its height. Between neighbouring streamlines of a "
        "panel runs the same flux; it is in the table.",
        {"jet-orifice-30mm.toml"},
        {"figure-5", "figure-5-walls", "figure-5-streamlines"},
        {"figure-5"},
        {"figure-5-film"},
        true},
       make_jet_figure},
      {{"6",
        "Balloons with a channel, filled and emptied",
        "R(t) by (2.25) with the corrected closure, and by the complete equation (2.22). The liquid in the "
        "channel of 50 cm slows down inflation; how fast a balloon empties is a matter of the radius alone.",
        {"channel-10mm.toml", "channel-15mm.toml", channel},
        {"figure-6"},
        {"figure-6"}},
       make_response_figure},
      {{"7",
        "The balloon at rest",
        "First picture: static pressure (3.1), with the pressures at which there are two stable states in "
        "grey, and the potential energy (3.2) at their mean. Second: the closed approximations (3.3) of the "
        "small and (3.5) of the large stable state, where they have real values. S1/S2 = 10.",
        {orifice},
        {"figure-7", "figure-7-approximations"},
        {"figure-7", "figure-7-approximations"}},
       make_statics_figure},
      {{"8",
        "Free motion about the larger equilibrium, and its closed approximations",
        "From rest, left without and right with a channel, at the mean of the limit pressures, 41.3136 kPa: "
        "exact by quadrature, and by the piecewise solution of section 3.3, (3.16) until (3.17) and then "
        "(3.18) or (3.19) until pi/alpha, two half-cycles of each. Both axes of rates go with the square "
        "root, and each half has a scale of its own.",
        {orifice, channel},
        {"figure-8"},
        {"figure-8"}},
       make_approach_figure},
      {{"9",
        "Phase portraits of a bistable balloon",
        "First without, then with a channel, at the mean of the limit pressures: inflation along level sets "
        "such as (3.22), deflation that falls onto the slow manifold (3.21), basins of both stable states and "
        "the separatrix between them. Exact to rounding, without time stepping; the axes are as in figure 8.",
        {orifice, channel},
        {"figure-9-orifice", "figure-9-channel"},
        {"figure-9-orifice", "figure-9-channel"}},
       make_portraits_figure},
      {{"decay",
        "How small oscillations die out",
        "Upper turning points of free oscillations about the larger equilibrium, each times beta: exact by "
        "quadrature, by half-cycles with Lambert's W function, which in these units are the same for all "
        "balloons, and their limit 3/(4n). Amplitudes fall like 1/n, not exponentially: the outflow takes "
        "energy by the cube of the rate.",
        {orifice, channel},
        {"figure-decay"},
        {"figure-decay"}},
       make_decay_figure},
      {{"errors",
        "The error of every closed approximation",
        "Against exact solutions, for the balloon with a channel at the mean of its limit pressures. "
        "Equilibria: (3.3) and (3.5). Deflation from rest at R = 5: outer (3.9), inner (3.12) and composite "
        "(3.16) expansion, and the solution that stays uniform through the slow motion and the turning point. "
        "Inflation: (3.18), (3.19) and the third order, the worst of four instants of the half-cycle. "
        "Durations: (3.17) and the uniform solution of deflation, pi/alpha and its correction of inflation. T "
        "is in units of deflation's own time (3.7).",
        {channel},
        {"figure-errors-equilibria", "figure-errors-deflation", "figure-errors-inflation", "figure-errors-times"},
        {"figure-errors"}},
       make_errors_figure},
      {{"bistability",
        "Which Mooney-Rivlin balloons have two stable states",
        "The pressures between minimum and maximum of (3.1) against S1/S2; at Maxwell's pressure both states "
        "lie equally deep. The window opens at a cusp, at S1/S2 = 4.6629. The dot is the balloon of the other "
        "figures at the mean of its limit pressures.",
        {orifice},
        {"figure-bistability"},
        {"figure-bistability"}},
       make_bistability_figure},
      {{"design",
        "How long a balloon takes to fill and to empty",
        "625 openings, by the complete equation (2.22). Left: the pressure is stepped from 0 to 36 kPa; time "
        "from 10 % to 90 % of the way to the first peak. Right: it is stepped back to 0 when the balloon is "
        "at rest; time from 10 % to 90 % of the way to the next turning point. The length of the channel "
        "governs how fast the balloon fills, and hardly how fast it empties: both can be designed one after "
        "the other.",
        {channel},
        {"figure-design"},
        {"figure-design"}},
       make_design_figure}};
  return all;
}

}  // namespace

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> figures = [] {
    std::vector<Figure> all;
    all.reserve(entries().size());
    for (const Entry& entry : entries()) all.push_back(entry.figure);
    return all;
  }();
  return figures;
}

const Figure& find_figure(const std::string& name) {
  const auto& all = all_figures();
  const auto found = std::ranges::find(all, name, &Figure::name);
  if (found != all.end()) return *found;
  std::string names;
  for (const Figure& figure : all) names += figure.name + ", ";
  throw InvalidInput("figure", "\"" + name + "\"", "there is no such figure", "known are " + names + "and all");
}

fs::path shipped_cases(const fs::path& program) {
  const fs::path folder = program.parent_path();
  for (const char* relative : {TURGOR_INSTALLED_CASES, TURGOR_SOURCE_CASES}) {
    std::error_code error;
    if (fs::is_directory(folder / relative, error)) return (folder / relative).lexically_normal();
  }
  throw InvalidInput("--cases", "", "the case files that ship with turgor are not beside the program",
                     "name their folder: --cases DIR; it is " +
                         (folder / TURGOR_INSTALLED_CASES).lexically_normal().string() + " when turgor is installed");
}

std::optional<Issue> lacking_run(const Figure& figure, const fs::path& cases, const fs::path& fem) {
  if (!figure.needs_fem) return std::nullopt;
  const std::string& file = figure.cases.front();
  const std::string run = fs::path(file).stem().string() + ".fem";
  std::error_code error;
  if (!fem.empty() && fs::is_directory(fem / run, error)) return std::nullopt;
  return Issue{"--fem",
               fem.empty() ? "" : "\"" + fem.string() + "\"",
               "figure " + figure.name + " shows a run of finite elements, " + run +
                   (fem.empty() ? "" : ", and there is none in this folder"),
               "compute it with a turgor built by `./dev build fem`: `turgor fem fsi " + (cases / file).string() +
                   "`; then `turgor figure " + figure.name + " --fem .`",
               "",
               0};
}

ResultFolder::Contents contents_of(std::span<const Figure* const> figures) {
  ResultFolder::Contents contents{"folder of figures", {"index.md", "figures.json"}, {}, {}};
  for (const Figure* figure : figures) {
    for (const std::string& table : figure->tables) contents.files.push_back(table + ".csv");
    contents.pictures.insert(contents.pictures.end(), figure->pictures.begin(), figure->pictures.end());
    contents.films.insert(contents.films.end(), figure->films.begin(), figure->films.end());
  }
  return contents;
}

MadeFigure make_figure(const Figure& figure, const fs::path& cases, const ResultFolder& folder, bool pictures,
                       const fs::path& fem) {
  const auto entry = std::ranges::find(entries(), figure.name, [](const Entry& e) { return e.figure.name; });
  Studio studio(figure, cases, folder, pictures, fem);
  entry->make(studio);
  return studio.made();
}

namespace {

/// "`a`, `b`"
std::string listed(const std::vector<std::string>& names, const std::string& ending) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "`" : ", `") + name + ending + "`";
  return out;
}

/// "Figure 3: title" of the paper's figures, the title alone of the others.
std::string heading(const Figure& figure) {
  const bool of_paper = figure.name.find_first_not_of("0123456789") == std::string::npos;
  return (of_paper ? "Figure " + figure.name + ": " : "") + figure.title;
}

Json to_json(const Figure& figure) {
  return {{"name", figure.name},          {"title", figure.title},       {"cases", figure.cases},
          {"tables", figure.tables},      {"pictures", figure.pictures}, {"films", figure.films},
          {"needs_fem", figure.needs_fem}};
}

std::string dumped(const Json& document) { return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string figures_index(std::span<const MadeFigure> made) {
  std::string out =
      "# Figures\n\nThe figures of Ilssar & Gat (arXiv:1908.04074) that a reduced-order model can make, by the numbers "
      "they have there, and some of turgor's own. `turgor figure all` makes them from the case files that ship, each "
      "with "
      "its numbers as CSV beside it; `turgor figure NAME` makes one.\n";
  for (const MadeFigure& m : made) {
    const Figure& figure = *m.figure;
    out += "\n## " + heading(figure) + "\n\n";
    if (!m.failure.empty() || !m.lacking.empty()) {
      out += "Not made: " + m.failure + m.lacking + "\n";
      continue;
    }
    for (const std::string& file : m.files) {
      if (file.ends_with(".png") || file.ends_with(".gif")) out += "![" + figure.title + "](" + file + ")\n";
    }
    out += "\n" + figure.caption + m.note + "\n\n`turgor figure " + figure.name + (figure.needs_fem ? " --fem ." : "") +
           "` · cases " + listed(figure.cases, "") + " · numbers " + listed(figure.tables, ".csv") + "\n";
  }
  return out;
}

std::string figures_json(std::span<const Figure> figures) {
  Json list = Json::array();
  for (const Figure& figure : figures) list.push_back(to_json(figure));
  return dumped({{"figures", list}});
}

std::string figures_json(std::span<const MadeFigure> made, const fs::path& folder) {
  Json list = Json::array();
  bool complete = true;
  for (const MadeFigure& m : made) {
    Json figure{{"name", m.figure->name}, {"title", m.figure->title}, {"cases", m.figure->cases}, {"files", m.files}};
    for (const auto& [key, text] :
         {std::pair{"picture_problem", m.picture_problem}, {"failure", m.failure}, {"lacking", m.lacking}}) {
      figure[key] = text.empty() ? Json(nullptr) : Json(text);
    }
    complete = complete && m.failure.empty();
    list.push_back(std::move(figure));
  }
  return dumped({{"status", complete ? "complete" : "failed"}, {"folder", folder.string()}, {"figures", list}});
}

}  // namespace turgor
