#include "sweep_fixture.h"

namespace relief::test {

pid_t SweepTest::start(const std::vector<std::string>& arguments, const std::string& errors,
                       const std::vector<std::string>& launcher) const {
    std::vector<char*> pointers;
    for (const std::string& word : launcher) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(const_cast<char*>(RELIEF_PROGRAM));
    for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO}) dup2(nowhere, descriptor);
    dup2(open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    signal(SIGINT, SIG_DFL);
    execvp(pointers.front(), pointers.data());
    _exit(127);
}

}  // namespace relief::test
