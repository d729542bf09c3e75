#include "turgor/sweep/run_sweep.hpp"

#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "journal.hpp"
#include "result_file.hpp"
#include "turgor/base/errors.hpp"
#include "turgor/base/version.hpp"
#include "turgor/sweep/ranks.hpp"
#include "workers.hpp"

namespace turgor {

namespace fs = std::filesystem;

namespace {

/// Everything that results depend on. The source is in it beside the resolved text because a default may follow a swept
/// key.
Identity identity_of(const Case& c) {
  return {{"version of turgor", std::string(version)},
          {"compiler", std::string(compiler)},
          {"instructions", std::string(member_instructions())},
          {"case file", c.source},
          {"case with --set and defaults", c.resolved}};
}

/// Hands out the chunks that are not finished, and stores those that are. Any thread may call it.
class Coordinator {
 public:
  Coordinator(Journal& journal, std::uint64_t members, const SweepOptions& options)
      : journal_(journal), options_(options), done_(journal.finished(chunks_of(members))) {
    progress_.all = members;
    for (std::uint64_t chunk = 0; chunk < done_.size(); ++chunk) {
      if (done_[chunk]) progress_.done += members_in(chunk);
    }
  }

  std::optional<std::uint64_t> next() {
    const std::scoped_lock lock(mutex_);
    while (next_ < done_.size() && done_[next_]) ++next_;
    if (stopped_ || next_ == done_.size()) return std::nullopt;
    return next_++;
  }

  void finished(std::uint64_t chunk, const std::string& bytes) {
    const std::scoped_lock lock(mutex_);
    if (failure_) return;
    try {
      journal_.store(chunk, bytes);
    } catch (...) {
      stop_because(std::current_exception());
      return;
    }
    progress_.done += members_in(chunk);
    progress_.computed += members_in(chunk);
    if (options_.progress && !options_.progress(progress_)) stopped_ = true;
  }

  void fail(const std::exception_ptr& failure) {
    const std::scoped_lock lock(mutex_);
    stop_because(failure);
  }

  /// How far the sweep has come, once nobody works any more.
  [[nodiscard]] SweepProgress result() const {
    if (failure_) std::rethrow_exception(failure_);
    return progress_;
  }

 private:
  void stop_because(const std::exception_ptr& failure) {
    stopped_ = true;
    if (!failure_) failure_ = failure;
  }
  [[nodiscard]] std::uint64_t members_in(std::uint64_t chunk) const {
    return std::min(chunk_size, progress_.all - chunk * chunk_size);
  }

  Journal& journal_;
  const SweepOptions& options_;
  std::mutex mutex_;
  std::vector<bool> done_;  ///< before this sweep went on
  std::uint64_t next_ = 0;
  bool stopped_ = false;
  std::exception_ptr failure_;
  SweepProgress progress_{};
};

/// Checks what is there already against what was asked, and removes what may be replaced.
fs::path journal_file(const SweepOptions& options) {
  const fs::path& output = options.output;
  fs::path journal = output;
  journal += ".part";
  const auto wrong = [&](std::string problem, std::string advice) {
    throw InvalidInput("", "", "output " + output.string() + ": " + std::move(problem), std::move(advice));
  };
  std::error_code error;
  const fs::path folder = output.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    wrong("the folder " + folder.string() + " does not exist", "make it first, or choose another -o OUT.nc");
  }
  if (fs::is_directory(output, error)) wrong("is a folder", "choose another -o OUT.nc");
  const bool has_journal = fs::exists(journal, error);
  const bool has_output = fs::exists(output, error);
  if (options.force) {
    remove_journal(journal);
  } else if (options.resume && !has_journal) {
    wrong(has_output ? "is complete; there is nothing to resume" : "there is nothing to resume",
          has_output ? "--force computes it anew" : "leave out --resume");
  } else if (!options.resume && has_journal) {
    wrong("an unfinished sweep has left " + journal.string(), "go on with --resume, or begin anew with --force");
  } else if (!options.resume && has_output) {
    wrong("exists already", "choose another with -o OUT.nc, or replace it with --force");
  }
  return journal;
}

void work_for(Coordinator& coordinator, const Case& c, const SweepPlan& plan, int threads) {
  try {
    compute_chunks(c, plan, threads,
                   {[&] { return coordinator.next(); },
                    [&](std::uint64_t chunk, const std::string& bytes) { coordinator.finished(chunk, bytes); }});
  } catch (...) {
    coordinator.fail(std::current_exception());
  }
}

/// Other ranks than 0.
SweepResult work_for_rank_0(const Case& c, const SweepPlan& plan, int threads, Ranks& ranks) {
  if (!Ranks::agree(false)) return {};  // rank 0 says what is wrong
  compute_chunks(
      c, plan, threads,
      {[&] { return ranks.ask(); }, [&](std::uint64_t chunk, const std::string& bytes) { ranks.send(chunk, bytes); }});
  ranks.leave();
  return {};
}

void compute(Coordinator& coordinator, const Case& c, const SweepPlan& plan, int threads, const Ranks* ranks) {
  if (ranks == nullptr) {
    work_for(coordinator, c, plan, threads);
    return;
  }
  std::thread worker([&] { work_for(coordinator, c, plan, threads); });
  ranks->serve([&] { return coordinator.next(); },
               [&](std::uint64_t chunk, const std::string& bytes) { coordinator.finished(chunk, bytes); });
  worker.join();
}

}  // namespace

SweepResult run_sweep(const Case& c, const SweepOptions& options, Ranks* ranks) {
  if (!c.sweep) {
    throw InvalidInput("sweep", "", "the case has no [sweep] table",
                       "`turgor doc sweep` and docs/case-files.md say what belongs in it");
  }
  const SweepPlan plan(*c.sweep);
  if (ranks != nullptr && ranks->rank() != 0) return work_for_rank_0(c, plan, options.threads, *ranks);

  std::optional<Journal> journal;
  try {
    journal.emplace(journal_file(options), identity_of(c));
  } catch (...) {
    if (ranks != nullptr) (void)Ranks::agree(false);
    throw;
  }
  if (ranks != nullptr) (void)Ranks::agree(true);
  const auto start = std::chrono::steady_clock::now();
  Coordinator coordinator(*journal, plan.members(), options);
  compute(coordinator, c, plan, options.threads, ranks);

  SweepResult result;
  result.progress = coordinator.result();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.complete = result.progress.done == result.progress.all;
  if (!result.complete) return result;
  result.summary = write_result(options.output, c, plan, *journal);
  journal->remove();
  return result;
}

}  // namespace turgor
