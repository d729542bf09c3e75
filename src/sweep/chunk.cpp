#include "chunk.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "turgor/base/errors.hpp"
#include "turgor/case/quantities.hpp"

namespace turgor {

namespace {

std::vector<std::string> keys_of(const SweepSettings& settings) {
  std::vector<std::string> keys;
  keys.reserve(settings.axes.size());
  for (const Axis& axis : settings.axes) keys.push_back(axis.key);
  return keys;
}

/// 1 + the index of a message in a list, which grows as needed; 0 for none.
double number_of(const std::string& message, std::vector<std::string>& messages) {
  if (message.empty()) return 0;
  auto found = std::ranges::find(messages, message);
  if (found == messages.end()) found = messages.insert(messages.end(), message);
  return static_cast<double>(found - messages.begin() + 1);
}

}  // namespace

MemberQuestions questions_of(const SweepSettings& settings) {
  MemberQuestions asked{{}, settings.event_times};
  for (std::size_t i = 0; i < quantity_names().size(); ++i) {
    if (std::ranges::find(settings.quantities, quantity_names()[i].name) != settings.quantities.end()) {
      asked.quantities.push_back(i);
    }
  }
  return asked;
}

std::string ChunkResult::encode() const {
  const std::array<std::uint64_t, 2> head{width, rows.size()};
  std::string bytes(sizeof(head) + rows.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), head.data(), sizeof(head));
  std::memcpy(bytes.data() + sizeof(head), rows.data(), rows.size() * sizeof(double));
  for (const std::string& message : messages) bytes += message + '\0';
  return bytes;
}

ChunkResult ChunkResult::decode(const std::string& bytes) {
  std::array<std::uint64_t, 2> head{};
  ChunkResult result;
  if (bytes.size() >= sizeof(head)) std::memcpy(head.data(), bytes.data(), sizeof(head));
  const std::uint64_t numbers = head[1];
  if (head[0] == 0 || numbers % head[0] != 0 || numbers > (bytes.size() - sizeof(head)) / sizeof(double)) {
    throw ComputationFailed("a stored chunk of results is damaged");
  }
  result.width = head[0];
  result.rows.resize(numbers);
  std::memcpy(result.rows.data(), bytes.data() + sizeof(head), numbers * sizeof(double));
  for (std::size_t at = sizeof(head) + numbers * sizeof(double); at < bytes.size();) {
    result.messages.emplace_back(bytes.c_str() + at);
    at += result.messages.back().size() + 1;
  }
  return result;
}

ChunkRunner::ChunkRunner(const Case& c, SweepPlan plan)
    : plan_(std::move(plan)), template_(c, keys_of(plan_.settings())), asked_(questions_of(plan_.settings())) {}

ChunkResult ChunkRunner::run(std::uint64_t chunk) {
  const std::uint64_t first = chunk * chunk_size;
  const auto count = static_cast<std::size_t>(std::min(chunk_size, plan_.members() - first));
  const double none = std::numeric_limits<double>::quiet_NaN();
  ChunkResult result;
  result.width = ChunkResult::leading_columns + asked_.quantities.size() + 2 * asked_.event_times;
  result.rows.assign(count * result.width, none);

  std::vector<Case> cases;
  std::vector<std::size_t> members;
  cases.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    try {
      cases.push_back(template_.with(plan_.values(first + i)));
      members.push_back(i);
    } catch (const InvalidInput& error) {
      double* row = result.rows.data() + i * result.width;
      row[0] = invalid_member;
      row[1] = -1;
      row[2] = number_of(reason_of(error), result.messages);
    }
  }
  const std::vector<MemberResult> found = run_members(cases, asked_);
  for (std::size_t k = 0; k < found.size(); ++k) {
    double* row = result.rows.data() + members[k] * result.width;
    row[0] = found[k].outcome ? static_cast<double>(*found[k].outcome) : invalid_member;
    row[1] = found[k].outcome ? static_cast<double>(found[k].model) : -1;
    row[2] = number_of(found[k].message, result.messages);
    std::ranges::copy(found[k].values, row + ChunkResult::leading_columns);
    double* times = row + ChunkResult::leading_columns + asked_.quantities.size();
    for (std::size_t e = 0; e < found[k].events.size(); ++e) {
      times[e] = found[k].events[e].time;
      times[asked_.event_times + e] = found[k].events[e].stretch;
    }
  }
  return result;
}

}  // namespace turgor
