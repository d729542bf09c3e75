#pragma once
// The two ways in which a question to turgor can go wrong.

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace turgor {

/// One thing that is wrong with an input, in words for the person who wrote it.
struct Issue {
  std::string key;      ///< full name of the key or argument, such as "inlet.orifice_radius"
  std::string value;    ///< what was given, as written; empty when nothing was given
  std::string problem;  ///< what is wrong with it
  std::string advice;   ///< what is allowed, or what to try
  std::string file;     ///< where it stands: a file, or "--set"; empty outside case files
  int line = 0;         ///< line in that file, counted from 1; 0 when unknown

  /// "file:line: key = value: problem; advice", leaving out what is empty.
  [[nodiscard]] std::string text() const;
};

/// An input that cannot be used. Carries every issue found, not only the first.
class InvalidInput : public std::runtime_error {
 public:
  explicit InvalidInput(std::vector<Issue> issues);
  InvalidInput(std::string key, std::string value, std::string problem, std::string advice = {})
      : InvalidInput(
            std::vector<Issue>{{std::move(key), std::move(value), std::move(problem), std::move(advice), {}, 0}}) {}

  [[nodiscard]] const std::vector<Issue>& issues() const noexcept { return issues_; }

 private:
  std::vector<Issue> issues_;
};

/// A computation that was well posed but could not be carried out; the text says where and with which values.
/// Time integration does not throw it: a trajectory carries its own outcome and everything computed up to there.
class ComputationFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace turgor
