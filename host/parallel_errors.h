#pragma once
// Parallel loops that collect the errors of all iterations.

#include "error.h"

#include <tbb/parallel_for.h>

#include <cstddef>
#include <string>
#include <vector>

namespace eikonal {

/// Calls f(i) for 0 <= i < count in parallel; an error does not stop the others. Throws one Error (ExitCode::scene) with the messages of
/// all Errors thrown, one per line, in the order of i.
template <class F> void forEachInParallel(std::size_t count, const F& f) {
    std::vector<std::string> errors(count);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        try {
            f(i);
        } catch (const Error& error) {
            errors[i] = error.what();
        }
    });
    std::string all;
    for (const std::string& error : errors)
        if (!error.empty()) all += (all.empty() ? "" : "\n") + error;
    if (!all.empty()) throw Error(ExitCode::scene, all);
}

}  // namespace eikonal
