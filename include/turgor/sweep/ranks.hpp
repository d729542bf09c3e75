#pragma once
// The processes of one sweep under mpirun.

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace turgor {

/// MPI from start to end of a program. Rank 0 hands out chunks and gathers their results; the others ask it for work.
class Ranks {
 public:
  /// Whether this process was started by an MPI launcher; MPI is not touched otherwise.
  [[nodiscard]] static bool launched();

  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  Ranks(Ranks&&) = delete;
  Ranks& operator=(Ranks&&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  /// What rank 0 says, on every rank.
  [[nodiscard]] static bool agree(bool rank_0_says);

  /// Rank 0: answers the others until all of them have left.
  /// @param next      a chunk to hand out, or nothing when there is none left
  /// @param finished  takes a chunk's result
  void serve(const std::function<std::optional<std::uint64_t>()>& next,
             const std::function<void(std::uint64_t, const std::string&)>& finished) const;

  // Other ranks. Calls may come from several threads.
  /// Asks rank 0 for a chunk; a batch is fetched at a time.
  [[nodiscard]] std::optional<std::uint64_t> ask();
  void send(std::uint64_t chunk, const std::string& bytes);
  /// Tells rank 0 that everything has been sent.
  void leave();

  /// Ends all ranks at once.
  static void abort(int code);

 private:
  int rank_ = 0;
  int size_ = 1;
  std::mutex calls_;  ///< MPI is asked to expect one call at a time
  std::deque<std::uint64_t> batch_;
};

}  // namespace turgor
