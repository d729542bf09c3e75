#include "turgor/base/errors.hpp"

namespace turgor {

std::string Issue::text() const {
  std::string out;
  if (!file.empty()) {
    out += file;
    if (line > 0) out += ":" + std::to_string(line);
    out += ": ";
  }
  if (!key.empty()) {
    out += key;
    if (!value.empty()) out += " = " + value;
    out += ": ";
  }
  out += problem;
  if (!advice.empty()) out += "; " + advice;
  return out;
}

namespace {
std::string joined(const std::vector<Issue>& issues) {
  std::string out;
  for (const auto& issue : issues) {
    if (!out.empty()) out += '\n';
    out += issue.text();
  }
  return out;
}
}  // namespace

InvalidInput::InvalidInput(std::vector<Issue> issues)
    : std::runtime_error(joined(issues)), issues_(std::move(issues)) {}

}  // namespace turgor
