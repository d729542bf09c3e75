#include <nlohmann/json.hpp>

#include "turgor/base/text.hpp"
#include "turgor/base/version.hpp"
#include "turgor/fem/run_flow.hpp"
#include "turgor/run/report.hpp"

namespace turgor {

using Json = nlohmann::ordered_json;

std::string flow_run_json(const Case& c, const FlowRunResult& result, const FlowRunOptions& options) {
  Json versions{{"turgor", version}, {"compiler", compiler}};
  for (const auto& [library, number] : options.versions) versions[library] = number;
  Json warnings = Json::array();
  for (const Warning& warning : result.warnings) warnings.push_back({{"name", warning.name}, {"text", warning.text}});
  const FemSettings& fem = c.fem;
  const Json document{{"title", c.title},
                      {"status", result.status},
                      {"message", result.message},
                      {"versions", versions},
                      {"discretisation",
                       {{"scheme", name_of(fem.scheme)},
                        {"cells", result.size.cells},
                        {"unknowns", result.size.unknowns},
                        {"h_rim_m", fem.h_rim},
                        {"h_orifice_m", fem.h_orifice},
                        {"h_wall_m", fem.h_wall}}},
                      {"steps", result.steps},
                      {"work",
                       {{"nonlinear_iterations", result.nonlinear_iterations},
                        {"linear_iterations", result.linear_iterations},
                        {"factorisations", result.factorisations}}},
                      {"timings", {{"integration_s", result.wall_seconds}}},
                      {"final_state", {{"t_s", result.time}, {"r_m", result.radius}, {"drdt_m_per_s", result.rate}}},
                      {"warnings", warnings}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string flow_run_summary(const Case& c, const FlowRunResult& result) {
  std::string out = c.title + "\n" +
                    summary_line("mesh", std::to_string(result.size.cells) + " cells, " +
                                             std::to_string(result.size.unknowns) + " unknowns") +
                    summary_line("time", rounded(result.time, 8) + " of " + rounded(c.solve.t_end, 8) + " s in " +
                                             std::to_string(result.steps) + " steps") +
                    summary_line("computed in", rounded(result.wall_seconds, 3) + " s");
  for (const Warning& warning : result.warnings) out += "  warning: " + warning.text + "\n";
  return out;
}

}  // namespace turgor
