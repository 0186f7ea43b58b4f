#include "program.h"

int main(int count, char** arguments) {
    return relief::app::programMain(count, arguments);
}
