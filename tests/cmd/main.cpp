#include <gtest/gtest.h>

#include "program_server.h"

int main(int count, char** arguments) {
    relief::test::startProgramServer();
    testing::InitGoogleTest(&count, arguments);
    return RUN_ALL_TESTS();
}
