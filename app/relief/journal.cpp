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

// When this process began, in the system's own count: numbers of processes are given again. 0: there is none, it has
// ended and only its parent has not heard of it yet, or the system does not tell.
std::int64_t startOf(std::int64_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text;
    std::getline(file, text);
    // Its name, in brackets, may hold anything; the start is the 20th field after it.
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

bool lives(const Json& head) {
    const std::int64_t process = numberIn(head, "process", 0);
    if (process <= 0 || process == getpid()) return false;
    const bool there = kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
    const std::int64_t since = numberIn(head, "since", 0);
    return there && since != 0 && startOf(process) == since;
}

// A journal's whole lines; the first one is about the whole.
std::vector<Json> linesOf(const std::string& path) {
    std::vector<Json> all;
    const std::string text = readTextFile(path);
    std::size_t first = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', first)) {
        all.push_back(Json::parse(text.substr(first, end - first), nullptr, false));  // discarded where it is no JSON
        first = end + 1;
    }
    return all;
}

// Device and inode; zeros where there is none.
std::pair<std::uint64_t, std::uint64_t> numberOf(const std::string& path) {
    struct stat info {};
    if (stat(path.c_str(), &info) != 0) return {};
    return {info.st_dev, info.st_ino};
}

[[noreturn]] void refuseBeside(const std::string& path, const Json& head) {
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
        const std::string text = takenOver(kept, earlier);
        anything_ = !text.empty();
        takePlace(before, firstLine(kept) + text);
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
    if (anything_)
        ::close(descriptor_);
    else
        remove();
}

// Unless another run has taken its place.
void Journal::remove() {
    ::close(std::exchange(descriptor_, -1));
    if (numberOf(path_) == own_) ::unlink(path_.c_str());
}

std::string Journal::firstLine(const Json& work) const {
    const auto process = static_cast<std::int64_t>(getpid());
    return lineText({{"work", work}, {"host", hostName()}, {"process", process}, {"since", startOf(process)}});
}

// A process of another host cannot be asked: --resume is believed.
void Journal::refuseTheLiving(const Json& head) {
    const std::string host = textIn(head, "host");
    if (host == hostName() && lives(head)) refuseBeside(path_, head);
    if (!host.empty() && host != hostName()) otherHost_ = host;
}

// Lines of the parts that an earlier run of this work has done; its journal may be replaced.
std::string Journal::takenOver(const Json& work, EarlierRun earlier) {
    std::string kept;
    const std::vector<Json> lines = linesOf(path_);
    const Json head = lines.empty() || !lines.front().is_object() ? Json::object() : lines.front();
    refuseTheLiving(head);
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
            // Of a part that is there twice the last one counts: the first could not be used.
            found->insert_or_assign(static_cast<std::size_t>(part), *result);
            kept += lineText(line);
        }
    }
    return kept;
}

// The earlier journal gives way to `text` at one stroke: it is lost at no moment, and where another run has taken it
// over since it was read, that one's is put back.
void Journal::takePlace(const FileNumber& before, const std::string& text) {
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
        return next.commit();  // this file system cannot exchange names
    }
    if (numberOf(name) == before) return;
    exchange();
    ::close(std::exchange(descriptor_, -1));
    refuseTheSecond();
}

void Journal::refuseTheSecond() const {
    const std::vector<Json> lines = linesOf(path_);
    refuseBeside(path_, lines.empty() ? Json() : lines.front());
}

void Journal::write(const std::string& text) {
    // A run on another host may have gone on from here, assuming that this one had ended.
    const FileNumber now = numberOf(path_);
    if (own_ != FileNumber() && now != FileNumber() && now != own_) refuseTheSecond();
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
    anything_ = true;
}

void Journal::keepCounts(std::size_t part, const Json& counts) {
    write(lineText({{"counted", part}, {"result", counts}}));
    anything_ = true;
}

void Journal::finish() {
    remove();
}

}  // namespace relief::app
