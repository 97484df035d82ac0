#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "base/memory.h"

int main(int argc, char** argv)
{
    multipath::keep_freed_memory(); // as the program does
    return doctest::Context(argc, argv).run();
}
