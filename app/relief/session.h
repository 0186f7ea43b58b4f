// What every command receives: language, threads, stop token, and functions to print messages without disturbing the
// progress bar.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "progress_bar.h"
#include "relief/messages.h"
#include "relief/work.h"

// Only sources that declare options include CLI11: its headers add over a second to the compilation of each.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace relief::app {

// Not thread-safe; used by the main thread.
class Session {
  public:
    Session(Language language, std::stop_token stop) : language_(language), stop_(std::move(stop)) {}

    Language language() const { return language_; }
    const std::stop_token& stop() const { return stop_; }
    // Settings; to be called before the first work().
    void setQuiet(bool quiet) { quiet_ = quiet; }
    void setVerbose(bool verbose) { verbose_ = verbose; }
    bool verbose() const { return verbose_; }
    // threads: 0 for all processors.
    void setThreads(int threads) { threads_ = threads; }
    int threads() const { return threads_; }

    // Created on first use.
    Work& work();
    // Prints "relief: SUBJECT: ..." on standard error, unless --quiet.
    void note(const std::string& subject, const Message& message);
    // Erases the progress bar, before other output to the terminal.
    void eraseBar() {
        if (bar_) bar_->erase();
    }

  private:
    Language language_;
    std::stop_token stop_;
    bool quiet_ = false;
    bool verbose_ = false;
    int threads_ = 0;
    std::unique_ptr<ProgressBar> bar_;
    std::unique_ptr<Work> work_;
};

// Prints "relief: ..." on standard error, always as one line.
void sayLine(const std::string& text);
// Writes that memory has ended, when there is none for a message either. Allocates nothing. Returns the exit status.
int sayMemoryEnded();

// Exit statuses of all commands. Wrong usage and unusable input are 2 in every command; an interrupted command ends
// with 128 + the signal's number.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;  // the work failed, or a check has found a violation
inline constexpr int kBadUsage = 2;
inline constexpr int kUndecided = 3;  // a check could not be decided

// A command of the program: its parser and its implementation, which returns the exit status.
struct Command {
    CLI::App* parser = nullptr;
    std::function<int(Session&)> run;
    int failed = kFailed;  // exit status if the work fails
};
using Commands = std::vector<Command>;

// Each adds a command to the parser and to the list.
void addHelpCommand(CLI::App& program, Commands& commands);
void addInfoCommand(CLI::App& program, Commands& commands);
void addMakeCommand(CLI::App& program, Commands& commands);
void addMapCommand(CLI::App& program, Commands& commands);
void addTileCommand(CLI::App& program, Commands& commands);
void addClaimsCommand(CLI::App& program, Commands& commands);
void addListCommand(CLI::App& program, Commands& commands);
void addRenderCommand(CLI::App& program, Commands& commands);
void addTraceCommand(CLI::App& program, Commands& commands);
void addCompareCommand(CLI::App& program, Commands& commands);
void addStressCommand(CLI::App& program, Commands& commands);
void addCertifyCommand(CLI::App& program, Commands& commands);
void addDiagnoseCommand(CLI::App& program, Commands& commands);
void addBenchCommand(CLI::App& program, Commands& commands);
void addRecommendCommand(CLI::App& program, Commands& commands);
void addExportCommand(CLI::App& program, Commands& commands);
void addMergeCommand(CLI::App& program, Commands& commands);

}  // namespace relief::app
