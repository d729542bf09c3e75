#include "turgor/sweep/ranks.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

namespace turgor {

namespace {

enum Tag : int { tag_ask = 1, tag_chunks, tag_result, tag_leave };

/// Chunks are handed out so many at a time, so that a fast rank does not wait for each.
constexpr std::size_t batch_size = 8;

constexpr auto nap = std::chrono::microseconds(200);  // between two looks for messages, while threads compute

}  // namespace

bool Ranks::launched() {
  constexpr std::array variables{"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"};
  return std::ranges::any_of(variables, [](const char* variable) { return std::getenv(variable) != nullptr; });
}

Ranks::Ranks() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() { MPI_Finalize(); }

bool Ranks::agree(bool rank_0_says) {
  int value = rank_0_says ? 1 : 0;
  MPI_Bcast(&value, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return value != 0;
}

void Ranks::serve(const std::function<std::optional<std::uint64_t>()>& next,
                  const std::function<void(std::uint64_t, const std::string&)>& finished) const {
  for (int left = size_ - 1; left > 0;) {
    MPI_Status status{};
    int waiting = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting, &status);
    if (waiting == 0) {  // a blocking probe would keep a core busy
      std::this_thread::sleep_for(nap);
      continue;
    }
    int length = 0;
    MPI_Get_count(&status, MPI_BYTE, &length);
    std::string bytes(static_cast<std::size_t>(length), '\0');
    MPI_Recv(bytes.data(), length, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (status.MPI_TAG == tag_leave) {
      --left;
    } else if (status.MPI_TAG == tag_result) {
      std::uint64_t chunk = 0;
      bytes.copy(reinterpret_cast<char*>(&chunk), sizeof(chunk));  // NOLINT: bytes of a message
      finished(chunk, bytes.substr(sizeof(chunk)));
    } else {
      std::vector<std::uint64_t> chunks;
      while (chunks.size() < batch_size) {
        const auto chunk = next();
        if (!chunk) break;
        chunks.push_back(*chunk);
      }
      MPI_Send(chunks.data(), static_cast<int>(chunks.size()), MPI_UINT64_T, status.MPI_SOURCE, tag_chunks,
               MPI_COMM_WORLD);
    }
  }
}

std::optional<std::uint64_t> Ranks::ask() {
  const std::scoped_lock lock(calls_);
  if (batch_.empty()) {
    std::vector<std::uint64_t> chunks(batch_size);
    MPI_Status status{};
    int count = 0;
    MPI_Send(nullptr, 0, MPI_BYTE, 0, tag_ask, MPI_COMM_WORLD);
    MPI_Recv(chunks.data(), static_cast<int>(chunks.size()), MPI_UINT64_T, 0, tag_chunks, MPI_COMM_WORLD, &status);
    MPI_Get_count(&status, MPI_UINT64_T, &count);
    batch_.assign(chunks.begin(), chunks.begin() + count);
  }
  if (batch_.empty()) return std::nullopt;
  const std::uint64_t chunk = batch_.front();
  batch_.pop_front();
  return chunk;
}

void Ranks::send(std::uint64_t chunk, const std::string& bytes) {
  std::string message(reinterpret_cast<const char*>(&chunk), sizeof(chunk));  // NOLINT: bytes of a message
  message += bytes;
  const std::scoped_lock lock(calls_);
  MPI_Send(message.data(), static_cast<int>(message.size()), MPI_BYTE, 0, tag_result, MPI_COMM_WORLD);
}

void Ranks::leave() {
  const std::scoped_lock lock(calls_);
  MPI_Send(nullptr, 0, MPI_BYTE, 0, tag_leave, MPI_COMM_WORLD);
}

void Ranks::abort(int code) { MPI_Abort(MPI_COMM_WORLD, code); }

}  // namespace turgor
