// Writes the table of smooth reflectances as a C++ list at build time: fit_uplift FILE

#include "color/uplift.h"

#include <cstdio>

int main(int count, char** arguments) {
    std::FILE* file = count == 2 ? std::fopen(arguments[1], "w") : nullptr;
    if (!file) {
        std::fprintf(stderr, "usage: fit_uplift FILE, a file that can be written\n");
        return 2;
    }
    for (float c : eikonal::fitUpliftTable()) std::fprintf(file, "%#.9gf,\n", static_cast<double>(c));
    return std::fclose(file) == 0 ? 0 : 1;
}
