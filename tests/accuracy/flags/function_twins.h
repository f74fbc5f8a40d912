#pragma once
// Device functions beside the same mathematics in long double.

#include "flags/ulps.h"

#include <string>
#include <vector>

namespace eikonal {

/// The differences of one device function, built with one set of math flags.
struct FunctionFigures {
    std::string function, flags;
    UlpTally fromTwin;   ///< from long double
    UlpTally fromFirst;  ///< from the same function built with the first set of flags
};

/// Every function of the list in function_twins.cpp, built with each set of flags and run on the same 100,000 inputs.
std::vector<FunctionFigures> compareFunctions(const std::vector<std::string>& flagSets);

}  // namespace eikonal
