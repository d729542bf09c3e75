#include "turgor/fem/flow_run_folder.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "table_file.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

constexpr const char* field_folder = "fields";
constexpr const char* field_prefix = "flow-";
constexpr const char* field_ending = ".vtu";

const ResultFolder::Contents contents{"run directory",
                                      {"case.toml", "resolved.toml", "run.json", "history.csv", "solver.csv",
                                       "fields.pvd", "checkpoint.bin", "checkpoint.previous.bin"},
                                      {}};

ResultFolder opened(fs::path path, EarlierRun earlier) {
  if (earlier == EarlierRun::resume) return {std::move(path), contents};
  std::error_code error;
  if (earlier == EarlierRun::refuse && fs::is_directory(path, error)) {
    throw InvalidInput("", "", contents.what + " " + path.string() + ": exists already",
                       "go on with it with --resume, replace it with --force, or choose another with -o DIR");
  }
  return {std::move(path), contents, earlier == EarlierRun::replace};
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "fields/flow-00012.vtu"
std::string field_name(std::uint64_t number) {
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < 5 ? 5 - digits.size() : 0, '0');
  return std::string(field_folder) + "/" + field_prefix + digits + field_ending;
}

/// The number in "flow-00012.vtu" or "flow-00012.vtu.part"; nothing for other files.
std::optional<std::uint64_t> field_number(std::string name) {
  if (name.ends_with(".part")) name.resize(name.size() - 5);
  const std::string prefix = field_prefix;
  if (!name.starts_with(prefix) || !name.ends_with(field_ending)) return std::nullopt;
  const char* end = name.data() + name.size() - std::string(field_ending).size();
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

}  // namespace

FlowRunFolder::FlowRunFolder(fs::path path, const Case& c, EarlierRun earlier)
    : folder_(opened(std::move(path), earlier)),
      checkpoints_(folder_.path()),
      output_(c.output),
      kind_(history_kind(c)),
      case_hash_(fingerprint(c.resolved)) {
  if (earlier == EarlierRun::resume) {
    resume(c);
  } else {
    begin(c);
  }
}

FlowRunFolder::~FlowRunFolder() = default;

void FlowRunFolder::begin(const Case& c) {
  checkpoints_.remove();
  remove_fields_from(0);
  folder_.write_first("run.json", "{ \"status\": \"running\" }\n");
  folder_.write_first("case.toml", c.source);
  folder_.write_first("resolved.toml", c.resolved);
  std::error_code error;
  fs::create_directory(folder_.path() / field_folder, error);
  open_tables(c);
  write_series();
}

void FlowRunFolder::resume(const Case& c) {
  const auto refuse = [&](const std::string& problem, const std::string& advice) {
    throw InvalidInput("", "", contents.what + " " + folder_.path().string() + ": " + problem, advice);
  };
  const auto report = nlohmann::json::parse(text_of(folder_.path() / "run.json"), nullptr, false);
  if (report.is_object() && report.value("status", "") == "complete") {
    refuse("its run is complete", "replace it with --force, or choose another with -o DIR");
  }
  const std::string stored = text_of(folder_.path() / "resolved.toml");
  CheckpointFiles::Loaded loaded = checkpoints_.load();
  if (stored != c.resolved || loaded.checkpoint.case_hash != case_hash_) {
    refuse("belongs to another case; " + first_difference(stored, c.resolved),
           "start over with --force, or choose another with -o DIR");
  }
  warning_ = std::move(loaded.warning);
  start_ = std::move(loaded.checkpoint);
  open_tables(c);
  folder_.write("run.json", "{ \"status\": \"running\" }\n");
  const std::vector<double>& times = start_->field_times;
  remove_fields_from(times.size());
  for (std::uint64_t i = 0; i < times.size(); ++i) series_.push_back({times[i], field_name(i)});
  write_series();
}

void FlowRunFolder::open_tables(const Case& c) {
  const bool existing = start_.has_value();
  const auto open = [&](const char* name, const std::string& header, std::uint64_t rows) {
    return std::make_unique<TableFile>(folder_.path() / name, header, existing, rows);
  };
  history_ = open("history.csv", history_header(c.output, kind_), existing ? start_->history_rows : 0);
  solver_ = open("solver.csv", solver_header(c.output), existing ? start_->solver_rows : 0);
}

void FlowRunFolder::append(const FlowRow& row) { history_->append(history_line(output_, kind_, row)); }

void FlowRunFolder::append(const SolverRow& row) { solver_->append(solver_line(output_, row)); }

std::string FlowRunFolder::add_field(double time, const VtuGrid& field) {
  const std::string name = field_name(series_.size());
  folder_.write(name, vtu_text(field));
  series_.push_back({time, name});
  write_series();
  return fs::path(name).stem().string();
}

void FlowRunFolder::write_profile(const std::vector<OutflowPoint>& points) {
  std::string text = "Upsilon [1],f [1]\n";
  for (const OutflowPoint& point : points) text += shortest(point.upsilon) + "," + shortest(point.f) + "\n";
  folder_.write("profile.csv", text);
}

void FlowRunFolder::write_series() const { folder_.write("fields.pvd", pvd_text(series_)); }

void FlowRunFolder::remove_fields_from(std::uint64_t first) const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_.path() / field_folder, error)) {
    const auto number = field_number(entry.path().filename().string());
    if (number && *number >= first) fs::remove(entry.path(), error);
  }
}

void FlowRunFolder::save(Checkpoint checkpoint) {
  history_->sync();
  solver_->sync();
  checkpoint.case_hash = case_hash_;
  checkpoint.history_rows = history_->rows();
  checkpoint.solver_rows = solver_->rows();
  checkpoint.field_times.clear();
  for (const VtuInstant& instant : series_) checkpoint.field_times.push_back(instant.time);
  checkpoints_.save(checkpoint);
}

void FlowRunFolder::finish(const std::string& run_json, bool complete) {
  folder_.write("run.json", run_json);
  if (complete) checkpoints_.remove();
}

}  // namespace turgor
