#include "output.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

namespace relief::app {

namespace {

constexpr int kPollMilliseconds = 100;

[[noreturn]] void failWriting(const std::string& name, int error) {
    throw WorkError(name, Message(MessageId::FileUnwritable, {{"why", std::strerror(error)}}));
}

std::string standardOutputName() {
    return "standard output";
}

// Waits until the descriptor is ready, polling the stop token meanwhile.
void waitReady(int descriptor, short events, const std::stop_token& stop) {
    pollfd entry{descriptor, events, 0};
    while (true) {
        if (stop.stop_requested()) throw Cancelled();
        const int ready = poll(&entry, 1, kPollMilliseconds);
        // errors are reported by the read or write that follows
        if (ready > 0 || (ready < 0 && errno != EINTR)) return;
    }
}

std::optional<mode_t> fileMode(const std::string& path) {
    struct stat info {};
    if (stat(path.c_str(), &info) != 0) return std::nullopt;
    return info.st_mode;
}

// Devices, pipes and sockets must be written to, never replaced by a renamed file.
bool writtenDirectly(const std::string& path) {
    // Descriptors that the shell has opened, whatever they refer to. (/dev/shm holds ordinary files.)
    for (const char* opened : {"/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/"}) {
        if (path.starts_with(opened)) return true;
    }
    const auto mode = fileMode(path);
    return mode && !S_ISREG(*mode) && !S_ISDIR(*mode);
}

}  // namespace

TextOutput::TextOutput(std::string path, std::stop_token stop) : name_(std::move(path)), stop_(std::move(stop)) {
    if (name_ == "-") {
        name_ = standardOutputName();
        descriptor_ = STDOUT_FILENO;
    } else {
        const bool direct = writtenDirectly(name_);
        if (!direct) file_ = std::make_unique<AtomicFile>(name_);
        const std::string& target = direct ? name_ : file_->temporaryPath();
        const int create = direct ? O_APPEND : O_CREAT | O_TRUNC;
        descriptor_ = ::open(target.c_str(), O_WRONLY | O_CLOEXEC | create, 0666);
        if (descriptor_ < 0) failWriting(name_, errno);
        owned_ = true;
    }
    struct stat info {};
    inPieces_ = fstat(descriptor_, &info) == 0 && !S_ISREG(info.st_mode);
}

TextOutput::~TextOutput() {
    if (owned_ && descriptor_ >= 0) ::close(descriptor_);
}

void TextOutput::write(std::string_view text) {
    while (!text.empty()) {
        if (inPieces_) waitReady(descriptor_, POLLOUT, stop_);
        const std::size_t piece = inPieces_ ? std::min<std::size_t>(text.size(), PIPE_BUF) : text.size();
        const ssize_t written = ::write(descriptor_, text.data(), piece);
        if (written < 0) {
            if (errno == EINTR || errno == EAGAIN) continue;
            if (errno == EPIPE) throw OutputClosed();
            failWriting(name_, errno);
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void TextOutput::close() {
    if (!owned_) return;
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0) failWriting(name_, errno);
}

void TextOutput::commit() {
    close();
    if (file_) file_->commit();
}

void TextOutput::discard() const {
    if (file_) ::unlink(file_->temporaryPath().c_str());
}

void writeStandardOutput(std::string_view text, std::stop_token stop) {
    TextOutput output("-", std::move(stop));
    output.write(text);
    output.commit();
}

std::string readStandardInput(const std::stop_token& stop) {
    std::string text;
    std::array<char, 1 << 16> buffer{};
    while (true) {
        waitReady(STDIN_FILENO, POLLIN, stop);
        const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (got == 0) return text;
        if (got < 0) {
            if (errno == EINTR || errno == EAGAIN) continue;
            throw InputError("standard input", Message(MessageId::FileUnreadable, {{"why", std::strerror(errno)}}));
        }
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
}

std::string fileEnding(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    const std::size_t dot = path.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    std::string ending = path.substr(dot + 1);
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

void checkOutput(const std::string& path, const std::vector<std::string>& endings) {
    if (std::find(endings.begin(), endings.end(), fileEnding(path)) == endings.end()) {
        std::string known;
        for (const std::string& ending : endings) known += (known.empty() ? "." : ", .") + ending;
        throw InputError(path, Message(MessageId::OutputEnding, {{"known", known}}));
    }
    checkOutputFolder(path);
}

void checkOutputFolder(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const auto mode = fileMode(folder.empty() ? "." : folder.string());
    if (!mode || !S_ISDIR(*mode)) {
        throw WorkError(path, Message(MessageId::OutputFolderMissing, {{"folder", folder.string()}}));
    }
    const auto target = fileMode(path);
    if (target && S_ISDIR(*target)) throw WorkError(path, Message(MessageId::FileIsDirectory));
}

void refuseOverwriting(const std::string& option, const std::string& output, const std::vector<std::string>& files,
                       const std::string& written) {
    const std::string& path = written.empty() ? output : written;
    const auto mode = fileMode(path);
    if (path == "-" || !mode || !S_ISREG(*mode)) return;
    for (const std::string& file : files) {
        std::error_code none;
        if (!std::filesystem::equivalent(file, path, none)) continue;
        throw InputError(file, Message(MessageId::FileOverwritten, {{"output", option + " " + output}}));
    }
}

}  // namespace relief::app
