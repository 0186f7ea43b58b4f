#include "parts_run.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <stop_token>
#include <thread>

#include "base/part_file.h"
#include "relief/errors.h"
#include "stopped.h"
#include "team.h"

namespace relief::app {

namespace {

constexpr std::int64_t kPermille = 1000;  // steps of the progress bar per part
constexpr auto kBetweenPolls = std::chrono::milliseconds(1);
constexpr int kInterrupted = 130;

Json taskJson(const Task& task) {
    return {{"part", task.part}, {"pass", static_cast<int>(task.pass)}};
}

Task taskOf(const Json& json) {
    return {json.at("part").get<std::size_t>(), static_cast<Pass>(json.at("pass").get<int>())};
}

// Keeps the results and the schedule of a run, on rank 0 or in a single process.
class Ledger {
  public:
    Ledger(const PartsRun& run, std::vector<std::string> hosts, Session& session)
        : run_(run),
          passes_(run.timed && hosts.size() > 1),
          schedule_(run.parts, passes_, hosts, run.concurrent),
          counts_(run.parts),
          whole_(run.parts),
          partsOf_(hosts.size(), 0),
          countedBy_(hosts.size(), 0) {
        if (run.output.empty()) return;
        journal_ = std::make_unique<Journal>(run.output, run.work, run.parts, run.earlier);
        if (!journal_->otherHost().empty()) {
            session.note(journal_->path(), Message(MessageId::SweepOtherHost, {{"host", journal_->otherHost()}}));
        }
        const auto readable = [&](const Json& result) { return !run.readable || run.readable(result); };
        Journal::Earlier earlier = journal_->takeEarlier();
        if (run.started) run.started(!earlier.results.empty());
        for (auto& [part, counts] : earlier.counts) {
            if (!passes_ || !readable(counts)) continue;
            counts_[part] = std::move(counts);
            schedule_.skip({part, Pass::Counts});
        }
        for (auto& [part, result] : earlier.results) {
            if (!readable(result)) continue;
            whole_[part] = std::move(result);
            schedule_.skip({part, Pass::Whole});
            ++done_;
        }
        if (done_ > 0) {
            session.note(journal_->path(), Message(MessageId::SweepResumed, {{"done", done_}, {"total", run.parts}}));
        }
    }

    std::optional<Task> next(int rank) { return schedule_.next(rank); }
    bool over() const { return schedule_.over(); }
    std::size_t done() const { return done_; }
    // Returns a sentence about how much a rank has done.
    Message doneBy(int rank, const std::string& host) const {
        const auto at = static_cast<std::size_t>(rank);
        if (!passes_) return Message(MessageId::RankDone, {{"rank", rank}, {"host", host}, {"parts", partsOf_[at]}});
        return Message(MessageId::RankTimed,
                       {{"rank", rank}, {"host", host}, {"counted", countedBy_[at]}, {"timed", partsOf_[at]}});
    }
    const Journal* journal() const { return journal_.get(); }

    void put(int rank, const Task& task, Json result) {
        if (task.pass == Pass::Counts) {
            if (journal_) journal_->keepCounts(task.part, result);
            counts_[task.part] = std::move(result);
        } else if (task.pass == Pass::Times) {
            times_[task.part] = std::move(result);
        } else {
            keep(task.part, std::move(result));
        }
        ++(task.pass == Pass::Counts ? countedBy_ : partsOf_)[static_cast<std::size_t>(rank)];
        const auto times = times_.find(task.part);
        if (times != times_.end() && counts_[task.part]) {
            keep(task.part, run_.combine(*std::move(counts_[task.part]), times->second));
            times_.erase(times);
            counts_[task.part].reset();
        }
        schedule_.done(rank);
    }

    PartsDone take() {
        PartsDone all;
        for (std::optional<Json>& result : whole_) all.results.push_back(*std::move(result));
        all.journal = std::move(journal_);
        return all;
    }

  private:
    void keep(std::size_t part, Json result) {
        if (run_.received) result = run_.received(part, std::move(result));
        if (journal_) journal_->keep(part, result);
        whole_[part] = std::move(result);
        ++done_;
    }

    const PartsRun& run_;
    bool passes_;
    Schedule schedule_;
    std::unique_ptr<Journal> journal_;
    std::vector<std::optional<Json>> counts_, whole_;
    std::map<std::size_t, Json> times_;             // of parts whose counts another rank has not sent yet
    std::vector<std::size_t> partsOf_, countedBy_;  // per rank: parts done whole or timed; parts counted
    std::size_t done_ = 0;
};

// Does tasks until next() returns none, and shows them on the progress bar as one piece of work. done: returns the
// number of finished parts.
void work(const PartsRun& run, Session& session, int ranksHere, const std::function<std::optional<Task>()>& next,
          const std::function<void(const Task&, Json)>& put, const std::function<std::size_t()>& done) {
    Progress& bar = session.work().progress();
    const std::size_t before = done();
    bar.begin(run.bar, static_cast<std::int64_t>(run.parts - before) * kPermille);
    std::int64_t reported = 0;
    const auto report = [&](std::int64_t permille) {
        if (permille <= reported) return;
        bar.advance(permille - reported);
        reported = permille;
    };
    while (const std::optional<Task> task = next()) {
        const auto base = static_cast<std::int64_t>(done() - before) * kPermille;
        report(base);
        int threads = run.threads(task->part) > 0 ? run.threads(task->part) : session.threads();
        // Ranks that count at the same time share the processors of their host.
        if (threads == 0 && task->pass != Pass::Times && ranksHere > 1) {
            threads = std::max(1, session.work().threads().size() / ranksHere);
        }
        // Each stage of a part restarts its own progress; the bar never moves backwards.
        Work one(threads, session.stop(), [&](std::string_view, double fraction) {
            report(base + static_cast<std::int64_t>(fraction * static_cast<double>(kPermille - 1)));
        });
        put(*task, run.measure(*task, one));
    }
    report(static_cast<std::int64_t>(done() - before) * kPermille);
}

// Prints that the run was stopped and, if there is a journal, how to resume it. Throws StopTold.
[[noreturn]] void endStopped(const PartsRun& run, const Ledger& ledger, Session& session) {
    if (ledger.journal() == nullptr) endStopped(session, run.bar, Message(MessageId::RunStopped));
    const MessageId message = ledger.journal()->hasResults() ? MessageId::SweepStopped : MessageId::SweepStoppedEmpty;
    endStopped(session, ledger.journal()->path(), Message(message, {{"done", ledger.done()}, {"total", run.parts}}));
}

// Throws the error again; if the journal holds results, it says so and how to resume.
[[noreturn]] void throwKept(const WorkError& error, const PartsRun& run, const Ledger& ledger) {
    if (ledger.journal() == nullptr || !ledger.journal()->hasResults()) throw error;
    throw WorkError(error.subject(), Message(MessageId::SweepFailed, {MessageValue("why", error.message()),
                                                                      {"done", ledger.done()},
                                                                      {"total", run.parts},
                                                                      {"part", ledger.journal()->path()}}));
}

PartsDone alone(const PartsRun& run, Session& session) {
    Ledger ledger(run, {hostName()}, session);
    try {
        work(
            run, session, 1, [&] { return ledger.next(0); },
            [&](const Task& task, Json result) { ledger.put(0, task, std::move(result)); },
            [&] { return ledger.done(); });
    } catch (const Cancelled&) {
        if (ledger.journal() != nullptr) endStopped(run, ledger, session);
        throw;
    } catch (const WorkError& error) {
        throwKept(error, run, ledger);
    }
    session.eraseBar();
    return ledger.take();
}

// Messages between ranks are CBOR, because results may contain pictures.
std::string letterText(const Json& json) {
    std::string text;
    Json::to_cbor(json, text);
    return text;
}

Json letterJson(const std::string& text) {
    return Json::from_cbor(text);
}

// Rank 0: serves the other ranks from a thread of its own, while the calling thread works as they do.
class Coordinator {
  public:
    Coordinator(Ledger& ledger, Team& team, std::stop_token stop)
        : ledger_(ledger), team_(team), stop_(std::move(stop)), thread_([this](const std::stop_token& end) {
              try {
                  serve(end);
              } catch (...) {
                  const std::lock_guard lock(mutex_);
                  failure_ = std::current_exception();
              }
              changed_.notify_all();
          }) {}

    // Returns the next task for rank 0; waits while other ranks may still return work, std::nullopt when all is done.
    std::optional<Task> next() {
        std::unique_lock lock(mutex_);
        while (true) {
            if (failure_) std::rethrow_exception(failure_);
            if (stop_.stop_requested()) throw Cancelled();
            if (ledger_.over()) return std::nullopt;
            if (const std::optional<Task> task = ledger_.next(0)) return task;
            changed_.wait_for(lock, kBetweenPolls);
        }
    }
    void put(const Task& task, Json result) {
        const std::lock_guard lock(mutex_);
        ledger_.put(0, task, std::move(result));
    }
    std::size_t done() {
        const std::lock_guard lock(mutex_);
        return ledger_.done();
    }
    // Waits until every rank has been told that all is done. Rethrows an exception of the serving thread.
    void join() {
        thread_.join();
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    void serve(const std::stop_token& end) {
        std::vector<int> waiting;
        int ended = 1;
        Backoff backoff;
        while (ended < team_.size() && !end.stop_requested()) {
            while (const std::optional<Team::Letter> letter = team_.poll()) {
                backoff.wokenUp();
                Json message = letterJson(letter->text);
                if (message.contains("result")) {
                    const std::lock_guard lock(mutex_);
                    ledger_.put(letter->from, taskOf(message), std::move(message["result"]));
                }
                waiting.push_back(letter->from);
            }
            std::erase_if(waiting, [&](int rank) {
                std::unique_lock lock(mutex_);
                const std::optional<Task> task = ledger_.next(rank);
                if (!task && !ledger_.over()) return false;
                lock.unlock();
                team_.send(rank, letterText(task ? taskJson(*task) : Json{{"end", 0}}));
                if (!task) ++ended;
                return true;
            });
            backoff.sleep();
        }
    }

    Ledger& ledger_;
    Team& team_;
    std::stop_token stop_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::exception_ptr failure_;
    std::jthread thread_;  // the last member: it is destroyed, and joined, first
};

int ranksOn(const std::string& host, const Team& team) {
    return static_cast<int>(std::count(team.hosts().begin(), team.hosts().end(), host));
}

void reportRanks(const Ledger& ledger, const Team& team, Session& session) {
    std::string ranks;
    for (int rank = 0; rank < team.size(); ++rank) {
        const std::string& host = team.hosts()[static_cast<std::size_t>(rank)];
        ranks += (rank > 0 ? "; " : "") + sentence(ledger.doneBy(rank, host), session.language());
    }
    const Message message(MessageId::RanksDone, {{"ranks", ranks}, {"messages", std::to_string(team.letters())}});
    sayLine(sentence(message, session.language()));
}

// Makes the other ranks, which wait for their first tasks, end regularly with `status`; this rank reports the error.
void endOtherRanks(Team& team, int status, Session& session) {
    for (int rank = 1; rank < team.size(); ++rank) {
        const int from = team.wait(session.stop()).from;
        team.send(from, letterText({{"end", status}}));
    }
    team.finish();
}

PartsDone first(const PartsRun& run, Team& team, Session& session) {
    std::optional<Ledger> ledger;
    try {
        ledger.emplace(run, team.hosts(), session);
    } catch (const WorkError&) {
        endOtherRanks(team, kFailed, session);
        throw;
    } catch (...) {
        endOtherRanks(team, kBadUsage, session);
        throw;
    }
    try {
        Coordinator coordinator(*ledger, team, session.stop());
        work(
            run, session, ranksOn(team.hosts().front(), team), [&] { return coordinator.next(); },
            [&](const Task& task, Json result) { coordinator.put(task, std::move(result)); },
            [&] { return coordinator.done(); });
        coordinator.join();
    } catch (const Cancelled&) {
        endStopped(run, *ledger, session);
    } catch (const WorkError& error) {
        throwKept(error, run, *ledger);
    }
    session.eraseBar();
    reportRanks(*ledger, team, session);
    team.finish();
    return ledger->take();
}

// Runs a rank other than 0.
void other(const PartsRun& run, Team& team, Session& session) {
    Json message{{"want", true}};
    const std::string& host = team.hosts()[static_cast<std::size_t>(team.rank())];
    work(
        run, session, ranksOn(host, team),
        [&]() -> std::optional<Task> {
            team.send(0, letterText(message));
            const Json answer = letterJson(team.wait(session.stop()).text);
            if (!answer.contains("end")) return taskOf(answer);
            if (const int status = answer.at("end").get<int>(); status != 0) {
                team.finish();
                throw RunEnded{status};
            }
            return std::nullopt;
        },
        [&](const Task& task, Json result) {
            message = taskJson(task);
            message["result"] = std::move(result);
        },
        [] { return std::size_t{0}; });
    team.finish();
}

}  // namespace

std::optional<PartsDone> doParts(const PartsRun& run, Session& session) {
    // Lives until the process ends: if the run has failed, its destructor then ends all ranks, after temporary files
    // are removed.
    static std::unique_ptr<Team> team;
    if (!run.alone) team = Team::join();
    if (!team) return alone(run, session);
    // A rank that fails ends all others, so it prints its error first.
    const auto failed = [&](const std::string& why, int status) {
        if (team->finished()) throw;
        session.eraseBar();
        const auto rank = static_cast<std::size_t>(team->rank());
        sayLine(rank == 0 ? why
                          : sentence(Message(MessageId::RankFailed,
                                             {{"rank", rank}, {"host", team->hosts()[rank]}, {"why", why}}),
                                     session.language()));
        team->failed(status);
        throw RunEnded{status};
    };
    try {
        if (team->rank() == 0) return first(run, *team, session);
        other(run, *team, session);
    } catch (const Cancelled&) {
        // Rank 0 is stopped at the same time; this lets it print its message before all ranks are ended.
        if (team->rank() > 0) std::this_thread::sleep_for(kErrorGracePeriod);
        team->failed(kInterrupted);
        throw;
    } catch (const WorkError& error) {
        failed(error.text(session.language()), kFailed);
    } catch (const InputError& error) {
        failed(error.text(session.language()), kBadUsage);
    } catch (const std::bad_alloc&) {
        failed(sentence(Message(MessageId::OutOfMemory), session.language()), kBadUsage);
    } catch (const std::exception& error) {
        failed(error.what(), kFailed);
    }
    return std::nullopt;
}

}  // namespace relief::app
