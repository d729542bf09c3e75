// turgor flow: the flow inside a deflating balloon at one instant.

#include <cmath>
#include <iostream>
#include <optional>
#include <set>
#include <string_view>

#include "commands.hpp"
#include "numbers.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/case/profile.hpp"
#include "turgor/case/units.hpp"
#include "turgor/run/flow_report.hpp"
#include "turgor/run/result_folder.hpp"
#include "turgor/view/flow_picture.hpp"

namespace turgor::cli {

namespace {

constexpr const char* example = "write --at 'stretch=1.1, rate=-0.1 1/s'";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view around = " \t\"'";
  const std::size_t from = text.find_first_not_of(around);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(around) - from + 1);
}

/// @param bare  whether a number without a unit is taken as one in `unit`
double value_of(const std::string& word, std::string_view text, const std::string& unit, bool bare) {
  if (bare) {
    if (const auto number = plain_number(text)) return *number;
  }
  if (unit == "1") throw InvalidInput(word, std::string(text), "is not a finite number", "write for example 1.1");
  return parse_argument(word, text, unit);
}

/// One "word=value" of --at.
void read_word(const std::string& word, std::string_view text, FlowInstant& instant) {
  if (word == "stretch") {
    instant.stretch = value_of(word, text, "1", true);
  } else if (word == "rate") {
    instant.rate = value_of(word, text, "1/s", true);
  } else if (word == "acceleration") {
    instant.acceleration = value_of(word, text, "1/s^2", true);
  } else if (word == "time") {
    instant.time = value_of(word, text, "s", false);
    if (instant.time < 0) throw InvalidInput(word, std::string(text), "out of range", "allowed is >= 0 s");
  } else if (word == "pressure") {
    instant.pressure = value_of(word, text, "Pa", false);
  } else {
    throw InvalidInput("--at", word, "unknown word",
                       "known are stretch, rate, acceleration, time and pressure; " + std::string(example));
  }
}

FlowInstant parse_instant(std::string_view text) {
  FlowInstant instant{};
  std::set<std::string> seen;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos) {
      throw InvalidInput("--at", "\"" + std::string(item) + "\"", "is not of the form word=value", example);
    }
    const std::string word(trimmed(item.substr(0, equals)));
    if (!seen.insert(word).second) throw InvalidInput("--at", word, "is given twice");
    read_word(word, trimmed(item.substr(equals + 1)), instant);
  }
  for (const char* needed : {"stretch", "rate"}) {
    if (!seen.contains(needed)) throw InvalidInput("--at", "", std::string(needed) + " is missing", example);
  }
  if (seen.contains("time") && seen.contains("pressure")) {
    throw InvalidInput("--at", "pressure", "time only says which pressure of the case's program to take",
                       "give one of time and pressure");
  }
  return instant;
}

}  // namespace

CLI::App* add_flow(CLI::App& app, FlowArguments& arguments) {
  CLI::App* command = app.add_subcommand("flow", "the flow inside a deflating balloon at one instant");
  add_case(*command, arguments.input);
  command
      ->add_option("--at", arguments.at,
                   "stretch=R, rate=dR/dt, and if wanted acceleration=d2R/dt2 (default: by the equation of motion), "
                   "pressure=\"20 kPa\" (gauge, at the inlet) or time=\"2 s\" (default 0 s) to take it from the case")
      ->required()
      ->type_name("WORD=VALUE,...");
  add_results(*command, arguments.results, "the case file's name with .flow");
  command->add_option("--profile", arguments.profile, "outflow profile, as for `turgor profile`; default: uniform")
      ->type_name("FILE.csv");
  command->add_option("--resolution", arguments.resolution, "cells of the mesh in each direction; default 200")
      ->check(CLI::Range(10, 4000))
      ->type_name("N");
  command->add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  return command;
}

int write_flow(const FlowArguments& arguments) {
  const Case c = read_case(arguments.input.file, arguments.input.overrides);
  const FlowSnapshot snapshot(c, parse_instant(arguments.at),
                              arguments.profile.empty() ? OutflowProfile::uniform() : read_profile(arguments.profile));
  const std::string directory = arguments.results.directory;
  const ResultFolder folder(directory.empty() ? c.file.stem().string() + ".flow" : directory,
                            {"flow directory", {"case.toml", "flow.vtu", "wall.csv", "flow.json"}, {"flow"}},
                            arguments.results.force);
  folder.write_first("case.toml", c.source);
  const MeridionalFlow field(snapshot.flow(), arguments.resolution);
  folder.write("flow.vtu", flow_vtu(snapshot, field));
  folder.write("wall.csv", wall_csv(snapshot));
  const std::string json = flow_json(c, snapshot, field);
  folder.write("flow.json", json);
  std::string problem;
  if (c.output.pictures && !arguments.results.no_pictures) problem = draw_flow(c, snapshot, field, folder.path());
  if (arguments.input.json) {
    std::cout << json;
  } else if (!arguments.quiet) {
    std::cout << flow_summary(c, snapshot) << "  written to " << folder.path().string() << "\n";
  }
  if (!problem.empty() && !arguments.quiet) std::cerr << "warning: " << problem << "\n";
  return exit_done;
}

}  // namespace turgor::cli
