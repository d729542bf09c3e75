#include "result_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>

#include "chunk.hpp"
#include "netcdf_file.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/version.hpp"
#include "turgor/case/quantities.hpp"

namespace turgor {

namespace {

constexpr std::array<Outcome, 8> outcomes{Outcome::reached_end, Outcome::at_rest,    Outcome::max_events,
                                          Outcome::burst,       Outcome::runaway,    Outcome::step_failed,
                                          Outcome::max_steps,   Outcome::closure_end};
constexpr std::array<Model, 3> models{Model::full, Model::orifice, Model::long_channel};

/// Rows that are written at once: enough that a call to the library costs nothing beside them.
constexpr std::size_t buffered_rows = 8192;

double number_in(const Node& node) {
  if (const auto* exact = node.as<Node::Quantity>()) return exact->value;
  if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
  const auto* number = node.as<double>();
  return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

bool has_words(const Axis& axis) {
  const auto* list = std::get_if<AxisValues>(&axis.form);
  return list != nullptr && std::ranges::any_of(list->values, [](const Node& v) { return v.as<std::string>(); });
}

std::string word_in(const Node& node) {
  const auto* word = node.as<std::string>();
  return word != nullptr ? *word : node.text();
}

/// Which members a picture shows.
class Thinning {
 public:
  explicit Thinning(const SweepPlan& plan) : plan_(plan) {
    constexpr std::uint64_t most_cells = 400;    // of a map, each way
    constexpr std::uint64_t most_points = 5000;  // of a curve or cloud
    const SweepSettings& s = plan.settings();
    if (s.sampler == Sampler::grid && s.axes.size() == 2) {
      for (const Axis& axis : s.axes) strides_.push_back((axis.count() + most_cells - 1) / most_cells);
      return;
    }
    stride_ = (s.members + most_points - 1) / most_points;
    while (s.axes.size() > 1 && std::gcd(stride_, s.members) > 1) ++stride_;  // else it may keep to a row of the grid
  }

  [[nodiscard]] bool keeps(std::uint64_t member) const {
    if (strides_.empty()) return member % stride_ == 0;
    const auto at = plan_.indices(member);
    return at[0] % strides_[0] == 0 && at[1] % strides_[1] == 0;
  }

 private:
  const SweepPlan& plan_;
  std::vector<std::uint64_t> strides_;  ///< of a map
  std::uint64_t stride_ = 1;
};

/// Collects the rows of all chunks in order and writes them variable by variable.
class ResultWriter {
 public:
  ResultWriter(const std::filesystem::path& file, const Case& c, SweepPlan plan)
      : file_(file), case_(c), plan_(std::move(plan)), asked_(questions_of(plan_.settings())), thinning_(plan_) {
    describe();
    if (plan_.settings().sampler == Sampler::grid) {
      define_grid();
    } else {
      define_samples();
    }
    define_results();
  }

  void add(const ChunkResult& chunk) {
    std::vector<int> numbers{0};  // of the chunk's messages among all
    numbers.reserve(chunk.messages.size() + 1);
    for (const std::string& message : chunk.messages) numbers.push_back(number_of(message));
    for (std::size_t i = 0; i < chunk.size(); ++i) {
      const double* row = chunk.row(i);
      outcome_rows_.push_back(static_cast<signed char>(row[0]));
      model_rows_.push_back(static_cast<signed char>(row[1]));
      const int message = numbers.at(static_cast<std::size_t>(row[2]));
      failure_rows_.push_back(message - 1);
      if (message > 0) ++summary_.failures[static_cast<std::size_t>(message - 1)].second;
      add_numbers(row + ChunkResult::leading_columns);
      sample(row + ChunkResult::leading_columns);
    }
    if (outcome_rows_.size() >= buffered_rows) flush();
  }

  SweepSummary finish() {
    flush();
    if (summary_.members != plan_.members()) throw ComputationFailed("the journal misses members");
    if (!summary_.failures.empty()) {
      std::vector<std::string> texts;
      texts.reserve(summary_.failures.size());
      for (const auto& [text, count] : summary_.failures) texts.push_back(text);
      const auto variable = file_.strings("failure_message", {file_.dimension("failure_kind", texts.size())});
      file_.attribute(&variable, "long_name", "what the values of `failure` stand for");
      file_.put(variable, texts);
    }
    file_.close();
    for (const auto& [text, count] : summary_.failures) summary_.failed += count;
    for (QuantitySummary& quantity : summary_.quantities) quantity.mean /= static_cast<double>(quantity.count);
    return std::move(summary_);
  }

 private:
  void describe() {
    const SweepSettings& s = plan_.settings();
    file_.attribute(nullptr, "Conventions", std::string("CF-1.10"));
    file_.attribute(nullptr, "title", case_.title);
    file_.attribute(nullptr, "turgor_version", std::string(version));
    file_.attribute(nullptr, "status", std::string("complete"));
    file_.attribute(nullptr, "sampler", std::string(name_of(s.sampler)));
    file_.attribute(nullptr, "seed", static_cast<std::int64_t>(s.seed));
    file_.attribute(nullptr, "instructions", std::string(member_instructions()));
    file_.attribute(nullptr, "case", case_.source);
    file_.attribute(nullptr, "case_resolved", case_.resolved);
  }

  void define_grid() {
    for (const Axis& axis : plan_.settings().axes) {
      const std::vector<Node> values = grid_values(axis);
      dimensions_.push_back(file_.dimension(netcdf_name(axis.key), values.size()));
      const auto variable = define_axis(axis, dimensions_.back());
      if (has_words(axis)) {
        std::vector<std::string> words;
        words.reserve(values.size());
        for (const Node& value : values) words.push_back(word_in(value));
        file_.put(variable, words);
      } else {
        std::vector<double> numbers;
        numbers.reserve(values.size());
        for (const Node& value : values) numbers.push_back(number_in(value));
        file_.put(variable, 0, numbers);
      }
    }
  }

  void define_samples() {
    dimensions_.push_back(file_.dimension("member", plan_.members()));
    for (const Axis& axis : plan_.settings().axes) {
      axes_.push_back(define_axis(axis, dimensions_.front()));
      axis_rows_.emplace_back();
    }
  }

  NetcdfFile::Variable define_axis(const Axis& axis, NetcdfFile::Dimension dimension) {
    const std::string name = netcdf_name(axis.key);
    const auto variable = has_words(axis) ? file_.strings(name, {dimension}) : file_.doubles(name, {dimension});
    file_.attribute(&variable, "long_name", axis.key);
    if (!axis.unit.empty()) file_.attribute(&variable, "units", axis.unit);
    return variable;
  }

  NetcdfFile::Variable define_number(const std::string& name, const std::vector<NetcdfFile::Dimension>& dimensions,
                                     const std::string& unit, const std::string& meaning) {
    const auto variable = file_.doubles(name, dimensions);
    file_.attribute(&variable, "_FillValue", std::numeric_limits<double>::quiet_NaN());
    file_.attribute(&variable, "units", unit);
    file_.attribute(&variable, "long_name", meaning);
    return variable;
  }

  void define_results() {
    outcome_ = file_.bytes("outcome", dimensions_);
    std::vector<signed char> values{invalid_member};
    std::string meanings = "invalid";
    for (const Outcome outcome : outcomes) {
      values.push_back(static_cast<signed char>(outcome));
      meanings += " " + std::string(name_of(outcome));
    }
    file_.attribute(&outcome_, "long_name", "why the member's run ended; invalid: its values make no case");
    file_.attribute(outcome_, "flag_values", values);
    file_.attribute(&outcome_, "flag_meanings", meanings);
    model_ = file_.bytes("model", dimensions_);
    values.clear();
    meanings.clear();
    for (const Model model : models) {
      values.push_back(static_cast<signed char>(model));
      meanings += (meanings.empty() ? "" : " ") + std::string(name_of(model));
    }
    file_.fill_value(model_, static_cast<signed char>(-1));
    file_.attribute(&model_, "long_name", "equation of motion");
    file_.attribute(model_, "flag_values", values);
    file_.attribute(&model_, "flag_meanings", meanings);
    failure_ = file_.integers("failure", dimensions_);
    file_.fill_value(failure_, -1);
    file_.attribute(&failure_, "long_name", "index in failure_message of what went wrong; missing where nothing did");
    for (const std::size_t index : asked_.quantities) {
      const QuantityName& name = quantity_names()[index];
      columns_.push_back(
          define_number(std::string(name.name), dimensions_, std::string(name.unit), std::string(name.meaning)));
      summary_.quantities.push_back({std::string(name.name), std::string(name.unit)});
    }
    column_rows_.resize(columns_.size());
    summary_.sample.values.resize(columns_.size());
    if (asked_.event_times == 0) return;
    auto dimensions = dimensions_;
    dimensions.push_back(file_.dimension("event", asked_.event_times));
    event_time_ = define_number("event_time", dimensions, "s", "times of the first regime changes");
    event_stretch_ = define_number("event_stretch", dimensions, "1", "stretches at the first regime changes");
  }

  int number_of(const std::string& message) {
    auto& all = summary_.failures;
    const auto found = std::ranges::find(all, message, &std::pair<std::string, std::uint64_t>::first);
    const auto index = found - all.begin();
    if (found == all.end()) all.emplace_back(message, 0);
    return static_cast<int>(index) + 1;
  }

  void add_numbers(const double* numbers) {
    for (std::size_t q = 0; q < columns_.size(); ++q) {
      const double value = numbers[q];
      column_rows_[q].push_back(value);
      if (std::isnan(value)) continue;
      QuantitySummary& summary = summary_.quantities[q];
      summary.least = summary.count == 0 ? value : std::min(summary.least, value);
      summary.greatest = summary.count == 0 ? value : std::max(summary.greatest, value);
      summary.mean += value;
      ++summary.count;
    }
    const double* times = numbers + columns_.size();
    time_rows_.insert(time_rows_.end(), times, times + asked_.event_times);
    stretch_rows_.insert(stretch_rows_.end(), times + asked_.event_times, times + 2 * asked_.event_times);
  }

  void sample(const double* numbers) {
    const std::uint64_t member = members_seen_++;
    if (!thinning_.keeps(member)) return;
    summary_.sample.members.push_back(member);
    for (std::size_t q = 0; q < columns_.size(); ++q) summary_.sample.values[q].push_back(numbers[q]);
  }

  template <class Value>
  void put(const NetcdfFile::Variable& variable, std::size_t first, std::vector<Value>& rows) {
    file_.put(variable, first, std::span<const Value>(rows));
    rows.clear();
  }

  void flush() {
    const std::size_t first = summary_.members;
    const std::size_t count = outcome_rows_.size();
    for (std::size_t i = 0; i < count && !axes_.empty(); ++i) {
      const std::vector<Node> values = plan_.values(first + i);
      for (std::size_t a = 0; a < axes_.size(); ++a) axis_rows_[a].push_back(number_in(values[a]));
    }
    for (std::size_t a = 0; a < axes_.size(); ++a) put(axes_[a], first, axis_rows_[a]);
    put(outcome_, first, outcome_rows_);
    put(model_, first, model_rows_);
    put(failure_, first, failure_rows_);
    for (std::size_t q = 0; q < columns_.size(); ++q) put(columns_[q], first, column_rows_[q]);
    if (asked_.event_times > 0) {
      put(event_time_, first * asked_.event_times, time_rows_);
      put(event_stretch_, first * asked_.event_times, stretch_rows_);
    }
    summary_.members += count;
  }

  NetcdfFile file_;
  const Case& case_;
  SweepPlan plan_;
  MemberQuestions asked_;
  std::vector<NetcdfFile::Dimension> dimensions_;
  std::vector<NetcdfFile::Variable> axes_;  ///< of samples
  std::vector<NetcdfFile::Variable> columns_;
  NetcdfFile::Variable outcome_{}, model_{}, failure_{}, event_time_{}, event_stretch_{};
  std::vector<signed char> outcome_rows_, model_rows_;
  std::vector<int> failure_rows_;
  std::vector<std::vector<double>> axis_rows_, column_rows_;
  std::vector<double> time_rows_, stretch_rows_;
  Thinning thinning_;
  std::uint64_t members_seen_ = 0;
  SweepSummary summary_;
};

}  // namespace

std::string netcdf_name(const std::string& key) {
  std::string name;
  for (const char c : key) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (plain) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

SweepSummary write_result(const std::filesystem::path& file, const Case& c, const SweepPlan& plan,
                          const Journal& journal) {
  const std::filesystem::path partial = file.string() + ".new";
  try {
    ResultWriter writer(partial, c, plan);
    journal.read([&](const std::string& bytes) { writer.add(ChunkResult::decode(bytes)); });
    SweepSummary summary = writer.finish();
    std::error_code error;
    std::filesystem::rename(partial, file, error);
    if (error) throw ComputationFailed("cannot write " + file.string() + ": " + error.message());
    return summary;
  } catch (const ComputationFailed&) {
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw;
  }
}

}  // namespace turgor
