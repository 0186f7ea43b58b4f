#include "images/page_watch.h"

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <type_traits>

namespace relief {

// A watched range. Ranges are never freed, because the handler may be reading them; those no longer used are reused.
struct PageWatch::Range {
    std::atomic<std::uintptr_t> first{0}, last{0};  // [first, last)
    std::atomic<bool> lost{false}, used{true};
    Range* next = nullptr;
};

namespace {

// Signal handlers belong to the process, so what they need is global.
std::atomic<PageWatch::Range*> ranges{nullptr};
std::uintptr_t pageBytes = 0;
struct sigaction before {};

static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "the handler may take no locks");

// Returns false if the address is not watched, or the system refuses other pages.
bool replacePages(std::uintptr_t at) {
    for (PageWatch::Range* range = ranges; range != nullptr; range = range->next) {
        const std::uintptr_t last = range->last;
        if (at < range->first || at >= last) continue;
        // First, so that whoever reads a zero finds the flag set afterwards.
        range->lost = true;
        // To the end at once: mappings of single pages would exceed the number that the system allows.
        const std::uintptr_t page = at / pageBytes * pageBytes;
        return ::mmap(reinterpret_cast<void*>(page), last - page, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED, -1, 0) != MAP_FAILED;
    }
    return false;
}

void onBusError(int number, siginfo_t* info, void* context) {
    const int error = errno;
    const bool replaced = info->si_code > 0 && replacePages(reinterpret_cast<std::uintptr_t>(info->si_addr));
    errno = error;
    if (replaced) return;
    if ((before.sa_flags & SA_SIGINFO) != 0) return before.sa_sigaction(number, info, context);
    if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) return before.sa_handler(number);
    ::signal(number, SIG_DFL);
    ::raise(number);  // takes effect when this handler returns
}

bool install() {
    pageBytes = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    ::sigaction(SIGBUS, nullptr, &before);
    struct sigaction action {};
    action.sa_sigaction = onBusError;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(SIGBUS, &action, nullptr);
    return true;
}

PageWatch::Range* freeRange() {
    for (PageWatch::Range* range = ranges; range != nullptr; range = range->next) {
        bool used = false;
        if (range->used.compare_exchange_strong(used, true)) return range;
    }
    auto* const made = new PageWatch::Range;
    made->next = ranges;
    while (!ranges.compare_exchange_weak(made->next, made)) {
    }
    return made;
}

}  // namespace

PageWatch::PageWatch(void* first, std::size_t bytes) {
    [[maybe_unused]] static const bool installed = install();
    range_ = freeRange();
    range_->lost = false;
    const auto begin = reinterpret_cast<std::uintptr_t>(first);
    // In this order: the handler of another thread sees an empty range until both are there.
    range_->first = begin;
    range_->last = begin + (bytes + pageBytes - 1) / pageBytes * pageBytes;
}

PageWatch::~PageWatch() {
    range_->last = 0;
    range_->first = 0;
    range_->used = false;
}

bool PageWatch::lost() const {
    return range_->lost;
}

}  // namespace relief
