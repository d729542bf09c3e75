#pragma once
// A case: one balloon and the question asked of it, as read from a TOML file.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "turgor/case/node.hpp"
#include "turgor/case/schema.hpp"
#include "turgor/case/sweep.hpp"
#include "turgor/motion/prescribed_motion.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

/// How a run follows the balloon.
enum class Method {
  adaptive,    ///< simulate(), for every pressure program
  quadrature,  ///< simulate_by_quadrature(), for piecewise constant pressure
};
/// "adaptive" or "quadrature".
[[nodiscard]] std::string_view name_of(Method method);

/// How to integrate and which times to write.
struct SolveSettings {
  Method method;
  double t_end;  ///< [s]
  double rtol;
  double atol;
  long samples;               ///< uniform rows from 0 to t_end, both included; 0 when times are given
  std::vector<double> times;  ///< [s]; rows at exactly these times
  long max_events;            ///< 0: no limit
  double rest_tol;            ///< 0: never
  long max_steps;
};

/// What holds where the liquid meets the channel and the outside, for the finite elements.
struct InletConditions {
  bool slip;              ///< the channel's wall lets the liquid slip along it
  bool tangential_free;   ///< no shear traction at the inlet plane, as opposed to no radial velocity
  bool total_pressure;    ///< entering liquid has the pressure at rest outside, as opposed to at the inlet plane
  double inflow_penalty;  ///< beta: keeps the inflow profile at its mean by a traction beta rho U (u_n - U)
};

/// The wall as an elastic membrane, for coupled finite elements.
struct WallSettings {
  double bending_stiffness;  ///< D [N m]
  double damping_time;       ///< eta of the Kelvin-Voigt damping [s]
  bool clamped;              ///< at the rim; else hinged
};

/// Backward differences of first or second order.
enum class FemScheme { bdf1, bdf2 };
/// "bdf1" or "bdf2".
[[nodiscard]] std::string_view name_of(FemScheme scheme);

/// How `turgor fem` discretises, and what it writes.
struct FemSettings {
  FemScheme scheme;
  double cfl;              ///< step times velocity in the orifice over its radius; 0: the step is fixed
  double time_step;        ///< [s]; 0: by cfl
  double error_tolerance;  ///< largest local error of a step, relative; 0: no such control
  double tolerance;        ///< of the nonlinear solve: error that it leaves, relative
  long max_iterations;     ///< of the nonlinear solve
  long max_steps;
  double h_rim, h_orifice, h_wall;  ///< cell sizes [m]
  double checkpoint_every;          ///< wall-clock time [s]; 0: after every step
  long fields;                      ///< uniform times of fields; 0 when times are given, or for none
  std::vector<double> field_times;  ///< [s]
};

/// Units of tables and pictures.
struct OutputSettings {
  std::string time_unit, length_unit, pressure_unit, volume_unit, flow_unit, energy_unit;
  bool pictures;
};

/// An expected quantity of interest: |quantity - value| <= tolerance, in SI units.
struct Expectation {
  std::string quantity;
  double value;
  double tolerance;
};

struct Case {
  std::string title;
  Parameters<double> parameters;
  std::string material_name;
  PressureProgram<double> pressure = constant_pressure(0.0);
  std::optional<PrescribedMotion<double>> motion;  ///< then stretch and stretch_rate mean nothing
  double stretch = 1;
  double stretch_rate = 0;     ///< [1/s]
  double max_stretch = 0;      ///< 0: never bursts
  std::optional<Model> model;  ///< nothing: chosen by the size of the dropped terms
  double auto_tolerance = 0.05;
  Scales<double> scales{};
  InletConditions inlet{};
  WallSettings wall{};
  SolveSettings solve{};
  FemSettings fem{};
  OutputSettings output{};
  std::vector<Expectation> expectations;
  std::optional<SweepSettings> sweep;

  std::filesystem::path file;        ///< where it was read from
  std::string source;                ///< the file, verbatim
  std::string resolved;              ///< everything resolved, as TOML; running it again gives identical results
  std::shared_ptr<const Node> tree;  ///< the file with its overrides, as parsed
};

/// All keys that a case file can have.
[[nodiscard]] const Schema& case_schema();

/// Reads a case file.
/// @param overrides  "table.key=value", applied in order
/// @throws InvalidInput with every issue that could be found
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from text; relative file names in it start from file's folder.
[[nodiscard]] Case parse_case(const std::string& text, const std::filesystem::path& file,
                              const std::vector<std::string>& overrides = {});

/// For what integrates the motion of a balloon.
/// @throws InvalidInput when the case dictates the motion
void require_free_motion(const Case& c);

/// The dictated motion of a case.
/// @throws InvalidInput when the case has none, with an example to copy
[[nodiscard]] const PrescribedMotion<double>& dictated_motion(const Case& c);

/// The resolved case with the model that was chosen for `model.name = "auto"`.
[[nodiscard]] std::string resolved_with(const Case& c, Model model);

}  // namespace turgor
