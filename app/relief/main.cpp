#include <unistd.h>

#include <exception>
#include <new>

#include "program.h"
#include "session.h"

namespace {

// Destructors of libraries allocate (nlohmann-json), and objects are made before main(): there, memory that ends cannot
// be caught.
struct TerminateHandler {
    static inline std::terminate_handler before;

    TerminateHandler() { before = std::set_terminate(end); }
    [[noreturn]] static void end() {
        try {
            if (std::current_exception()) std::rethrow_exception(std::current_exception());
        } catch (const std::bad_alloc&) {
            _exit(relief::app::sayMemoryEnded());
        } catch (...) {
        }
        before();
        __builtin_unreachable();  // a terminate handler does not return
    }
};
// Made before all other objects, which have lower priorities.
[[gnu::init_priority(101)]] const TerminateHandler terminateHandler;

}  // namespace

int main(int count, char** arguments) {
    return relief::app::runProgram(count, arguments);
}
