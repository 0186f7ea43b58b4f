#include "program.h"

int main(int count, char** arguments) {
    return relief::app::runProgram(count, arguments);
}
