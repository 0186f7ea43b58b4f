// A library to be preloaded: the N-th call of a kind fails, as it does when a disk is full, a device breaks, a signal
// interrupts, or memory ends. The calls of standard input, output and error are left alone.
//   RELIEF_FAULT=KIND:N:ERROR   KIND: open, read, write, sync, rename, map or memory; N: from 1; ERROR: a number of
//   errno,
//                               -1: half of the bytes are read or written; +: this and all later calls fail
//                               (KIND:N:ERROR+)
//   RELIEF_FAULT=cut:N:0        before the N-th reading or mapping of a file in the folder RELIEF_FAULT_FOLDER another
//                               program cuts that file to half its size; :1: to nothing
//   RELIEF_FAULT_COUNT=FILE     at exit, the number of calls of each kind is written to FILE
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum Kind { kOpen, kRead, kWrite, kSync, kRename, kMap, kMemory, kCut, kKinds };
constexpr std::array<const char*, kKinds> kNames{"open", "read", "write", "sync", "rename", "map", "memory", "cut"};

std::array<std::atomic<long>, kKinds> counts{};
int faultKind = -1;
long faultCall = 0;
int faultError = 0;
bool faultStays = false;
bool ready = false;
// Libraries do not survive a failure while they are loaded; what they call then is not counted.
thread_local bool loading = false;

__attribute__((constructor)) void readSettings() {
    if (const char* const text = std::getenv("RELIEF_FAULT")) {
        std::array<char, 16> name{};
        char stays = ' ';
        if (std::sscanf(text, "%15[a-z]:%ld:%d%c", name.data(), &faultCall, &faultError, &stays) >= 3) {
            for (int k = 0; k < kKinds; ++k) {
                if (std::strcmp(name.data(), kNames[static_cast<std::size_t>(k)]) == 0) faultKind = k;
            }
            faultStays = stays == '+';
        }
    }
    ready = true;
}

__attribute__((destructor)) void writeCounts() {
    ready = false;
    const char* const path = std::getenv("RELIEF_FAULT_COUNT");
    if (path == nullptr) return;
    if (std::FILE* const file = std::fopen(path, "w")) {
        for (int k = 0; k < kKinds; ++k) {
            const auto n = static_cast<std::size_t>(k);
            std::fprintf(file, "%s %ld\n", kNames[n], counts[n].load());
        }
        std::fclose(file);
    }
}

// Counts a call; returns true if it is to fail.
bool fails(Kind kind) {
    if (!ready || loading) return false;
    const long call = ++counts[kind];
    return kind == faultKind && (call == faultCall || (faultStays && call > faultCall));
}

bool failsWith(Kind kind) {
    if (!fails(kind)) return false;
    errno = faultError;
    return true;
}

// The function of this name that would be called without this library.
template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// Cuts the file that is about to be read, if this is the call. Files that are open for writing are this program's own.
void cutNow(int descriptor) {
    static const char* const folder = std::getenv("RELIEF_FAULT_FOLDER");
    if (folder == nullptr || !ready || loading || (::fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY) return;
    std::array<char, 32> link{};
    std::array<char, 4096> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
    if (::readlink(link.data(), path.data(), path.size() - 1) <= 0) return;
    if (std::strncmp(path.data(), folder, std::strlen(folder)) != 0 || !fails(kCut)) return;
    struct stat status {};
    if (::stat(path.data(), &status) != 0 || !S_ISREG(status.st_mode)) return;
    static_cast<void>(::truncate(path.data(), faultError == 1 ? 0 : status.st_size / 2));
}

// Bytes that a call may transfer; 0: it fails.
std::size_t allowed(Kind kind, int descriptor, std::size_t bytes) {
    if (kind == kRead) cutNow(descriptor);
    if (descriptor <= STDERR_FILENO || !fails(kind)) return bytes;
    if (faultError == -1) return (bytes + 1) / 2;
    errno = faultError;
    return 0;
}

// Devices, and the system's descriptions of itself, are not files of the user: a failure to read them ends the process
// inside libraries (libgcrypt).
bool failsToOpen(const char* path) {
    for (const char* const folder : {"/proc/", "/sys/", "/dev/"}) {
        if (std::strncmp(path, folder, std::strlen(folder)) == 0) return false;
    }
    return failsWith(kOpen);
}

int openedFile(const char* function, const char* path, int flags, mode_t mode) {
    return failsToOpen(path) ? -1 : next<int(const char*, int, ...)>(function)(path, flags, mode);
}

mode_t modeOf(int flags, va_list list) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(list, unsigned)) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = modeOf(flags, list);
    va_end(list);
    return openedFile("open", path, flags, mode);
}
int open64(const char* path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    const mode_t mode = modeOf(flags, list);
    va_end(list);
    return openedFile("open64", path, flags, mode);
}
std::FILE* fopen(const char* path, const char* mode) {
    return failsToOpen(path) ? nullptr : next<std::FILE*(const char*, const char*)>("fopen")(path, mode);
}
std::FILE* fopen64(const char* path, const char* mode) {
    return failsToOpen(path) ? nullptr : next<std::FILE*(const char*, const char*)>("fopen64")(path, mode);
}

void* dlopen(const char* path, int mode) {
    loading = true;
    void* const library = next<void*(const char*, int)>("dlopen")(path, mode);
    loading = false;
    return library;
}

ssize_t read(int descriptor, void* to, size_t bytes) {
    const std::size_t some = allowed(kRead, descriptor, bytes);
    if (some == 0 && bytes > 0) return -1;
    return next<ssize_t(int, void*, size_t)>("read")(descriptor, to, some);
}
ssize_t pread(int descriptor, void* to, size_t bytes, off_t at) {
    const std::size_t some = allowed(kRead, descriptor, bytes);
    if (some == 0 && bytes > 0) return -1;
    return next<ssize_t(int, void*, size_t, off_t)>("pread")(descriptor, to, some, at);
}
ssize_t pread64(int descriptor, void* to, size_t bytes, off64_t at) {
    const std::size_t some = allowed(kRead, descriptor, bytes);
    if (some == 0 && bytes > 0) return -1;
    return next<ssize_t(int, void*, size_t, off64_t)>("pread64")(descriptor, to, some, at);
}
ssize_t write(int descriptor, const void* from, size_t bytes) {
    const std::size_t some = allowed(kWrite, descriptor, bytes);
    if (some == 0 && bytes > 0) return -1;
    return next<ssize_t(int, const void*, size_t)>("write")(descriptor, from, some);
}
ssize_t pwrite(int descriptor, const void* from, size_t bytes, off_t at) {
    const std::size_t some = allowed(kWrite, descriptor, bytes);
    if (some == 0 && bytes > 0) return -1;
    return next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(descriptor, from, some, at);
}
ssize_t pwrite64(int descriptor, const void* from, size_t bytes, off64_t at) {
    const std::size_t some = allowed(kWrite, descriptor, bytes);
    if (some == 0 && bytes > 0) return -1;
    return next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(descriptor, from, some, at);
}

int fsync(int descriptor) {
    return failsWith(kSync) ? -1 : next<int(int)>("fsync")(descriptor);
}
int fdatasync(int descriptor) {
    return failsWith(kSync) ? -1 : next<int(int)>("fdatasync")(descriptor);
}
int ftruncate(int descriptor, off_t size) noexcept {
    return failsWith(kSync) ? -1 : next<int(int, off_t)>("ftruncate")(descriptor, size);
}
int ftruncate64(int descriptor, off64_t size) noexcept {
    return failsWith(kSync) ? -1 : next<int(int, off64_t)>("ftruncate64")(descriptor, size);
}
int rename(const char* from, const char* to) noexcept {
    return failsWith(kRename) ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

void* mmap(void* at, size_t bytes, int protection, int flags, int descriptor, off_t offset) noexcept {
    if (descriptor >= 0) cutNow(descriptor);
    if (descriptor >= 0 && failsWith(kMap)) return MAP_FAILED;
    return next<void*(void*, size_t, int, int, int, off_t)>("mmap")(at, bytes, protection, flags, descriptor, offset);
}
void* mmap64(void* at, size_t bytes, int protection, int flags, int descriptor, off64_t offset) noexcept {
    if (descriptor >= 0) cutNow(descriptor);
    if (descriptor >= 0 && failsWith(kMap)) return MAP_FAILED;
    return next<void*(void*, size_t, int, int, int, off64_t)>("mmap64")(at, bytes, protection, flags, descriptor,
                                                                        offset);
}

// glibc's own names, since dlsym() may allocate.
void* __libc_malloc(size_t bytes);
void* __libc_memalign(size_t alignment, size_t bytes);
void* malloc(size_t bytes) noexcept {
    return failsWith(kMemory) ? nullptr : __libc_malloc(bytes);
}
void* aligned_alloc(size_t alignment, size_t bytes) noexcept {
    return failsWith(kMemory) ? nullptr : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** to, size_t alignment, size_t bytes) noexcept {
    if (fails(kMemory)) return ENOMEM;
    void* const memory = __libc_memalign(alignment, bytes);
    if (memory == nullptr) return ENOMEM;
    *to = memory;
    return 0;
}
}
