#include "guarded.hpp"

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "turgor/base/errors.hpp"

namespace turgor::cli {

namespace {

nlohmann::ordered_json to_json(const Issue& issue) {
  return {{"key", issue.key},       {"value", issue.value}, {"problem", issue.problem},
          {"advice", issue.advice}, {"file", issue.file},   {"line", issue.line}};
}

void print_failure(bool json, const std::string& status, const std::string& message, const std::vector<Issue>& issues) {
  if (!json) return;
  nlohmann::ordered_json document{
      {"status", status}, {"message", message}, {"issues", nlohmann::ordered_json::array()}};
  for (const Issue& issue : issues) document["issues"].push_back(to_json(issue));
  std::cout << document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

}  // namespace

int guarded(bool json, const std::function<int()>& command) {
  try {
    const int code = command();
    std::cout.flush();
    return code;
  } catch (const InvalidInput& error) {
    for (const Issue& issue : error.issues()) std::cerr << "error: " << issue.text() << "\n";
    print_failure(json, "bad-input", error.what(), error.issues());
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    std::cerr << "error: out of memory; fewer samples or a looser tolerance need less\n";
    print_failure(json, "failed", "out of memory", {});
    return exit_failed;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n";
    print_failure(json, "failed", error.what(), {});
    return exit_failed;
  }
}

}  // namespace turgor::cli
