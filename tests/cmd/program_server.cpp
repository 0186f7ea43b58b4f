#include "program_server.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

#include <nlohmann/json.hpp>

#include "mapping/rows/row_lanes.h"
#include "program.h"

extern char** environ;

namespace relief::test {

namespace {

int server = -1;

bool sendAll(int to, const void* bytes, std::size_t size) {
    const auto* from = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t sent = send(to, from, size, MSG_NOSIGNAL);
        if (sent <= 0) return false;
        from += sent, size -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool receiveAll(int from, void* bytes, std::size_t size) {
    return size == 0 || recv(from, bytes, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

[[noreturn]] void runHere(const nlohmann::json& run) {
    const auto file = [&](const char* name) { return run.at(name).get<std::string>(); };
    dup2(open(file("input").c_str(), O_RDONLY), STDIN_FILENO);
    dup2(open(file("output").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(file("errors").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (const auto largest = run.at("largest").get<std::int64_t>(); largest >= 0) {
        const rlimit limit{static_cast<rlim_t>(largest), static_cast<rlim_t>(largest)};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    clearenv();
    for (const auto& variable : run.at("environment")) {
        const auto text = variable.get<std::string>();
        const std::size_t equals = text.find('=');
        setenv(text.substr(0, equals).c_str(), text.substr(equals + 1).c_str(), 1);
    }
    // One instruction set for all SIMD versions (lane target of row_lanes.h).
    if (const char* const target = std::getenv("RELIEF_TEST_TARGET")) forceLaneTarget(std::atoll(target));
    std::vector<std::string> words{"relief"};
    for (const auto& argument : run.at("arguments")) words.push_back(argument.get<std::string>());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int status = app::runProgram(static_cast<int>(words.size()), pointers.data());
    std::cout.flush();
    std::fflush(nullptr);
    // Not exit(): log4cplus, which OpenImageIO loads, starts a thread when it is loaded, and its destructor would wait
    // for that thread, which does not exist in the forked process.
    _exit(status);
}

[[noreturn]] void serve(int requests) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (;;) {
        std::size_t size = 0;
        if (!receiveAll(requests, &size, sizeof size)) _exit(0);
        std::vector<std::uint8_t> bytes(size);
        if (!receiveAll(requests, bytes.data(), size)) _exit(0);
        const pid_t child = fork();
        if (child == 0) {
            close(requests);
            runHere(nlohmann::json::from_cbor(bytes));
        }
        int status = -1;
        waitpid(child, &status, 0);
        if (!sendAll(requests, &status, sizeof status)) _exit(0);
    }
}

}  // namespace

void startProgramServer() {
    int ends[2] = {-1, -1};
    const bool paired = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0;
    const pid_t child = paired ? fork() : -1;
    if (child < 0) {
        std::perror("program server");
        std::abort();
    }
    if (child == 0) {
        close(ends[0]);
        serve(ends[1]);
    }
    close(ends[1]);
    server = ends[0];
}

int runByServer(const ProgramRun& run) {
    nlohmann::json request{{"arguments", run.arguments},
                           {"input", run.input},
                           {"output", run.output},
                           {"errors", run.errors},
                           {"largest", run.largestFile}};
    for (char** variable = environ; *variable != nullptr; ++variable) request["environment"].push_back(*variable);
    // If a name is given twice, the later value takes effect.
    for (const auto& [name, value] : run.variables) request["environment"].push_back(name + "=" + value);
    // Not text: file names need not be valid UTF-8.
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(request);
    const std::size_t size = bytes.size();
    int status = -1;
    if (!sendAll(server, &size, sizeof size) || !sendAll(server, bytes.data(), size)) return -1;
    return receiveAll(server, &status, sizeof status) ? status : -1;
}

}  // namespace relief::test
