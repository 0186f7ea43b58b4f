#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "images/file_descriptor.h"
#include "images/file_replacing.h"
#include "images/system_error.h"
#include "relief/files.h"
#include "relief/memory.h"

namespace relief {

namespace fs = std::filesystem;

Message systemMessage(int error, FileAccess access, const std::string& folder) {
    const bool writing = access == FileAccess::Write;
    if (error == EACCES || error == EPERM)
        return Message(writing ? MessageId::FileNoWritePermission : MessageId::FileNoReadPermission);
    if (error == EROFS) return Message(MessageId::FileSystemReadOnly);
    if (error == EISDIR) return Message(MessageId::FileIsDirectory);
    if (error == ENOSPC || error == EDQUOT) return Message(MessageId::DiskFull);
    if (error == ENOENT && writing) return Message(MessageId::FolderMissing, {{"folder", folder}});
    if (error == ENOENT) return Message(MessageId::FileMissing);
#ifdef __GLIBC__
    const char* text = strerrordesc_np(error);
    const std::string why = text ? text : "error " + std::to_string(error);
#else
    const std::string why = std::generic_category().message(error);
#endif
    return Message(writing ? MessageId::FileUnwritable : MessageId::FileUnreadable, {{"why", why}});
}

std::string oneLine(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool blank = static_cast<unsigned char>(c) <= ' ';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

namespace {

// Limit on the size of a text file to read, bytes: the path may name a device that never ends.
constexpr std::size_t kMaxTextBytes = std::size_t{1} << 32;

std::string folderOf(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

// A unique file name: clock, process id and a counter, mixed by splitmix64.
std::string freshName(const std::string& extension) {
    static std::atomic<std::uint64_t> count{0};
    const auto clock = std::chrono::steady_clock::now().time_since_epoch().count();
    std::uint64_t z = static_cast<std::uint64_t>(clock) + (static_cast<std::uint64_t>(::getpid()) << 40) +
                      0x9e3779b97f4a7c15ULL * (count.fetch_add(1) + 1);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    z ^= z >> 31;
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), z, 16).ptr;
    return ".relief-" + std::string(digits.data(), end) + extension;
}

// Returns 0, or the errno of the failure.
int writeAll(int descriptor, const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ::ssize_t wrote = ::write(descriptor, text.data() + done, text.size() - done);
        if (wrote > 0)
            done += static_cast<std::size_t>(wrote);
        else if (wrote == 0)
            return ENOSPC;
        else if (errno != EINTR)
            return errno;
    }
    return 0;
}

// Returns true for devices, pipes and what /dev/stdout refers to: they cannot be replaced by renaming.
bool isWrittenInPlace(const std::string& path) {
    // Files in /dev/shm are ordinary files.
    const bool device = path.starts_with("/dev/") && !path.starts_with("/dev/shm/");
    if (device || path.starts_with("/proc/")) return true;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

void throwUnwritable(const std::string& path, int error, const std::string& target) {
    throw WorkError(path, systemMessage(error, FileAccess::Write, folderOf(target)));
}

std::string linkTarget(const std::string& path) {
    fs::path target = path;
    for (int links = 0; links < 40; ++links) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(target, error))) return target.string();
        const fs::path next = fs::read_symlink(target, error);
        if (error) throwUnwritable(path, error.value(), target.string());
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    throwUnwritable(path, ELOOP, path);
}

void takePermissions(int descriptor, const std::string& target) {
    struct stat existing {};
    if (::stat(target.c_str(), &existing) == 0) static_cast<void>(::fchmod(descriptor, existing.st_mode & 0777));
}

void replaceFile(const std::string& complete, const std::string& target, const std::string& path) {
    if (::rename(complete.c_str(), target.c_str()) != 0) throwUnwritable(path, errno, target);
    // Makes the new name survive a power cut. Not every file system allows it; the file is complete either way.
    const Descriptor folder(::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.open()) static_cast<void>(::fsync(folder.number()));
}

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
    if (path_.empty()) throwUnwritable(path_, EINVAL, path_);
    target_ = linkTarget(path_);
    struct stat existing {};
    const bool exists = ::stat(target_.c_str(), &existing) == 0;
    if (exists && S_ISDIR(existing.st_mode)) throw WorkError(path_, Message(MessageId::FileIsDirectory));
    if (exists && !S_ISREG(existing.st_mode)) throw WorkError(path_, Message(MessageId::FileNotRegular));
    // Renaming would bypass a write protection that the user set on purpose.
    if (exists && ::access(target_.c_str(), W_OK) != 0) throwUnwritable(path_, errno, target_);

    const fs::path folder = fs::path(target_).parent_path();
    const std::string extension = fs::path(path_).extension().string();
    for (int attempt = 0; attempt < 100; ++attempt) {
        temporary_ = (folder / freshName(extension)).string();
        Descriptor file(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (file.open()) {
            takePermissions(file.number(), target_);
            return;
        }
        if (errno != EEXIST) throwUnwritable(path_, errno, target_);
    }
    throwUnwritable(path_, EEXIST, target_);
}

AtomicFile::~AtomicFile() {
    if (!committed_) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
    {
        const Descriptor file(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
        if (!file.open() || (::fsync(file.number()) != 0 && errno != EINVAL)) throwUnwritable(path_, errno, target_);
    }
    replaceFile(temporary_, target_, path_);
    committed_ = true;
}

void writeTextFile(const std::string& path, const std::string& text) {
    if (isWrittenInPlace(path)) {
        // Appends, so that earlier output of the shell's redirection is kept.
        Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
        int error = file.open() ? writeAll(file.number(), text) : errno;
        if (file.open() && error == 0) error = file.close();
        if (error != 0) throwUnwritable(path, error, path);
        return;
    }
    AtomicFile output(path);
    Descriptor file(::open(output.temporaryPath().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    int error = file.open() ? writeAll(file.number(), text) : errno;
    if (file.open() && error == 0) error = file.close();
    if (error != 0) throwUnwritable(path, error, path);
    output.commit();
}

std::string readTextFile(const std::string& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::is_directory(status)) throw InputError(path, Message(MessageId::FileIsDirectory));
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.open()) throw InputError(path, systemMessage(errno, FileAccess::Read));
    std::string text;
    std::size_t size = 0;
    for (;;) {
        text.resize(std::max<std::size_t>(size + 65536, text.size()));
        const ::ssize_t got = ::read(file.number(), text.data() + size, text.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw InputError(path, systemMessage(errno, FileAccess::Read));
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
        if (size > kMaxTextBytes) throw InputError(path, systemMessage(EFBIG, FileAccess::Read));
        if (size < text.size()) continue;
        requireMemory(byteProduct({2, size}), path);
        text.resize(size * 2);
    }
    text.resize(size);
    return text;
}

}  // namespace relief
