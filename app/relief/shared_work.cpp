#include "shared_work.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>
#include <utility>

#include "errors.h"
#include "images/files.h"

namespace relief::app {

namespace {

using Clock = std::chrono::steady_clock;

// Bytes that stand for what is locked; files end long before.
constexpr off_t kAppending = off_t{1} << 40;
constexpr off_t kFinishing = kAppending + 1;
constexpr off_t kParts = kAppending + 2;

constexpr auto kPause = std::chrono::milliseconds(20);
constexpr auto kWaitForFile = std::chrono::seconds(30);   // for rank 0 to begin
constexpr auto kWaitForOthers = std::chrono::seconds(5);  // at the end, for processes that have not come yet

[[noreturn]] void failWriting(const std::string& path) {
    throw WorkError(path, Message(MessageId::FileUnwritable, {{"why", std::strerror(errno)}}));
}

Json parsedLine(const std::string& line) {
    return Json::parse(line, nullptr, false);  // discarded where it is no JSON
}

std::string lineText(const Json& json) {
    // File names need not be UTF-8.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

// An open file with locks that end with the process, or with the file's closing.
class SharedWork::File {
  public:
    // alone: nobody else writes it, so that it may do without locks.
    File(std::string path, bool alone)
        : path_(std::move(path)), alone_(alone), descriptor_(::open(path_.c_str(), O_RDWR | O_CLOEXEC)) {}
    ~File() {
        if (removed_) ::unlink(path_.c_str());
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    bool isOpen() const { return descriptor_ >= 0; }
    // false: another holds it. Throws WorkError where there are no locks and others need them.
    bool tryLock(off_t byte) {
        if (lockError_ != 0 || set(F_WRLCK, byte)) return true;
        if (errno == EAGAIN || errno == EACCES || errno == EINTR) return false;
        if (!alone_) throw WorkError(path_, Message(MessageId::LocksNeeded, {{"why", std::strerror(errno)}}));
        lockError_ = errno;
        return true;
    }
    void unlock(off_t byte) {
        if (lockError_ == 0) set(F_UNLCK, byte);
    }
    int lockError() const { return lockError_; }
    // Whether the file goes when it is closed.
    void removeAtEnd(bool removed) { removed_ = removed; }

    // What was added since the last call.
    std::string readOn() {
        std::string text;
        char buffer[1 << 16];
        while (true) {
            const ssize_t got = ::pread(descriptor_, buffer, sizeof buffer, read_);
            if (got <= 0) return text;
            text.append(buffer, static_cast<std::size_t>(got));
            read_ += got;
        }
    }
    // Under the lock kAppending. false: errno says why.
    bool append(std::string text) {
        const off_t end = ::lseek(descriptor_, 0, SEEK_END);
        char last = '\n';
        if (end > 0 && ::pread(descriptor_, &last, 1, end - 1) == 1 && last != '\n') text.insert(text.begin(), '\n');
        std::size_t written = 0;
        while (written < text.size()) {
            const ssize_t now =
                ::pwrite(descriptor_, text.data() + written, text.size() - written, end + static_cast<off_t>(written));
            if (now < 0 && errno == EINTR) continue;
            if (now < 0) return false;
            written += static_cast<std::size_t>(now);
        }
        return true;
    }

  private:
    bool set(short type, off_t byte) {
        struct flock lock {};
        lock.l_type = type;
        lock.l_whence = SEEK_SET;
        lock.l_start = byte;
        lock.l_len = 1;
        return ::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0;
    }

    std::string path_;
    bool alone_;
    int descriptor_;
    off_t read_ = 0;
    int lockError_ = 0;
    bool removed_ = false;
};

SharedWork::SharedWork(const std::string& output, const Json& what, std::size_t parts, EarlierRun earlier,
                       Launch launch, std::stop_token stop)
    : path_(output + ".part"), launch_(std::move(launch)), stop_(std::move(stop)), results_(parts) {
    // As it will be read: numbers and names take the form that a file gives them.
    const Json kept = parsedLine(lineText(what));
    if (launch_.rank == 0) {
        begin(kept, earlier);
    } else {
        join(kept);
    }
    append({{"rank", launch_.rank}});
    // Others may do parts of it from here on.
    if (launch_.size > 1) file_->removeAtEnd(false);
    refresh();
}

SharedWork::~SharedWork() = default;

int SharedWork::lockError() const {
    return file_->lockError();
}

// Lines of parts that an earlier run of this work has left.
std::string SharedWork::keptLines(const Json& what) const {
    std::string kept;
    const std::string old = readTextFile(path_);
    std::size_t first = 0;
    for (std::size_t end = old.find('\n'); end != std::string::npos; end = old.find('\n', first)) {
        const Json line = parsedLine(old.substr(first, end - first));
        if (first == 0 && (!line.is_object() || line.value("work", Json()) != what)) {
            throw InputError(path_, Message(MessageId::SweepOther));
        }
        if (line.is_object() && line.contains("part")) kept += lineText(line);
        first = end + 1;
    }
    if (first == 0) throw InputError(path_, Message(MessageId::SweepOther));
    return kept;
}

// Made beside and renamed, so that nobody sees half of it; what an earlier run has done is taken over.
void SharedWork::begin(const Json& what, EarlierRun earlier) {
    const bool there = ::access(path_.c_str(), F_OK) == 0;
    if (there && earlier == EarlierRun::Refuse) throw InputError(path_, Message(MessageId::SweepThere));
    const std::string kept = there && earlier == EarlierRun::Resume ? keptLines(what) : "";
    writeTextFile(path_, lineText({{"work", what}, {"job", launch_.job}}) + kept);
    file_ = std::make_unique<File>(path_, launch_.size == 1);
    if (!file_->isOpen()) failWriting(path_);
    file_->removeAtEnd(kept.empty());
}

void SharedWork::join(const Json& what) {
    const auto begun = Clock::now();
    while (true) {
        file_ = std::make_unique<File>(path_, false);
        if (file_->isOpen()) {
            const std::string text = file_->readOn();
            const Json head = parsedLine(text.substr(0, text.find('\n')));
            if (head.is_object() && head.value("job", "") == launch_.job) {
                if (head.value("work", Json()) != what) throw InputError(path_, Message(MessageId::SweepOther));
                unread_ = text;
                return;
            }
        }
        if (Clock::now() - begun > kWaitForFile) {
            throw WorkError(path_, Message(MessageId::SweepNotBegun, {{"seconds", kWaitForFile.count()}}));
        }
        pause();
    }
}

void SharedWork::pause() const {
    if (stop_.stop_requested()) throw Cancelled();
    std::this_thread::sleep_for(kPause);
}

void SharedWork::refresh() {
    unread_ += file_->readOn();
    std::size_t first = 0;
    for (std::size_t end = unread_.find('\n'); end != std::string::npos; end = unread_.find('\n', first)) {
        const Json line = parsedLine(unread_.substr(first, end - first));
        first = end + 1;
        if (!line.is_object()) continue;
        if (line.contains("rank")) ++arrived_;
        if (line.contains("finished")) finished_ = true;
        const std::size_t part = line.value("part", results_.size());
        if (part >= results_.size() || results_[part]) continue;
        results_[part] = line.value("result", Json());
        ++done_;
        file_->removeAtEnd(false);
    }
    unread_.erase(0, first);
}

void SharedWork::append(const Json& line) {
    while (!file_->tryLock(kAppending)) pause();
    const bool written = file_->append(lineText(line));
    const int error = errno;
    file_->unlock(kAppending);
    errno = error;
    if (!written) failWriting(path_);
}

std::optional<std::size_t> SharedWork::take() {
    while (true) {
        refresh();
        if (done_ == results_.size()) return std::nullopt;
        for (std::size_t part = 0; part < results_.size(); ++part) {
            const off_t byte = kParts + static_cast<off_t>(part);
            if (results_[part] || !file_->tryLock(byte)) continue;
            // Whoever held it may have finished it just now.
            refresh();
            if (!results_[part]) return part;
            file_->unlock(byte);
        }
        pause();
    }
}

void SharedWork::put(std::size_t part, const Json& result) {
    append({{"part", part}, {"by", launch_.rank}, {"result", result}});
    file_->unlock(kParts + static_cast<off_t>(part));
    refresh();
}

std::optional<std::vector<Json>> SharedWork::collect() {
    // A process that dies while it finishes leaves that to the next.
    while (!file_->tryLock(kFinishing)) {
        refresh();
        if (finished_) return std::nullopt;
        pause();
    }
    refresh();
    if (finished_) return std::nullopt;
    std::vector<Json> all;
    for (const std::optional<Json>& result : results_) all.push_back(*result);
    return all;
}

void SharedWork::finish() {
    append({{"finished", true}});
    const auto begun = Clock::now();
    // One that comes later would find no file, and wait for it in vain.
    while (arrived_ < launch_.size && Clock::now() - begun < kWaitForOthers) {
        pause();
        refresh();
    }
    file_->removeAtEnd(true);
    file_.reset();
}

}  // namespace relief::app
