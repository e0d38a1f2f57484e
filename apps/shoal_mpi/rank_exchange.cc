#include "apps/shoal_mpi/rank_exchange.h"

#include <fmt/format.h>
#include <mpi.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int kTag = 1;
/// Waits without giving the core away for what differs between the ranks in most steps: to wake up
/// from a sleep takes 0.1 ms and more, a step of a thousand vessels 1 ms.
constexpr double kSpin_s = 2e-3;
/// The same where ranks share cores, and the one that is waited for may need this one's.
constexpr double kSharedSpin_s = 50e-6;
/// Short sleeps, and not sched_yield: on a loaded machine that gives a whole slice of time away.
constexpr auto kSleep = std::chrono::microseconds(20);
/// How often ranks on this host are looked at while they are waited for.
constexpr double kLook_s = 0.1;
/// One rank ends the job, with one error; the others only where that one does not.
constexpr double kOthersLater_s = 2;
/// An orderly end after a signal takes a step; a rank that takes longer is not waited for.
constexpr double kInterruptedPatience_s = 0.5;

double NowSeconds() { return Seconds(MonotonicMicroseconds()); }

/// True where no process of this number runs here: it ended, or is a zombie.
bool IsGone(pid_t pid) {
  if (kill(pid, 0) != 0 && errno == ESRCH) return true;
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(in, text);
  const size_t name_end = text.rfind(')');
  return name_end != std::string::npos && text.compare(name_end, 3, ") Z") == 0;
}

}  // namespace

struct RankExchange::Requests {
  struct Send {
    size_t to;
    MPI_Request request;
  };
  std::vector<Send> sends;      ///< That are not complete yet.
  std::vector<size_t> senders;  ///< Ranks whose batch is not there yet.

  /// Returns the ranks that keep the round from its end.
  std::vector<size_t> Awaited() const {
    std::vector<size_t> ranks = senders;
    if (!ranks.empty()) return ranks;
    for (const Send& send : sends) ranks.push_back(send.to);
    return ranks;
  }
};

RankExchange::RankExchange(RankExchangeOptions options)
    : options_(std::move(options)), next_name_after_s_(options_.name_after_s) {
  setenv("OMPI_MCA_mpi_yield_when_idle", "0", 0);  // Round() does that in a better way.
  prctl(PR_SET_TIMERSLACK, 1);                     // Sleeps as long as kSleep, not 50 us longer.
  MPI_Init(nullptr, nullptr);
  int rank = 0;
  int size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  rank_ = static_cast<size_t>(rank);
  num_ranks_ = static_cast<size_t>(size);
  places_.resize(num_ranks_);
}

RankExchange::~RankExchange() { MPI_Finalize(); }

void RankExchange::SetPlaces(std::vector<RankPlace> places) {
  places_ = std::move(places);
  const auto num_here = std::ranges::count(places_, places_[rank_].host, &RankPlace::host);
  spin_s_ = num_here > std::thread::hardware_concurrency() ? kSharedSpin_s : kSpin_s;
}

std::string RankExchange::NameOf(size_t rank) const {
  const RankPlace& place = places_.at(rank);
  if (place.host.empty()) return fmt::format("rank {}", rank);
  return fmt::format("rank {} (host {}, process {})", rank, place.host, place.pid);
}

std::string RankExchange::NamesOf(const std::vector<size_t>& ranks) const {
  std::string text;
  for (const size_t rank : ranks) text += (text.empty() ? "" : ", ") + NameOf(rank);
  return text;
}

/// Receives what has come, and returns true where the round is complete.
bool RankExchange::Advance(Requests* requests, std::vector<Bytes>* incoming) {
  std::erase_if(requests->senders, [&](size_t from) {
    int has_come = 0;
    MPI_Status status;
    MPI_Iprobe(static_cast<int>(from), kTag, MPI_COMM_WORLD, &has_come, &status);
    if (has_come == 0) return false;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Bytes& bytes = (*incoming)[from];
    bytes.resize(static_cast<size_t>(size));
    MPI_Recv(bytes.data(), size, MPI_BYTE, static_cast<int>(from), kTag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return true;
  });
  if (!requests->senders.empty()) return false;
  std::erase_if(requests->sends, [](Requests::Send& send) {
    int is_sent = 0;
    MPI_Test(&send.request, &is_sent, MPI_STATUS_IGNORE);
    return is_sent != 0;
  });
  return requests->sends.empty();
}

std::vector<size_t> RankExchange::Gone(const std::vector<size_t>& waited_for) const {
  std::vector<size_t> gone;
  for (const size_t rank : waited_for) {
    const RankPlace& place = places_[rank];
    if (place.host == places_[rank_].host && place.pid > 0 && IsGone(place.pid)) {
      gone.push_back(rank);
    }
  }
  return gone;
}

/// One rank names those that are waited for, not all.
bool RankExchange::IsFirstToWait(const std::vector<size_t>& waited_for) const {
  for (size_t rank = 0; rank < rank_; ++rank) {
    if (std::ranges::find(waited_for, rank) == waited_for.end()) return false;
  }
  return true;
}

std::optional<Error> RankExchange::Round(const std::string& what,
                                         std::span<const std::span<const uint8_t>> outgoing,
                                         std::vector<Bytes>* incoming) {
  SHOAL_CHECK(outgoing.size() == num_ranks_, "there is a batch for each rank");
  incoming->resize(num_ranks_);
  Requests requests;
  for (size_t other = 0; other < num_ranks_; ++other) {
    if (other == rank_) continue;
    requests.senders.push_back(other);
    totals_.bytes_sent += static_cast<int64_t>(outgoing[other].size());
    MPI_Isend(outgoing[other].data(), static_cast<int>(outgoing[other].size()), MPI_BYTE,
              static_cast<int>(other), kTag, MPI_COMM_WORLD,
              &requests.sends.emplace_back(Requests::Send{.to = other, .request = {}}).request);
  }
  const double begin_s = NowSeconds();
  double next_look_s = kLook_s;
  while (!Advance(&requests, incoming)) {
    const double waited_s = NowSeconds() - begin_s;
    if (waited_s < spin_s_) continue;
    std::this_thread::sleep_for(kSleep);
    const std::vector<size_t> awaited = requests.Awaited();
    const bool is_first = IsFirstToWait(awaited);
    const double later_s = is_first ? 0 : kOthersLater_s;
    if (waited_s >= next_look_s + later_s) {
      next_look_s += kLook_s;
      if (const auto gone = Gone(awaited); !gone.empty()) {
        return Error{fmt::format("LOST: {} has ended before {} was done", NamesOf(gone), what)};
      }
    }
    if (waited_s >= next_name_after_s_) {
      next_name_after_s_ *= 2;
      if (is_first) {
        fmt::print(stderr, "shoal-mpi: {}: {:.1f} s without an answer of {}\n", what, waited_s,
                   NamesOf(awaited));
        std::fflush(stderr);
      }
    }
    if (waited_s >= options_.give_up_after_s + later_s) {
      return Error{
          fmt::format("LOST: {} has not answered in {} for {:.1f} s; --timeout gives it longer",
                      NamesOf(awaited), what, waited_s)};
    }
    if (waited_s >= kInterruptedPatience_s && options_.is_interrupted()) {
      return Error{
          fmt::format("interrupted in {}, while {} did not answer", what, NamesOf(awaited))};
    }
  }
  totals_.wait_s += NowSeconds() - begin_s;
  return std::nullopt;
}

void RankExchange::Abort(int exit_code) {
  std::fflush(nullptr);
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace shoal
