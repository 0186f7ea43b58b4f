#include "images/file_descriptor.h"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "relief/errors.h"

namespace relief {

int Descriptor::close() {
    if (number_ < 0) return 0;
    return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
}

::ssize_t readAt(int descriptor, std::int64_t at, void* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
        const ::ssize_t got = ::pread(descriptor, static_cast<char*>(to) + done, count - done,
                                      static_cast<::off_t>(at + static_cast<std::int64_t>(done)));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return -1;
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    return static_cast<::ssize_t>(done);
}

void requireRegular(const std::string& path, const struct stat& status) {
    if (S_ISDIR(status.st_mode)) throw InputError(path, Message(MessageId::FileIsDirectory));
    if (!S_ISREG(status.st_mode)) throw InputError(path, Message(MessageId::FileNotRegular));
}

}  // namespace relief
