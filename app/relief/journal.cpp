#include "journal.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "relief/errors.h"
#include "relief/files.h"
#include "team.h"

namespace relief::app {

namespace {

[[noreturn]] void failWriting(const std::string& path) {
    throw WorkError(path, Message(MessageId::FileUnwritable, {{"why", std::strerror(errno)}}));
}

std::string lineText(const Json& json) {
    return asciiLine(json) + "\n";
}

// Returns the process's start time in clock ticks since boot; together with the id it identifies a process, as ids are
// reused. 0: there is no such process, it is a zombie, or the system does not report it.
std::int64_t startOf(std::int64_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    // The process name, in brackets, may contain any character; the start time is the 20th field after it.
    const std::size_t name = text.rfind(')');
    if (name == std::string::npos) return 0;
    constexpr int kFields = 20;
    std::istringstream fields(text.substr(name + 1));
    std::string field;
    for (int n = 0; n < kFields; ++n) {
        fields >> field;
        if (n == 0 && (field == "Z" || field == "X")) return 0;
    }
    return std::strtoll(field.c_str(), nullptr, 10);
}

bool isAlive(const Json& head) {
    const std::int64_t process = numberIn(head, "process", 0);
    if (process <= 0 || process == getpid()) return false;
    const bool there = kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
    const std::int64_t since = numberIn(head, "since", 0);
    return there && since != 0 && startOf(process) == since;
}

// Returns the complete lines of a journal; the first one describes the run.
std::vector<Json> linesOf(const std::string& path) {
    std::vector<Json> all;
    const std::string text = readTextFile(path);
    std::size_t first = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', first)) {
        // discarded() if the line is no JSON
        all.push_back(Json::parse(text.substr(first, end - first), nullptr, false));
        first = end + 1;
    }
    return all;
}

// Returns device and inode; zeros if there is no such file.
std::pair<std::uint64_t, std::uint64_t> numberOf(const std::string& path) {
    struct stat info {};
    if (stat(path.c_str(), &info) != 0) return {};
    return {info.st_dev, info.st_ino};
}

[[noreturn]] void refuseConcurrent(const std::string& path, const Json& head) {
    throw InputError(path, Message(MessageId::SweepAlive,
                                   {{"process", numberIn(head, "process", 0)}, {"host", textIn(head, "host")}}));
}

}  // namespace

Journal::Journal(const std::string& output, const Json& work, std::size_t parts, EarlierRun earlier)
    : path_(output + ".part"), parts_(parts) {
    const Json kept = readBack(work);
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) failWriting(path_);
    if (descriptor_ < 0) {
        const FileNumber before = numberOf(path_);
        const std::string text = adoptEarlier(kept, earlier);
        hasResults_ = !text.empty();
        replaceJournal(before, firstLine(kept) + text);
        return;
    }
    own_ = numberOf(path_);
    try {
        write(firstLine(kept));
    } catch (...) {
        ::close(descriptor_);
        ::unlink(path_.c_str());
        throw;
    }
}

Journal::~Journal() {
    if (descriptor_ < 0) return;
    if (hasResults_)
        ::close(descriptor_);
    else
        remove();
}

// Leaves the file alone if another run has replaced it.
void Journal::remove() {
    ::close(std::exchange(descriptor_, -1));
    if (numberOf(path_) == own_) ::unlink(path_.c_str());
}

std::string Journal::firstLine(const Json& work) const {
    const auto process = static_cast<std::int64_t>(getpid());
    return lineText({{"work", work}, {"host", hostName()}, {"process", process}, {"since", startOf(process)}});
}

// Whether a process of another host is alive cannot be determined: there the user's --resume is trusted.
void Journal::refuseIfAlive(const Json& head) {
    const std::string host = textIn(head, "host");
    if (host == hostName() && isAlive(head)) refuseConcurrent(path_, head);
    if (!host.empty() && host != hostName()) otherHost_ = host;
}

// Reads what an earlier run of the same work has done into earlier_ and returns its lines. Throws InputError if the
// journal must not be replaced.
std::string Journal::adoptEarlier(const Json& work, EarlierRun earlier) {
    std::string kept;
    const std::vector<Json> lines = linesOf(path_);
    const Json head = lines.empty() || !lines.front().is_object() ? Json::object() : lines.front();
    refuseIfAlive(head);
    if (earlier == EarlierRun::Refuse) throw InputError(path_, Message(MessageId::SweepThere));
    if (earlier == EarlierRun::Replace) return kept;
    if (head.value("work", Json()) != work) throw InputError(path_, Message(MessageId::SweepOther));
    for (const Json& line : lines) {
        const Json* const result = member(line, "result");
        if (result == nullptr) continue;
        for (const auto& [key, found] :
             {std::pair("part", &earlier_.results), std::pair("counted", &earlier_.counts)}) {
            const std::int64_t part = numberIn(line, key, -1);
            if (part < 0 || static_cast<std::size_t>(part) >= parts_) continue;
            // If a part occurs twice, the last result counts: a part is repeated only if its first result was unusable.
            found->insert_or_assign(static_cast<std::size_t>(part), *result);
            kept += lineText(line);
        }
    }
    return kept;
}

// Replaces the earlier journal by `text` atomically, so that it is never lost. If another run has replaced it since it
// was read, that run's journal is put back and this run refuses.
void Journal::replaceJournal(const FileNumber& before, const std::string& text) {
    AtomicFile next(path_);
    const std::string& name = next.temporaryPath();
    const auto exchange = [&] {
        return renameat2(AT_FDCWD, name.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0;
    };
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) failWriting(path_);
    write(text);
    if (fsync(descriptor_) != 0) failWriting(path_);
    own_ = numberOf(name);
    if (!exchange()) {
        if (errno == ENOENT) failWriting(path_);
        return next.commit();  // the file system does not support RENAME_EXCHANGE
    }
    if (numberOf(name) == before) return;
    exchange();
    ::close(std::exchange(descriptor_, -1));
    refuseSecondRun();
}

void Journal::refuseSecondRun() const {
    const std::vector<Json> lines = linesOf(path_);
    refuseConcurrent(path_, lines.empty() ? Json() : lines.front());
}

void Journal::write(const std::string& text) {
    // A run on another host may have taken over, assuming that this one had ended.
    const FileNumber now = numberOf(path_);
    if (own_ != FileNumber() && now != FileNumber() && now != own_) refuseSecondRun();
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t now = ::write(descriptor_, text.data() + written, text.size() - written);
        if (now < 0 && errno == EINTR) continue;
        if (now < 0) failWriting(path_);
        written += static_cast<std::size_t>(now);
    }
}

void Journal::keep(std::size_t part, const Json& result) {
    write(lineText({{"part", part}, {"result", result}}));
    hasResults_ = true;
}

void Journal::keepCounts(std::size_t part, const Json& counts) {
    write(lineText({{"counted", part}, {"result", counts}}));
    hasResults_ = true;
}

void Journal::finish() {
    remove();
}

}  // namespace relief::app
